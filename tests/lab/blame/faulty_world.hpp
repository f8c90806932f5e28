#pragma once
/// The exact engine with one fault that is known: what it does wrong, and by how much.

#include <memory>

#include "lab/contenders/engines.hpp"
#include "world/refusal.hpp"
#include "world/world.hpp"

namespace flipside::lab {

class FaultyWorld final : public World {
  public:
    enum class Does {
        nothing,
        turn_normal,
        weaken,
        delay,
        rub,
        pass,      // what it meets, though its broad phase lists the pair
        overlook,  // the same, and it lists no pair
        open_gate,
        bounce_off_nothing,
        refuse,
        forget_flipper
    };

    /// `amount`: rad, share of the impulse, s, m/s; `at`: s, for what happens at no impact.
    FaultyWorld(std::shared_ptr<const Scene> scene, Does does, double amount = 0, double at = 0)
        : scene_(std::move(scene)), does_(does), amount_(amount), at_(at) {
        const Engine& engine = engine_named("reference");
        exact_ = engine.make(scene_, settings_for(engine, *scene_));
    }

    void step(double dt) override {
        const State before = exact_->save();
        exact_->step(dt);
        events_.assign(exact_->events().begin(), exact_->events().end());
        State after = exact_->save();
        after.origin.reset();
        Ball& ball = after.balls.front();
        const double end = after.clock.time;
        if (does_ == Does::refuse && end > at_) throw Refusal("faulty: it is told to");
        if (does_ == Does::bounce_off_nothing && end > at_ && before.clock.time <= at_) {
            ball.velocity = -ball.velocity;
            events_.push_back({end, EventKind::impact, 0, Other::part(0), ball.position, {0, 1}, 2, 4});
        }
        std::erase_if(events_, [](const Event& event) { return event.kind != EventKind::impact; });
        if (!events_.empty()) spoil(events_.front(), before.balls.front(), ball, dt, end);
        if (does_ == Does::forget_flipper) after.parts[0].angle = before.parts[0].angle;
        if (does_ == Does::open_gate) after.parts[0].open = true;
        if (passes()) events_.clear();
        if (trace_ != nullptr) write_trace();
        exact_->restore(after);
    }
    void apply(const Control& control) override { exact_->apply(control); }
    BallNumber add(const Ball& ball) override { return exact_->add(ball); }
    bool remove(BallNumber number) override { return exact_->remove(number); }
    [[nodiscard]] Clock clock() const override { return exact_->clock(); }
    [[nodiscard]] std::span<const Ball> balls() const override { return exact_->balls(); }
    [[nodiscard]] std::span<const PartState> parts() const override { return exact_->parts(); }
    [[nodiscard]] std::span<const Event> events() const override { return events_; }
    [[nodiscard]] std::span<const Contact> contacts() const override { return {}; }
    [[nodiscard]] const Statistics& statistics() const override { return exact_->statistics(); }
    [[nodiscard]] State save() const override { return exact_->save(); }
    void restore(const State& state) override { exact_->restore(state); }
    void inspect(Inspector&) const override {}
    void trace(Trace* trace) override { trace_ = trace; }

  private:
    [[nodiscard]] bool passes() const {
        return does_ == Does::pass || does_ == Does::overlook || does_ == Does::open_gate;
    }
    void write_trace() {
        trace_->stages.clear();
        TraceStage& stage = trace_->stage("broad phase", "FaultyWorld");
        if (does_ != Does::overlook) stage.add("pair").with("ball", 0U).with_other(Other::part(0), *scene_);
    }
    void spoil(Event& impact, const Ball& before, Ball& ball, double dt, double end) {
        const double jump = impact.impulse / ball.mass, since = end - impact.time;
        const auto change = [&](Vec2 velocity) {
            ball.velocity += velocity;
            ball.position += since * velocity;
        };
        switch (does_) {
            case Does::turn_normal: {
                const Vec2 turned = rotated(impact.normal, amount_);
                // The same law along another normal.
                const double factor = jump / impact.speed;
                change(-factor * dot(before.velocity, turned) * turned - jump * impact.normal);
                impact.normal = turned;
                break;
            }
            case Does::weaken:
                change(-amount_ * jump * impact.normal);
                impact.impulse *= 1 - amount_;
                break;
            case Does::delay:
                ball.position -= amount_ * jump * impact.normal;
                impact.time += amount_;
                break;
            case Does::rub:
                change(amount_ * perp(impact.normal));
                break;
            case Does::pass:
            case Does::overlook:
            case Does::open_gate:
                ball = before;
                ball.position += dt * before.velocity;
                break;
            default:
                break;
        }
    }

    std::shared_ptr<const Scene> scene_;
    Does does_;
    double amount_, at_;
    std::unique_ptr<World> exact_;
    std::vector<Event> events_;
    Trace* trace_ = nullptr;
};

}  // namespace flipside::lab
