#pragma once
/// A scene run by a foreign engine, in a process of its own.
///
/// Here are the clock, the controls, the moving parts, launches, lost balls and drop targets; there the balls
/// move. Nothing that comes from there is taken as it is: what the interface does not allow ends the run, as
/// does the end of the process. The world is then as it was before the step.

#include <memory>
#include <optional>
#include <vector>

#include "flipside/engine.h"
#include "plugin/description.hpp"
#include "plugin/process.hpp"
#include "world/step_guard.hpp"
#include "world/surface.hpp"
#include "world/table.hpp"
#include "world/world.hpp"

namespace flipside::plugin {

/// A library, and what it is called here.
struct Plugin;

class PluginWorld : public World {
  public:
    /// Throws InputError for a scene that the engine cannot run, Refusal where its process ends.
    PluginWorld(std::shared_ptr<const Scene> scene, const Plugin& plugin, const Settings& settings);

    void step(double dt) override;
    void apply(const Control& control) override;
    BallNumber add(const Ball& ball) override;
    bool remove(BallNumber number) override;

    [[nodiscard]] Clock clock() const override { return table_.clock(); }
    [[nodiscard]] bool launch_waiting() const override { return table_.launch_waiting(); }
    [[nodiscard]] std::span<const Ball> balls() const override { return balls_; }
    [[nodiscard]] std::span<const PartState> parts() const override { return table_.parts(); }
    [[nodiscard]] std::span<const Event> events() const override { return events_; }
    [[nodiscard]] std::span<const Contact> contacts() const override { return contacts_; }
    [[nodiscard]] const Statistics& statistics() const override { return statistics_; }

    [[nodiscard]] State save() const override;
    void restore(const State& state) override;
    void inspect(Inspector& inspector) const override;
    void trace(Trace* trace) override { trace_ = trace; }

  private:
    void set_state(const State& state);
    void make(std::string_view saved = {});
    [[nodiscard]] std::string engine_bytes() const;
    void make_step(double dt);
    void launch();
    void change(flipside_control_kind kind, const Ball& ball);
    void change(const flipside_control& control);
    void show(PartIndex target, bool there);
    [[nodiscard]] Answer ask(Ask kind) const;
    void take_answer(double dt);
    void take_balls(std::span<const flipside_ball_state> moved);
    void take_events(std::span<const flipside_event> events, double start);
    [[nodiscard]] bool take_gate(const flipside_event& event);
    void take_contacts(std::span<const flipside_contact> contacts);
    [[nodiscard]] Other other_of(std::uint32_t is_ball, std::uint32_t index, std::uint32_t ball,
                                 const char* what) const;
    void report_lost();
    void measure(double cpu_seconds);
    void trace_step(std::span<const Ball> before, double dt, std::size_t changes);
    [[nodiscard]] std::vector<Ball>::iterator find(BallNumber number);
    [[nodiscard]] bool is_there(BallNumber number) const;
    [[noreturn]] void refuse(const std::string& why) const;

    const Plugin& plugin_;
    std::vector<double> settings_;
    Table table_;
    std::vector<Primitive> primitives_;
    std::vector<Ball> balls_;  ///< by rising number
    std::vector<Event> events_;
    std::vector<Contact> contacts_;
    Statistics statistics_;
    Trace* trace_ = nullptr;
    StepGuard guard_;

    mutable std::unique_ptr<Process> process_;
    mutable Bytes answer_;
    mutable bool stale_ = true;  ///< the engine's world must be made anew before the next step
    bool knows_json_ = false;    ///< the process has the scene's text
    mutable std::vector<flipside_control> changes_;  ///< since the last step, of a world that is not stale
    mutable Bytes question_;
    std::vector<flipside_motion> motions_;
    std::vector<flipside_ball_state> moved_;
    std::vector<flipside_event> foreign_events_;
    std::vector<flipside_contact> foreign_contacts_;
};

}  // namespace flipside::plugin
