#pragma once
/// What happened during the last step, read after it; nothing calls back in mid-step.

#include <algorithm>
#include <functional>
#include <span>
#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

#include "world/scene.hpp"

namespace flipside {

/// The other body of a contact: a part of the table or a ball.
struct Other {
    bool is_ball = false;
    std::uint32_t index = 0;  ///< PartIndex or BallNumber

    static constexpr Other part(PartIndex i) { return {false, i}; }
    static constexpr Other ball(BallNumber n) { return {true, n}; }
    friend constexpr auto operator<=>(const Other&, const Other&) = default;
};

enum class EventKind {
    impact,  ///< approach faster than rest_speed (at any speed above 0 if rest_speed is 0)
    begin,   ///< a touch that lasts beyond this step began
    end,     ///< such a touch ended
    sensor_begin,
    sensor_end,
    lost  ///< left the bounds; `other` means nothing
};

constexpr std::string_view name_of(EventKind kind) {
    constexpr std::string_view names[] = {"impact", "begin", "end", "sensor-begin", "sensor-end", "lost"};
    return names[static_cast<int>(kind)];
}

struct Event {
    double time = 0;  ///< s; engines that only know contacts per step give the end of the step
    EventKind kind = EventKind::impact;
    BallNumber ball = 0;  ///< between two balls, the lower number
    Other other;
    Vec2 point;          ///< m, on the surface of `other`
    Vec2 normal;         ///< unit, from other to ball
    double speed = 0;    ///< m/s, approach along the normal before the hit, ≥ 0
    double impulse = 0;  ///< N·s along the normal, ≥ 0

    friend bool operator==(const Event&, const Event&) = default;
};

/// Two surfaces in contact at this instant; cross-validation compares these.
struct Contact {
    BallNumber ball = 0;
    Other other;
    Vec2 point;             ///< m, on the surface of `other`
    Vec2 normal;            ///< unit, from other to ball
    double separation = 0;  ///< m, negative when they overlap
};

/// Keeps the deepest contact of each pair, sorted by ball, then other.
inline void keep_deepest(std::vector<Contact>& contacts) {
    std::ranges::sort(contacts, std::less{}, [](const Contact& c) {
        return std::tie(c.ball, c.other, c.separation, c.normal.x, c.normal.y, c.point.x, c.point.y);
    });
    const auto same_pair = [](const Contact& a, const Contact& b) {
        return a.ball == b.ball && a.other == b.other;
    };
    contacts.erase(std::unique(contacts.begin(), contacts.end(), same_pair), contacts.end());
}

/// How deep the deepest of these overlaps, m; 0 where none does.
[[nodiscard]] inline double deepest_overlap(std::span<const Contact> contacts) {
    double deepest = 0;
    for (const Contact& contact : contacts) deepest = std::max(deepest, -contact.separation);
    return deepest;
}

}  // namespace flipside
