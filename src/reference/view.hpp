#pragma once
/// Motion of parts, and the path of a ball in the frame of a part, in which the part has the pose of the
/// scene file.

#include "reference/path.hpp"

namespace flipside::reference {

/// How a part moves from now on, until a control changes it.
template <class R>
struct Turning {
    V<R> pivot;
    R since{}, angle{}, rate{};  ///< s, rad, rad/s
    R stop = infinity<R>();      ///< s: when it reaches its stop
    R goal{};                    ///< rad, at the stop

    [[nodiscard]] R angle_at(const R& time) const {
        if (rate == 0) return angle;
        return time >= stop ? goal : angle + rate * (time - since);
    }
};

template <class R>
struct View {
    const Path<R>& path;
    const Turning<R>* turning;  ///< null for a static part

    [[nodiscard]] Motion<R> at(const R& time) const {
        Motion<R> now = path.at(time);
        if (turning == nullptr) return now;
        const V<R> turn = from_angle(turning->angle_at(time)), arm = now.position - turning->pivot;
        return {turning->pivot + unrotated(arm, turn),
                unrotated(now.velocity - cross(turning->rate, arm), turn)};
    }
    /// |q''| ≤ |a| + 2|ω||v| + ω²|p − c|.
    [[nodiscard]] Bounds<R> bounds(const R& from, const R& until) const {
        Bounds<R> own = path.bounds(from, until);
        if (turning == nullptr) return own;
        const R w = magnitude(turning->rate);
        const R far = length(path.at(from).position - turning->pivot) + own.speed * (until - from);
        return {own.speed + w * far, own.acceleration + 2 * w * own.speed + w * w * far};
    }
};

}  // namespace flipside::reference
