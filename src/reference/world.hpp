#pragma once
/// The exact engine's world: a simulation of the chosen precision behind the World interface and, if wanted,
/// a twin of about twice the precision beside it. Both get the same start and the same controls. How far they
/// are apart is what the first may not claim to know.

#include <optional>
#include <string>

#include "reference/exact.hpp"
#include "world/settings.hpp"
#include "world/table.hpp"
#include "world/world.hpp"

namespace flipside::reference {

class ReferenceWorld final : public World {
  public:
    ReferenceWorld(std::shared_ptr<const Scene> scene, const Settings& settings);

    void step(double dt) override;
    bool step_within(double dt, double seconds) override;
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
    [[nodiscard]] std::span<const double> uncertainty() const override;

    [[nodiscard]] State save() const override { return table_.save(balls_); }
    void restore(const State& state) override;
    void inspect(Inspector& inspector) const override;
    void trace(Trace* trace) override { trace_ = trace; }
    /// Writes from now on, at a moment between steps, what every ball does and why. The world keeps the
    /// pointer.
    void certify(Certificate* certificate);

  private:
    /// Calls `act` on the simulation and on its twin. Where the simulation refuses, the refusal is kept for
    /// the next step; a twin that refuses is given up.
    void on_both(auto&& act);
    void drop_twin();
    void launch();
    void read_within_limits(double dt);
    void read_out(double started);
    void report_touches();
    void trace_step();
    void measure_uncertainty();
    void begin_statistics();
    void load();
    void load_once() const;

    std::shared_ptr<const Scene> scene_;
    int bits_;
    bool with_twin_;
    Table table_;
    bool loaded_ = false;  ///< the simulations are there; from the first use on
    std::unique_ptr<Exact> exact_, twin_;
    std::vector<Ball> balls_;
    std::vector<Event> events_;
    std::vector<Contact> contacts_, contacts_before_;
    std::vector<double> uncertainty_;
    std::vector<BallNumber> unknown_;  ///< balls that once were further apart than a radius
    Statistics statistics_;
    Trace* trace_ = nullptr;
    std::optional<std::string> refusal_;
    bool under_way_ = false;  ///< a step has begun and not ended
    double worked_ = 0;       ///< on it so far, s
    std::vector<Ball> balls_before_;
    State table_before_;
};

}  // namespace flipside::reference
