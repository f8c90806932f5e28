#include "reference/world.hpp"

#include <algorithm>
#include <chrono>
#include <limits>
#include <tuple>

#include "reference/engine.hpp"
#include "world/limits.hpp"
#include "world/refusal.hpp"
#include "world/surface.hpp"

namespace flipside::reference {

namespace {

constexpr double unknown = std::numeric_limits<double>::infinity();
constexpr std::string_view precisions[] = {"53", "113"};

constexpr SettingSpec specs[] = {
    {.name = "precision",
     .type = SettingType::choice,
     .unit = "bits",
     .initial = 0,
     .choices = precisions,
     .about =
         "of all numbers while the world runs (states are saved in 53); 113 costs about fifty times more "
         "and stays true past twice as many impacts",
     .everyday = true},
    {.name = "twin",
     .type = SettingType::toggle,
     .initial = 0,
     .about = "runs a twin of about twice the precision beside it: the digits on which both agree are the "
              "ones that it claims, and the difference is the uncertainty that it reports",
     .everyday = true},
};

}  // namespace

ReferenceWorld::ReferenceWorld(std::shared_ptr<const Scene> scene, const Settings& settings)
    : scene_(std::move(scene)),
      bits_(settings.choice("precision") == "53" ? 53 : 113),
      with_twin_(settings.toggle("twin")),
      table_(scene_),
      balls_(scene_->balls) {}

/// Predictions are delayed until the first step, since a world may be created only to check that it can be.
void ReferenceWorld::load_once() const {
    if (!loaded_) const_cast<ReferenceWorld*>(this)->load();
}

std::span<const Contact> ReferenceWorld::contacts() const {
    load_once();
    return contacts_;
}

std::span<const double> ReferenceWorld::uncertainty() const {
    load_once();
    return uncertainty_;
}

void ReferenceWorld::on_both(auto&& act) {
    if (refusal_) return;
    try {
        act(*exact_);
    } catch (const Refusal& refusal) {
        refusal_ = refusal.what();
        return;
    }
    if (!twin_) return;
    try {
        act(*twin_);
    } catch (const Refusal&) {
        drop_twin();
    }
}

void ReferenceWorld::drop_twin() {
    twin_.reset();
    std::ranges::fill(uncertainty_, unknown);
}

/// Simulations anew from the table and the balls as they are.
void ReferenceWorld::load() {
    loaded_ = true;
    refusal_.reset();
    under_way_ = false;
    unknown_.clear();
    const State state = table_.save(balls_);
    try {
        exact_ = make_exact(bits_, scene_);
        exact_->load(state);
        exact_->contacts(contacts_);
    } catch (const Refusal& refusal) {
        refusal_ = refusal.what();
    }
    twin_.reset();
    uncertainty_.assign(with_twin_ ? balls_.size() : 0, unknown);
    if (!with_twin_ || refusal_) return;
    try {
        twin_ = make_exact(2 * bits_, scene_);
        twin_->load(state);
        measure_uncertainty();
    } catch (const Refusal&) {
        drop_twin();
    }
}

void ReferenceWorld::begin_statistics() {
    statistics_ = {};
    statistics_.event_ordered = true;
    statistics_.solver = bits_ == 53 ? "53 bits" : "113 bits";
}

void ReferenceWorld::restore(const State& state) {
    table_.restore(state);
    balls_ = state.balls;  // which of them sleep is found in the next step
    events_.clear();
    begin_statistics();
    load();
}

void ReferenceWorld::apply(const Control& control) {
    load_once();
    table_.apply(control);
    if (std::holds_alternative<control::Launch>(control)) return;
    if (const auto* nudge = std::get_if<control::Nudge>(&control))
        for (Ball& ball : balls_) ball.velocity += nudge->velocity;
    on_both([&](Exact& exact) { exact.apply(control); });
    if (std::holds_alternative<control::RaiseTargets>(control) && !refusal_) exact_->contacts(contacts_);
}

void ReferenceWorld::certify(Certificate* certificate) {
    load_once();
    if (exact_) exact_->certify(certificate);
}

BallNumber ReferenceWorld::add(const Ball& ball) {
    load_once();
    Ball added = table_.numbered(ball);
    added.asleep = false;
    balls_.push_back(added);
    if (with_twin_) uncertainty_.push_back(twin_ ? 0 : unknown);
    on_both([&](Exact& exact) { exact.add(added); });
    if (!refusal_) exact_->contacts(contacts_);
    return added.number;
}

bool ReferenceWorld::remove(BallNumber number) {
    load_once();
    const auto at = std::ranges::find(balls_, number, &Ball::number);
    if (at == balls_.end()) return false;
    if (with_twin_) uncertainty_.erase(uncertainty_.begin() + (at - balls_.begin()));
    balls_.erase(at);
    std::erase(table_.reported_lost(), number);
    on_both([&](Exact& exact) { exact.remove(number); });
    if (!refusal_) exact_->contacts(contacts_);
    return true;
}

void ReferenceWorld::launch() {
    while (const auto launched = table_.launch(balls_)) {
        if (launched->existing) {
            const Ball& ball = launched->ball;
            *std::ranges::lower_bound(balls_, ball.number, {}, &Ball::number) = ball;
            on_both([&](Exact& exact) { exact.set_velocity(ball.number, ball.velocity); });
        } else {
            const Ball added = table_.numbered(launched->ball);
            balls_.push_back(added);
            if (with_twin_) uncertainty_.push_back(twin_ ? 0 : unknown);
            on_both([&](Exact& exact) { exact.add(added); });
        }
    }
}

void ReferenceWorld::step(double dt) {
    static_cast<void>(step_within(dt, std::numeric_limits<double>::infinity()));
}

bool ReferenceWorld::step_within(double dt, double seconds) {
    using Clock = std::chrono::steady_clock;
    load_once();
    if (refusal_) throw Refusal(*refusal_);
    const auto start = Clock::now();
    if (!under_way_) {
        require_limits("reference", balls_, table_.time());
        under_way_ = true;
        worked_ = 0;
        balls_before_ = balls_;
        table_before_ = table_.save(balls_);
        launch();
        if (exact_) exact_->write_to(trace_);
        if (trace_) trace_->stages.clear();
        on_both([&](Exact& exact) { exact.begin(dt); });
    }
    constexpr double long_enough = 1e6;  // s
    const auto deadline = start + std::chrono::duration_cast<Clock::duration>(
                                      std::chrono::duration<double>(std::min(seconds, long_enough)));
    bool done = true;
    on_both([&](Exact& exact) { done &= exact.run_until(deadline); });
    if (done && !refusal_) read_within_limits(dt);
    worked_ += std::chrono::duration<double>(Clock::now() - start).count();
    if (!done && !refusal_) return false;
    under_way_ = false;
    if (refusal_) {
        balls_ = balls_before_;
        table_.restore(table_before_);
        events_.clear();
        throw Refusal(*refusal_);
    }
    table_.advance(dt);
    report_touches();
    statistics_.stages[0] = {"events", worked_};
    if (trace_) trace_step();
    return true;
}

void ReferenceWorld::trace_step() {
    if (with_twin_) {
        TraceStage& stage = trace_->stage("claim", "src/reference/world.cpp: measure_uncertainty");
        double most = 0;
        for (std::size_t i = 0; i < balls_.size(); ++i) {
            stage.add("claim").with("ball", balls_[i].number).with("uncertainty", uncertainty_[i]);
            most = std::max(most, uncertainty_[i]);
        }
        stage.says = "A twin with twice the digits made the same step: " +
                     (std::isfinite(most) ? "no ball is farther from it than " + brief(most) + " m."
                                          : "the positions of some balls are not known any more.");
    }
    trace_read_out(*trace_, "src/reference/world.cpp: read_out", *this, *scene_);
}

/// Copies the results of the simulation, unless a ball has passed the limits of a world.
void ReferenceWorld::read_within_limits(double dt) {
    read_out(table_.time());
    try {
        require_limits("reference", balls_, table_.time() + dt);
    } catch (const Refusal& refusal) {
        refusal_ = refusal.what();
    }
}

/// Copies the results of the simulation. `started`: start of the step.
void ReferenceWorld::read_out(double started) {
    exact_->read(balls_);
    events_.assign(exact_->events().begin(), exact_->events().end());
    for (Event& event : events_) event.time += started;
    for (PartIndex part = 0; part < scene_->parts.size(); ++part) {
        table_.set_open(part, exact_->open(part));
        table_.set_down(part, exact_->down(part));
    }
    exact_->blocked(table_.blocked());
    table_.reported_lost().assign(exact_->reported_lost().begin(), exact_->reported_lost().end());
    if (with_twin_) measure_uncertainty();

    const Counts& counts = exact_->counts();
    begin_statistics();
    statistics_.pair_tests = counts.pair_tests;
    statistics_.narrow_tests = counts.narrow_tests;
    statistics_.impacts = counts.impacts;
    statistics_.substeps = counts.events;
    statistics_.grazing = counts.grazing;
    statistics_.broad_phase.name = "cells";
    statistics_.asleep = static_cast<std::uint64_t>(std::ranges::count(balls_, true, &Ball::asleep));
}

/// Reports contacts that began or ended in the step.
void ReferenceWorld::report_touches() {
    std::swap(contacts_, contacts_before_);
    exact_->contacts(contacts_);
    const auto key = [](const Contact& c) { return std::tie(c.ball, c.other); };
    const auto before = [&](const Contact& a, const Contact& b) { return key(a) < key(b); };
    const auto report = [&](const auto& these, const auto& those, EventKind kind) {
        for (const Contact& c : these)
            if (!std::binary_search(those.begin(), those.end(), c, before))
                events_.push_back({table_.time(), kind, c.ball, c.other, c.point, c.normal, 0, 0});
    };
    report(contacts_, contacts_before_, EventKind::begin);
    report(contacts_before_, contacts_, EventKind::end);
    std::ranges::sort(events_, [](const Event& a, const Event& b) {
        return std::tie(a.time, a.kind, a.ball, a.other, a.speed) <
               std::tie(b.time, b.kind, b.ball, b.other, b.speed);
    });
    statistics_.contacts = contacts_.size();
}

/// Distance of the reported position from that of the twin, so it includes rounding to 53 bits. Once it has
/// reached a radius, the path of the ball is unknown from then on.
void ReferenceWorld::measure_uncertainty() {
    uncertainty_.assign(balls_.size(), unknown);
    if (!twin_) return;
    constexpr double share_of_twin = 1 + 0x1p-10;
    for (std::size_t i = 0; i < balls_.size(); ++i) {
        const Ball& ball = balls_[i];
        if (std::ranges::find(unknown_, ball.number) != unknown_.end()) continue;
        const double apart = share_of_twin * twin_->distance(ball.number, ball.position);
        if (apart < ball.radius)
            uncertainty_[i] = apart;
        else
            unknown_.push_back(ball.number);
    }
}

void ReferenceWorld::inspect(Inspector& inspector) const {
    load_once();
    if (!exact_) return;
    if (inspector.wants(Topic::boxes))
        for (const Ball& ball : balls_) {
            const Vec2 reach{ball.radius, ball.radius};
            inspector.box(Topic::boxes, {ball.position - reach, ball.position + reach});
        }
    if (inspector.wants(Topic::cells)) {
        std::vector<std::pair<Box, int>> cells;
        exact_->occupied(cells);
        for (const auto& [box, count] : cells) inspector.cell(box, count);
    }
    if (inspector.wants(Topic::pairs)) {
        std::vector<Forecast> forecasts;
        exact_->forecast(forecasts);
        for (const Forecast& forecast : forecasts) {
            for (std::size_t k = 1; k < forecast.way.size(); ++k)
                inspector.segment(Topic::pairs, forecast.way[k - 1], forecast.way[k]);
            if (forecast.touches) inspector.circle(Topic::pairs, forecast.way.back(), forecast.radius);
        }
    }
    if (inspector.wants(Topic::contacts))
        for (const Contact& contact : contacts_) inspector.contact(contact);
}

const Engine& engine() {
    static const Engine reference{
        "reference",
        "exact: events in order of their times, every root certified; slow, and refuses what it cannot do",
        specs, [](std::shared_ptr<const Scene> scene, const Settings& settings) {
            return std::unique_ptr<World>(std::make_unique<ReferenceWorld>(std::move(scene), settings));
        }};
    return reference;
}

}  // namespace flipside::reference
