#pragma once
/// All that changed the course of a session from outside, in order, so that it can be run again to the bit:
/// what a player and a script did, what a hand did to its balls, and changes of engine, settings, gravity and
/// step. What the rules of the game do follows from it.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "lab/session/ball_edit.hpp"
#include "world/engine.hpp"

namespace flipside::lab {

namespace move {

/// A player's control, applied between steps.
struct Press {
    double time = 0;  ///< of the world, s
    Control control;
};
/// A control of a script. The step in which its time falls is split there.
struct Scripted {
    TimedControl timed;
};
struct Edit {
    BallEdit edit;
};
/// Every ball is taken off the table, and those that wait to be launched.
struct Clear {};
/// Another engine, other settings or another gravity. The state stays.
struct Change {
    const Engine* engine;
    Settings settings;
    Vec2 gravity;  ///< m/s²
};
/// All steps from here on have this length.
struct StepLength {
    double dt = 0;  ///< s
};
/// The state was saved and restored, as when a moment of the past is gone on from. An engine whose
/// Engine::restores_exactly is false goes on in another way then.
struct Resume {};
/// The engine refused its step (refusal.hpp).
struct Refused {};
/// Not a change: what checksum_of() gave here.
struct Check {
    std::uint64_t checksum = 0;
};

}  // namespace move

using Move = std::variant<move::Press, move::Scripted, move::Edit, move::Clear, move::Change,
                          move::StepLength, move::Resume, move::Refused, move::Check>;

/// Snapshots copy it often, and most of it is the same in all of them. So it is a list from the end, whose
/// copies share what they have in common.
class Recording {
  public:
    struct Entry {
        std::uint64_t step = 0;  ///< how many whole steps came before
        Move move;
    };
    /// Of a session at the beginning of the scene, as that is on that engine.
    Recording(const Engine& engine, Settings settings, Vec2 gravity);
    ~Recording() { drop(); }
    Recording(const Recording&) = default;
    Recording& operator=(const Recording& other);
    Recording(Recording&&) = default;
    Recording& operator=(Recording&& other) noexcept;

    void add(Move move);
    /// The next step has that length, s.
    void begin_step(double dt);
    void end_step() { ++steps_; }
    /// It cannot be run again any more. The first reason stays.
    void spoil(const std::string& reason);

    [[nodiscard]] const move::Change& start() const { return *start_; }
    [[nodiscard]] std::vector<Entry> entries() const;
    /// Every control, at times that do not fall. A run by this script alone has the same bits where nothing
    /// else happened.
    [[nodiscard]] Script controls() const;
    [[nodiscard]] std::uint64_t steps() const { return steps_; }
    [[nodiscard]] const std::optional<std::string>& spoiled() const { return spoiled_; }

  private:
    struct Link {
        Entry entry;
        std::shared_ptr<Link> before;
    };
    /// One by one: a long list must not be destroyed by recursion.
    void drop() noexcept;

    std::shared_ptr<const move::Change> start_;
    std::shared_ptr<Link> last_;
    std::size_t size_ = 0;
    std::uint64_t steps_ = 0;
    double dt_ = 0;  ///< of the last StepLength
    std::optional<std::string> spoiled_;
};

}  // namespace flipside::lab
