#include "fuzz/drive.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "box2d/engine.hpp"
#include "custom/engine.hpp"
#include "fuzz/oracle.hpp"
#include "lab/process/cpu_clock.hpp"
#include "lab/session/run_settings.hpp"
#include "reference/engine.hpp"
#include "world/state_file.hpp"
#include "world/surface.hpp"

namespace flipside::fuzz {

namespace {

constexpr std::size_t most_balls = 12, most_primitives = 64;

/// How often which contender was driven; printed when the program ends.
class Counts {
  public:
    Counts() = default;
    Counts(const Counts&) = delete;
    Counts& operator=(const Counts&) = delete;
    void add(const char* contender) { ++counts_[contender]; }
    ~Counts() {
        for (const auto& [contender, count] : counts_)
            std::fprintf(stderr, "driven: %s %llu\n", contender, count);
    }

  private:
    std::map<const char*, unsigned long long> counts_;
};
Counts counts;

bool finite(Vec2 v) {
    return std::isfinite(v.x) && std::isfinite(v.y);
}

void require_sound_balls(const World& world) {
    const auto balls = world.balls();
    for (std::size_t i = 0; i < balls.size(); ++i) {
        const Ball& ball = balls[i];
        require(finite(ball.position) && finite(ball.velocity) && std::isfinite(ball.angle) &&
                    std::isfinite(ball.spin),
                "a ball is not finite");
        require(i == 0 || balls[i - 1].number < ball.number, "balls are not by rising number");
    }
}

void require_sound_events(std::span<const Event> events, double from, double to) {
    // Engines that only know steps give the end of the step, others round times within it.
    const double rounding = 1e-12 * std::max(1.0, to);
    double last = from;
    for (const Event& event : events) {
        require(finite(event.point) && finite(event.normal) && std::isfinite(event.speed) &&
                    std::isfinite(event.impulse),
                "an event is not finite");
        require(event.time >= last - rounding && event.time <= to + rounding,
                "an event is out of order of time");
        last = event.time;
    }
}

void require_sound_contacts(const World& world) {
    for (const Contact& contact : world.contacts())
        require(finite(contact.point) && finite(contact.normal) && std::isfinite(contact.separation),
                "a contact is not finite");
}

/// A scene in motion on a contender, with the checks.
class Run {
  public:
    Run(const Contender& contender, const Ride& ride)
        : contender_(contender), ride_(ride), session_(ride.scene, *contender.engine, settings()) {
        if (ride.start != nullptr) session_.restore(*ride.start);
        next_ = lab::next_control(ride.script, session_.world().time());
    }
    /// Another run that continues from the saved state alone.
    [[nodiscard]] Run resumed() const {
        Run other(contender_, ride_);
        other.session_ = session_.fork();
        other.next_ = next_;
        return other;
    }

    /// Ends early where the engine refuses. False where it was given up because steps are slow: each is held
    /// to its own limit (CpuLimit), and more of them tell nothing new.
    bool steps(int count) {
        constexpr double patience = 1;  // s
        const lab::CpuStopwatch watch;
        const double dt = lab::step_for(*ride_.scene);
        for (int i = 0; i < count && !refused_; ++i) {
            if (watch.seconds() > patience) return false;
            step(dt);
        }
        return true;
    }
    [[nodiscard]] bool refused() const { return refused_; }
    [[nodiscard]] const lab::Session& session() const { return session_; }
    [[nodiscard]] std::string text() const { return to_json(session_.world().save(), *ride_.scene); }

  private:
    [[nodiscard]] Settings settings() const {
        Settings settings = lab::settings_for(*contender_.engine, *ride_.scene);
        for (const auto& [name, value] : contender_.settings) settings.set(name, value);
        if (contender_.engine != &custom::engine()) return settings;
        // A scene may recommend so few events that the step is left to the solver that tunnels.
        if (ride_.closed) settings.set("max_impacts", Settings(settings.specs()).text("max_impacts"));
        for (const SettingSpec& spec : settings.specs())
            if (spec.name == "broad_phase")
                settings.set(spec.name, spec.choices[ride_.variation % spec.choices.size()]);
        return settings;
    }

    void step(double dt) {
        const double before = session_.world().time();
        const State saved = session_.world().save();
        {
            const CpuLimit limit(contender_.slowness * longest_answer);
            refused_ = !accepted([&] { session_.step(dt, ride_.script, next_); });
        }
        require_sound_balls(session_.world());
        const double after = session_.world().time();
        require(after >= before, "time runs backwards");
        if (refused_) {
            // The rules and scripts issue controls within a step; without them the world is as it was.
            if (ride_.script.empty() && !ride_.scene->rules)
                require(text() == to_json(saved, *ride_.scene), "a refused step changed the world");
            return;
        }
        const double ulp = std::nextafter(before + dt, INFINITY) - (before + dt);
        require(std::abs(after - before - dt) <= 4 * ulp, "the step did not last dt");
        require_sound_events(session_.events(), before, after);
        require_sound_contacts(session_.world());
        if (!ride_.closed) return;
        for (const Event& event : session_.events())
            require(event.kind != EventKind::lost, "a ball got out of a closed box");
    }

    const Contender& contender_;
    const Ride& ride_;
    lab::Session session_;
    std::size_t next_ = 0;
    bool refused_ = false;
};

}  // namespace

const std::vector<Contender>& contenders() {
    static const std::vector<Contender> all = [] {
        std::vector<Contender> made;
        for (const SettingSpec& spec : custom::engine().settings)
            if (spec.name == "solver")
                for (const std::string_view solver : spec.choices)
                    if (solver != "auto")
                        made.push_back({solver.data(),
                                        &custom::engine(),
                                        {{"solver", std::string(solver)}},
                                        solver == "continuous",
                                        true});
        made.push_back({"box2d", &box2d::engine(), {}, false, false});
        made.push_back(
            {"reference-53", &reference::engine(), {{"precision", "53"}, {"twin", "off"}}, true, false});
        made.push_back(
            {"reference-113", &reference::engine(), {{"precision", "113"}}, true, false, 6, 32, 10});
        return made;
    }();
    return all;
}

bool is_small(const Scene& scene) {
    return scene.balls.size() <= most_balls && scene.parts.size() <= most_primitives &&
           surface_of(scene).size() <= most_primitives;
}

bool is_small(const State& state) {
    return state.balls.size() <= most_balls;
}

void require_round_trip(const lab::Session& session) {
    const Scene& scene = session.scene();
    const std::string text = to_json(session.world().save(), scene);
    State read;
    try {
        read = parse_state(text, "saved", scene);
    } catch (const InputError& error) {
        report_violation(std::string("a saved state cannot be read: ") + error.what());
    }
    require(to_json(read, scene) == text, "a state that was read is not the one that was written");
    lab::Session other = session.fork();
    other.restore(read);
    if (to_json(other.world().save(), scene) != text)
        report_violation("a restored state is not the one that was saved:\n" + text +
                         to_json(other.world().save(), scene));
}

void drive(const Contender& contender, const Ride& ride) {
    if (ride.variation / 4 % contender.one_in != 0) return;
    set_subject(contender.name);
    static_cast<void>(accepted([&] {
        Run run(contender, ride);
        counts.add(contender.name);
        require_sound_balls(run.session().world());
        const int half = contender.steps / 2;
        const bool quick = run.steps(half);
        require_round_trip(run.session());
        if (run.refused() || !quick) return;
        Run resumed = run.resumed();
        if (!run.steps(half)) return;
        require_round_trip(run.session());
        if (contender.repeats_states) {
            if (!resumed.steps(half)) return;
            require(resumed.text() == run.text(), "from a saved state the world goes on otherwise");
        } else if (ride.variation % 4 == 0) {
            Run again(contender, ride);
            if (!again.steps(half) || !again.steps(half)) return;
            require(again.text() == run.text(), "the same input gives other bits");
        }
    }));
}

}  // namespace flipside::fuzz
