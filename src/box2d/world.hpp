#pragma once
/// A scene run by Box2D.
///
/// Box2D holds the balls in single precision and in its own units; between steps the balls in double are
/// what counts, so a state that is restored reads back to the bit until the next step.

#include <memory>
#include <vector>

#include <box2d/b2_body.h>
#include <box2d/b2_world.h>

#include "box2d/contact_rules.hpp"
#include "box2d/options.hpp"
#include "box2d/touching.hpp"
#include "world/step_guard.hpp"
#include "world/table.hpp"
#include "world/world.hpp"

namespace flipside::box2d {

class Box2dWorld : public World {
  public:
    /// Throws InputError for a scene that does not fit into single precision.
    Box2dWorld(std::shared_ptr<const Scene> scene, const Options& options);
    Box2dWorld(const Box2dWorld&) = delete;
    Box2dWorld(Box2dWorld&&) = delete;
    Box2dWorld& operator=(const Box2dWorld&) = delete;
    Box2dWorld& operator=(Box2dWorld&&) = delete;
    ~Box2dWorld() override = default;

    void step(double dt) override;
    void apply(const Control& control) override;
    BallNumber add(const Ball& ball) override;
    bool remove(BallNumber number) override;

    [[nodiscard]] Clock clock() const override { return table_.clock(); }
    [[nodiscard]] bool launch_waiting() const override { return table_.launch_waiting(); }
    [[nodiscard]] std::span<const Ball> balls() const override { return balls_; }
    [[nodiscard]] std::span<const PartState> parts() const override { return table_.parts(); }
    [[nodiscard]] std::span<const Event> events() const override { return events_; }
    [[nodiscard]] std::span<const Contact> contacts() const override;
    [[nodiscard]] const Statistics& statistics() const override { return statistics_; }

    [[nodiscard]] State save() const override { return table_.save(balls_); }
    void restore(const State& state) override;
    void inspect(Inspector& inspector) const override;
    void trace(Trace* trace) override { trace_ = trace; }

  private:
    /// Box2D does not say how many boxes it tests.
    [[nodiscard]] static Statistics uncounted() {
        Statistics statistics;
        statistics.counts_pair_tests = false;
        return statistics;
    }
    void build();  ///< a fresh Box2D world from the table's parts and balls_
    void add_part(PartIndex part);
    void add_body(const Ball& ball);
    [[nodiscard]] bool begins_in_gate(PartIndex gate, const Ball& ball) const;
    void remove_at(std::size_t place);
    [[nodiscard]] std::size_t place_of(BallNumber number) const;  ///< balls_.size() if there is none
    void find_pairs();  ///< of what was added or moved since the last step
    void look() const;

    void make_step(double dt);
    void launch();
    void substep(double from, double to);
    void fall(double h);
    void fall_after(double h);
    void gain(b2Body& body, double h);
    void read_back();

    void report(EventKind kind, const Contact& contact);
    void leave_gates();
    void enter_gates();
    void report_sensors();
    void report_impacts();
    void report_touches();
    void report_lost();
    void measure();
    [[nodiscard]] bool comes_or_goes(const Contact& contact) const;

    Options options_;
    Units units_;
    Table table_;
    std::vector<Ball> balls_;      ///< by rising number
    std::vector<b2Body*> bodies_;  ///< of balls_
    std::vector<b2Body*> parts_;   ///< of the scene's parts
    std::vector<PartIndex> moving_, gates_;
    ContactRules rules_;
    std::unique_ptr<b2World> world_;
    mutable Touching touching_;
    mutable bool looked_ = false;         ///< touching_ is up to date
    std::vector<b2Vec2> before_;          ///< of bodies_, at the start of the sub-step
    std::vector<double> ahead_;           ///< s of gravity that each of bodies_ gets ahead of the solver
    std::vector<BallOnPart> on_sensors_;  ///< reported as begun
    std::vector<Contact> held_;           ///< touches reported as begun
    std::vector<Contact> still_held_;     ///< held_ of the step in hand; kept for its memory
    std::vector<Event> events_;
    Statistics statistics_ = uncounted();
    Trace* trace_ = nullptr;
    StepGuard guard_{"box2d"};
};

}  // namespace flipside::box2d
