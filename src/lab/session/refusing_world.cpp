#include "lab/session/refusing_world.hpp"

#include "world/input_error.hpp"
#include "world/refusal.hpp"
#include "world/table.hpp"

namespace flipside::lab {

namespace {

class RefusingWorld : public World {
  public:
    RefusingWorld(const std::shared_ptr<const Scene>& scene, std::string why)
        : table_(scene), balls_(scene->balls), why_(std::move(why)) {}

    void step(double /*dt*/) override { throw Refusal(why_); }
    void apply(const Control& control) override { table_.apply(control); }
    BallNumber add(const Ball& ball) override {
        balls_.push_back(table_.numbered(ball));
        return balls_.back().number;
    }
    bool remove(BallNumber number) override {
        return std::erase_if(balls_, [&](const Ball& ball) { return ball.number == number; }) > 0;
    }
    [[nodiscard]] Clock clock() const override { return table_.clock(); }
    [[nodiscard]] std::span<const Ball> balls() const override { return balls_; }
    [[nodiscard]] std::span<const PartState> parts() const override { return table_.parts(); }
    [[nodiscard]] std::span<const Event> events() const override { return {}; }
    [[nodiscard]] std::span<const Contact> contacts() const override { return {}; }
    [[nodiscard]] const Statistics& statistics() const override { return statistics_; }
    [[nodiscard]] State save() const override { return table_.save(balls_); }
    void restore(const State& state) override {
        table_.restore(state);
        balls_ = state.balls;
    }
    void inspect(Inspector& /*inspector*/) const override {}
    void trace(Trace* /*trace*/) override {}

  private:
    Table table_;
    std::vector<Ball> balls_;
    std::string why_;
    Statistics statistics_;
};

}  // namespace

std::unique_ptr<World> world_or_refusal(const Engine& engine, const std::shared_ptr<const Scene>& scene,
                                        const Settings& settings) {
    try {
        return engine.make(scene, settings);
    } catch (const InputError& error) {
        return std::make_unique<RefusingWorld>(scene, error.what());
    } catch (const Refusal& refusal) {
        return std::make_unique<RefusingWorld>(scene, refusal.what());
    }
}

}  // namespace flipside::lab
