#pragma once
/// A run of one scene on one engine: the world, the game on it, and the recording of what was done to it.
/// The command line, the window and the tests all run worlds through this, so they mean the same by it.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "lab/game/game.hpp"
#include "lab/session/recording.hpp"
#include "world/engine.hpp"

namespace flipside::lab {

/// Sums over all steps of a session.
struct Totals {
    std::uint64_t steps = 0;  ///< calls of Session::step; one that was split at a control counts once
    double step_seconds = 0;  ///< CPU time in World::step alone
    std::uint64_t pair_tests = 0, narrow_tests = 0, contacts = 0, handed_over = 0;  ///< as in Statistics
    std::uint64_t impacts = 0;
    std::uint64_t launched = 0;
    std::uint64_t lost = 0;
    std::uint64_t strays = 0;    ///< lost, but not through the lower edge of a scene with rules (its drain)
    double max_penetration = 0;  ///< m, deepest at the end of any step
    /// By World::step after the first `warm_up_steps` steps. An engine's lists grow when balls join, and a
    /// launch is part of a step: where more balls are launched than ever before, it counts here.
    std::uint64_t allocations = 0;
};
inline constexpr std::uint64_t warm_up_steps = 60;
/// Steps between two move::Check of a recording.
inline constexpr std::uint64_t steps_between_checks = 600;

/// If an engine cannot run a scene: pass its exception on, or continue with a world that refuses its first
/// step (refusing_world.hpp), for programs that show several engines at once.
enum class WithoutWorld { fail, refuse_steps };

class Session {
  public:
    Session(std::shared_ptr<const Scene> scene, const Engine& engine, Settings settings,
            WithoutWorld otherwise = WithoutWorld::fail);

    /// Applies a control now and records it.
    void apply(const Control& control);
    /// The same if the rules of the game permit it; false if they do not.
    bool press(const Control& control);
    /// One step of the world, then the rules' answer to what happened in it.
    void step(double dt);
    /// Advances by dt, split so that every control of the script in [time, time + dt) is applied at its own
    /// time; one within 1e-9·dt of either end counts as at that end. `next` is the index of the script's
    /// next control and is moved on. Events of all parts of the step are in events().
    void step(double dt, const Script& script, std::size_t& next);
    /// The same in portions, as World::step_within has it. Until it is true, controls must wait.
    [[nodiscard]] bool step_within(double dt, const Script& script, std::size_t& next, double seconds);
    /// Continues from the state that edited() (ball_edit.hpp) gives for what a hand does to the balls.
    void edit(const BallEdit& edit, const State& edited);
    /// Takes every ball off the table, and those that wait to be launched.
    void clear();
    /// Saves the state and restores it, as move::Resume has it.
    void resume();
    /// Continues on another engine, with other settings, or on the same scene with another gravity from
    /// the state as it is. The game goes on.
    void change(std::shared_ptr<const Scene> scene, const Engine& engine, Settings settings);
    /// Continues from a state of the same scene. The game goes on with the balls that it has. The recording
    /// knows nothing of that state: it is spoiled.
    void restore(const State& state);
    /// All of a session at a moment between steps.
    struct Snapshot {
        std::shared_ptr<const Scene> scene;
        const Engine* engine;
        Settings settings;
        State state;
        Game game;
        Recording recording;
        Totals totals;
        std::vector<Event> events;  ///< to be read as those of the last step
    };
    [[nodiscard]] Snapshot snapshot(std::span<const Event> events) const {
        return {scene_, engine_,    settings_, world_->save(),
                game_,  recording_, totals_,   {events.begin(), events.end()}};
    }
    void restore(const Snapshot& snapshot);
    /// Of a session that has been run again: what was counted the first time, work and CPU time included.
    void recount(const Totals& totals) { totals_ = totals; }
    /// Another session in the same state, score and all, whose totals start at 0.
    [[nodiscard]] Session fork() const {
        Session copy(scene_, *engine_, settings_, otherwise_);
        copy.restore(world_->save());
        copy.game_ = game_;
        copy.recording_ = recording_;
        copy.recording_.add(move::Resume{});
        return copy;
    }

    [[nodiscard]] World& world() { return *world_; }
    [[nodiscard]] const World& world() const { return *world_; }
    [[nodiscard]] const Scene& scene() const { return *scene_; }
    [[nodiscard]] std::shared_ptr<const Scene> shared_scene() const { return scene_; }
    [[nodiscard]] const Engine& engine() const { return *engine_; }
    [[nodiscard]] const Settings& settings() const { return settings_; }
    [[nodiscard]] const Game& game() const { return game_; }
    /// What came from outside (not by the rules) since the start.
    [[nodiscard]] const Recording& recording() const { return recording_; }
    /// Everything that happened during the last step(dt), over all its parts.
    [[nodiscard]] std::span<const Event> events() const { return events_; }
    [[nodiscard]] const Totals& totals() const { return totals_; }
    /// Whether a step has begun and not ended.
    [[nodiscard]] bool under_way() const { return under_way_.has_value(); }

  private:
    /// One World::step_within and, once that is done, the rules' answer, appended to events_ and totals_.
    bool advance(double dt, double seconds);
    /// Does the controls that are due. s from here to the next one, to the launcher's next look or to the end
    /// of the step under way. What is due at the end is left to the next step, which may be that of another
    /// run (next_control()).
    [[nodiscard]] double until_stop(const Script& script, std::size_t& next);
    /// s from here to the launcher's next look, if balls wait for it and that is well before `stop`.
    [[nodiscard]] double until_look(double stop) const;
    void count(const Event& event);
    void hand_over(const Control& control);
    /// The step that is under way is given up.
    void abandon_step();
    void go_on_from(const State& state);

    [[nodiscard]] std::unique_ptr<World> make(const std::shared_ptr<const Scene>& scene, const Engine& engine,
                                              const Settings& settings) const;

    std::shared_ptr<const Scene> scene_;
    const Engine* engine_;
    Settings settings_;
    WithoutWorld otherwise_;
    std::unique_ptr<World> world_;
    Game game_;
    Recording recording_;
    std::vector<Event> events_;
    Totals totals_;
    struct Progress {
        Clock end;           ///< of the step
        double left = 0;     ///< of the step, s
        double portion = 0;  ///< of that, what the world is making, s; 0 between two of them
        bool begun = false;  ///< the world has made one
    };
    std::optional<Progress> under_way_;
};

/// The script's first control at `time` or later (to 1e-9 s): where a run that starts then takes it up.
[[nodiscard]] std::size_t next_control(const Script& script, double time);

/// ½mv² + ½Iω² − m·g·p over all balls, J (gravity's potential is 0 at the origin).
[[nodiscard]] double energy(const World& world, const Scene& scene);

}  // namespace flipside::lab
