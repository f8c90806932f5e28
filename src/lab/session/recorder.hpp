#pragma once
/// The last seconds of a session, to return to. For an engine that continues from a saved state with the same
/// bits (Engine::restores_exactly) a state is kept now and then, and what came after it is run again; of any
/// other engine a state of every moment is kept, so that what was shown is shown again to the bit.

#include <deque>
#include <optional>
#include <span>
#include <vector>

#include "lab/session/session.hpp"

namespace flipside::lab {

class Recorder {
  public:
    static constexpr double longest = 30;              ///< simulated seconds that are kept
    static constexpr double between_snapshots = 0.25;  ///< simulated seconds
    /// CPU seconds of steps that are run again at most to come to a moment, unless a single one is longer.
    static constexpr double dearest_replay = 0.05;
    static constexpr std::size_t most_bytes = 180'000'000;  ///< about; then less than `longest` is kept

    /// How a moment was come to from the one before it.
    struct Way {
        double span = 0;                ///< s
        double dt = 0;                  ///< s, of the steps within it
        std::vector<Control> controls;  ///< applied by the player before it
    };

    /// Forgets everything; the session as it is becomes the first moment, from which it goes on there in the
    /// script.
    void start(const Session& session, std::size_t next_control);
    /// The session has come to a new moment that way, with those events; `next_control` is where it goes on
    /// in the script. Cost: now and then, or always, that of World::save.
    void record(const Session& session, Way way, std::span<const Event> events, std::size_t next_control);
    /// The session was changed where it is: other settings, another engine, balls taken away.
    void changed(const Session& session, std::span<const Event> events);

    /// At least 1 after start().
    [[nodiscard]] std::size_t size() const { return moments_.size(); }
    [[nodiscard]] double time(std::size_t moment) const { return moments_[moment].time; }
    /// The last moment at or before `time`, to 1e-9 s; the first one if there is none.
    [[nodiscard]] std::size_t at(double time) const;
    /// The session becomes what it was at that moment: world, game and totals, to the bit. Returns what
    /// happened on the way from the moment before.
    std::vector<Event> restore(std::size_t moment, Session& session, const Script& script) const;
    /// Of the script, where the session goes on from that moment.
    [[nodiscard]] std::size_t next_control(std::size_t moment) const { return moments_[moment].next_control; }
    void forget_after(std::size_t moment);
    /// An estimate of what is kept, from above.
    [[nodiscard]] std::size_t bytes() const { return bytes_; }

  private:
    struct Moment {
        double time = 0;
        Way way;
        std::size_t next_control = 0;  ///< of the script, after it
        Totals totals;
        std::optional<Session::Snapshot> snapshot;
        std::size_t bytes = 0;
    };
    static constexpr double same_time = 1e-9;  ///< s

    void keep(Moment& moment, const Session& session, std::span<const Event> events);
    /// What is too old, or too much.
    void drop();

    std::deque<Moment> moments_;  ///< the first one has a snapshot
    std::size_t bytes_ = 0;
};

}  // namespace flipside::lab
