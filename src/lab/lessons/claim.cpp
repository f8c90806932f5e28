#include "lab/lessons/claim.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include "lab/contenders/engines.hpp"
#include "lab/lessons/brute_force_gap.hpp"
#include "lab/session/session.hpp"
#include "lab/session/timeline.hpp"
#include "lab/session/traced_step.hpp"
#include "world/input_error.hpp"
#include "world/json_file.hpp"
#include "world/surface.hpp"

namespace flipside::lab {

namespace {

constexpr std::size_t most_balls = 10;  // that have figures of their own

/// A ball, and a part that it touches.
using BallAtPart = std::pair<BallNumber, PartIndex>;

std::string as_name(std::string words) {
    std::ranges::replace_if(
        words, [](char c) { return c == ' ' || c == '-'; }, '_');
    return words;
}

/// "one.deepest" is a length.
std::string_view unit_of_figure(std::string_view name) {
    name.remove_prefix(name.find('.') + 1);
    const auto of_ball = [&](std::string_view letters) {
        return name.starts_with(letters) && name.size() == letters.size() + 1 && name.back() >= '0' &&
               name.back() <= '9';
    };
    if (name.starts_with("energy")) return " J";
    if (of_ball("vx") || of_ball("vy")) return " m/s";
    constexpr std::string_view lengths[] = {"deepest", "highest", "read_out_off", "separation_off"};
    const bool is_length =
        of_ball("x") || of_ball("y") || of_ball("r") || std::ranges::find(lengths, name) != std::end(lengths);
    return is_length ? " m" : "";
}

/// The figures of one run, under its name.
class RunMeasure {
  public:
    RunMeasure(const ClaimRun& run, Figures& figures)
        : run_(run),
          figures_(figures),
          session_(run.scene, *run.on.engine, contender_for(run.on, *run.scene, default_step).settings) {}

    void measure() {
        set("primitives", static_cast<double>(surface_of(*run_.scene).size()));
        set("energy_first", energy(session_.world(), *run_.scene));
        for (const Contact& contact : session_.world().contacts())
            if (!contact.other.is_ball) touching_.emplace_back(contact.ball, contact.other.index);
        set("touching_first", static_cast<double>(touching_.size()));
        if (run_.trace) trace();
        // A traced step may be all there is to the run.
        const double begun = session_.world().time(), rest = std::max(0.0, run_.seconds - begun);
        const Timeline timeline(begun, rest, *run_.on.dt);
        Totals before;
        const Script nothing;
        std::size_t next = 0;
        double highest = -INFINITY;
        for (std::uint64_t k = 0; k < timeline.steps(); ++k) {
            if (session_.world().time() < run_.from + 0.5 * *run_.on.dt) before = session_.totals();
            session_.step(timeline.length(k), nothing, next);
            for (const Ball& ball : session_.world().balls()) highest = std::max(highest, ball.position.y);
        }
        set("highest", highest);
        count(before);
        read_balls();
        if (run_.against_reference) set("error_radii", error());
    }
    /// When the run began, in order.
    [[nodiscard]] const std::vector<BallAtPart>& touching() const { return touching_; }

  private:
    void set(const std::string& name, double value) { figures_[run_.name + '.' + name] = value; }

    void count(const Totals& before) {
        const Totals& now = session_.totals();
        const auto since = [](std::uint64_t a, std::uint64_t b) { return static_cast<double>(a - b); };
        const double steps = since(now.steps, before.steps);
        const double pair_tests = since(now.pair_tests, before.pair_tests);
        const double narrow_tests = since(now.narrow_tests, before.narrow_tests);
        set("steps", steps);
        set("pair_tests", pair_tests);
        set("narrow_tests", narrow_tests);
        set("pair_tests_per_step", pair_tests / std::max(1.0, steps));
        set("narrow_tests_per_step", narrow_tests / std::max(1.0, steps));
        set("contacts", since(now.contacts, before.contacts));
        set("impacts", since(now.impacts, before.impacts));
        set("lost", static_cast<double>(now.lost));
        set("strays", static_cast<double>(now.strays));
        set("balls", static_cast<double>(session_.world().balls().size()));
        set("asleep", static_cast<double>(session_.world().statistics().asleep));
        set("deepest", now.max_penetration);
        set("energy_last", energy(session_.world(), *run_.scene));
    }

    void read_balls() {
        for (const Ball& ball : session_.world().balls()) {
            if (ball.number >= most_balls) break;
            const std::string number = std::to_string(ball.number);
            set("x" + number, ball.position.x);
            set("y" + number, ball.position.y);
            set("vx" + number, ball.velocity.x);
            set("vy" + number, ball.velocity.y);
            set("r" + number, ball.radius);
        }
    }

    /// How many items there are of each kind, how many of each stage have moved a ball, how far the last
    /// stage is from the world, and how far separations are from those of brute force.
    void trace() {
        const Script nothing;
        std::size_t next = 0;
        const TracedStep step = trace_step(session_, *run_.on.dt, nothing, next);
        for (const TraceStage& stage : step.trace.stages) {
            double& moves = figures_[run_.name + '.' + as_name("moves_in_" + stage.name)];
            for (const TraceItem& item : stage.items) {
                ++figures_[run_.name + '.' + as_name(item.kind + "_items")];
                const TraceValue *from = item.find("position_before"), *to = item.find("position");
                moves += from != nullptr && to != nullptr && *from != *to;
            }
        }
        double off = 0;
        std::size_t place = 0;
        for (const TraceItem& item : step.trace.stages.back().items)
            if (item.kind == "ball")
                off = std::max(
                    off, length(item.get<Vec2>("position") - session_.world().balls()[place++].position));
        set("read_out_off", off);
        set("separation_off", separation_off(step.trace, *run_.scene));
    }

    [[nodiscard]] double error() const {
        const Engine& exact = engine_named("reference");
        Session truth(run_.scene, exact, settings_for(exact, *run_.scene));
        const Timeline timeline(0, run_.seconds, *run_.on.dt);
        for (std::uint64_t k = 0; k < timeline.steps(); ++k) truth.step(timeline.length(k));
        double most = 0;
        const auto balls = session_.world().balls(), true_balls = truth.world().balls();
        if (balls.size() != true_balls.size()) return INFINITY;
        for (std::size_t i = 0; i < balls.size(); ++i)
            most = std::max(most, length(balls[i].position - true_balls[i].position) / balls[i].radius);
        return most;
    }

    const ClaimRun& run_;
    Figures& figures_;
    Session session_;
    std::vector<BallAtPart> touching_;
};

}  // namespace

Figures measure(const Claim& claim) {
    Figures figures;
    std::map<std::string, std::vector<BallAtPart>> touching;
    for (const ClaimRun& run : claim.runs) {
        RunMeasure one(run, figures);
        one.measure();
        touching[run.name] = one.touching();
    }
    for (const ClaimRun& run : claim.runs) {
        if (run.compare_with.empty()) continue;
        std::vector<BallAtPart> differ;
        std::ranges::set_symmetric_difference(touching[run.name], touching[run.compare_with],
                                              std::back_inserter(differ));
        figures[run.name + ".touching_differs"] = static_cast<double>(differ.size());
    }
    return figures;
}

std::vector<Verified> verify(const Claim& claim, const Figures& figures, const std::string& file) {
    std::vector<Verified> all;
    for (std::size_t i = 0; i < claim.holds.size(); ++i) {
        const std::string& statement = claim.holds[i];
        try {
            const Judgement judgement = judge(statement, figures);
            Verified& one = all.emplace_back(Verified{statement, judgement.holds, {}});
            for (const std::string& name : judgement.figures)
                one.measured.push_back(name + " = " + brief(figures.at(name)) +
                                       std::string(unit_of_figure(name)));
        } catch (const BadStatement& error) {
            throw InputError(file, "/claim/holds/" + std::to_string(i),
                             in_quotes(statement) + ": " + error.what() +
                                 "; allowed are comparisons, joined by && and ||, of figures: " +
                                 names_of(figures, [](const auto& figure) { return figure.first; }));
        }
    }
    return all;
}

}  // namespace flipside::lab
