#include "lab/session/recorder.hpp"

#include <gtest/gtest.h>

#include "lab/contenders/engines.hpp"
#include "lab/files/assets.hpp"
#include "lab/session/timeline.hpp"
#include "world/scene_file.hpp"

namespace flipside::lab {
namespace {

/// What a person saw of a moment.
struct Shown {
    double time = 0;
    std::vector<Ball> balls;
    std::vector<PartState> parts;
    long score = 0;
    std::uint64_t impacts = 0, pair_tests = 0;
    std::vector<Event> events;

    friend bool operator==(const Shown&, const Shown&) = default;
    friend void PrintTo(const Shown& now, std::ostream* out) {
        *out << now.time << " s, score " << now.score << ", " << now.impacts << " impacts, " << now.pair_tests
             << " pair tests, " << now.events.size() << " events";
        for (const Ball& ball : now.balls)
            *out << "; ball " << ball.number << " at " << ball.position.x << ' ' << ball.position.y;
    }
};

Shown shown(const Session& session, std::span<const Event> events) {
    const World& world = session.world();
    return {world.time(),
            {world.balls().begin(), world.balls().end()},
            {world.parts().begin(), world.parts().end()},
            session.game().score(),
            session.totals().impacts,
            session.totals().pair_tests,
            {events.begin(), events.end()}};
}

/// A session with its recorder, and all that was ever shown.
class Recorded {
  public:
    Recorded(const std::string& engine, const std::vector<std::string>& settings, const std::string& scene,
             int balls = 0)
        : engine_(engine_named(engine)), session_(make(settings, scene, balls)) {
        recorder_.start(session_, 0);
        shown_.push_back(shown(session_, {}));
    }
    void press(const Control& control) {
        session_.apply(control);
        controls_.push_back(control);
    }
    /// Spans of a sixtieth in two steps each.
    void run(int spans) {
        for (int i = 0; i < spans; ++i) {
            const Recorder::Way way{1.0 / 60, 1.0 / 120, std::exchange(controls_, {})};
            std::vector<Event> events;
            const Timeline steps(0, way.span, way.dt);
            for (std::uint64_t k = 0; k < steps.steps(); ++k) {
                session_.step(steps.length(k), script_, next_);
                events.insert(events.end(), session_.events().begin(), session_.events().end());
            }
            recorder_.record(session_, way, events, next_);
            shown_.push_back(shown(session_, events));
        }
    }
    void change(const std::string& name, const std::string& value) {
        Settings settings = session_.settings();
        settings.set(name, value);
        session_.change(session_.shared_scene(), engine_, settings);
        recorder_.changed(session_, {});
        shown_.back() = shown(session_, {});
    }
    /// Every moment that is kept, from the last to the first, is what it was.
    void expect_all() {
        const std::size_t gone = shown_.size() - recorder_.size();
        for (std::size_t i = recorder_.size(); i-- > 0;) {
            const auto events = recorder_.restore(i, session_, script_);
            EXPECT_EQ(shown(session_, events), shown_[gone + i]) << "moment " << i;
            EXPECT_EQ(recorder_.time(i), shown_[gone + i].time);
            EXPECT_EQ(recorder_.at(shown_[gone + i].time), i);
        }
    }
    /// From a moment of the past, the same future again to the bit; whether the engine promises it or not.
    [[nodiscard]] bool same_future(std::size_t back, int spans) {
        const std::size_t moment = recorder_.size() - 1 - back;
        const auto events = recorder_.restore(moment, session_, script_);
        next_ = recorder_.next_control(moment);
        recorder_.forget_after(moment);
        std::vector<Shown> before(shown_.end() - static_cast<std::ptrdiff_t>(back), shown_.end());
        shown_.resize(shown_.size() - back);
        run(spans);
        std::vector<Shown> after(shown_.end() - spans, shown_.end());
        before.resize(after.size());
        // What was worked out before need not be worked out again.
        for (auto* future : {&before, &after})
            for (Shown& one : *future) one.pair_tests = 0;
        return before == after;
    }

    Recorder& recorder() { return recorder_; }
    Session& session() { return session_; }

  private:
    [[nodiscard]] Session make(const std::vector<std::string>& settings, const std::string& name,
                               int balls) const {
        const auto file = scene_file(name);
        const auto scene =
            std::make_shared<const Scene>(balls > 0 ? load_scene(file, balls) : load_scene(file));
        const Engine* const used[] = {&engine_};
        return {scene, engine_, settings_for(engine_, *scene, parse_changes(settings, used))};
    }

    const Engine& engine_;
    Session session_;
    Script script_{{0.4, control::Launch{0.9, 1, 1}},
                   {1.503, control::Flip{Side::left, true}},
                   {1.7, control::Flip{Side::left, false}}};
    std::size_t next_ = 0;
    Recorder recorder_;
    std::vector<Control> controls_;
    std::vector<Shown> shown_;
};

struct On {
    const char* engine;
    std::vector<std::string> settings;

    friend void PrintTo(const On& on, std::ostream* out) {
        *out << on.engine;
        for (const std::string& setting : on.settings) *out << ' ' << setting;
    }
};

class EveryRecordedEngine : public testing::TestWithParam<On> {};

TEST_P(EveryRecordedEngine, ShowsEveryMomentOfAGameAsItWas) {
    Recorded recorded(GetParam().engine, GetParam().settings, "pinball");
    recorded.run(100);
    recorded.press(control::Nudge{{0.2, 0}});
    recorded.press(control::Flip{Side::right, true});
    recorded.run(33);
    recorded.press(control::Flip{Side::right, false});
    recorded.run(60);
    recorded.expect_all();
}

TEST_P(EveryRecordedEngine, GoesOnFromThePastAsItPromises) {
    Recorded recorded(GetParam().engine, GetParam().settings, "toy");
    recorded.press(control::Launch{0.7, 3, 1});
    recorded.run(150);
    const bool same = recorded.same_future(47, 47);
    EXPECT_TRUE(same || !engine_named(GetParam().engine).restores_exactly);
    recorded.expect_all();
}

TEST_P(EveryRecordedEngine, KeepsHalfAMinute) {
    Recorded recorded(GetParam().engine, GetParam().settings, "toy");
    recorded.press(control::Launch{0.7, 1, 1});
    recorded.run(60 * 34);
    const Recorder& recorder = recorded.recorder();
    const double kept = recorder.time(recorder.size() - 1) - recorder.time(0);
    EXPECT_GE(kept, Recorder::longest - 1e-9);
    EXPECT_LE(kept, Recorder::longest + 2 * Recorder::between_snapshots);
    EXPECT_EQ(recorder.at(0), 0U);
}

INSTANTIATE_TEST_SUITE_P(Recorder, EveryRecordedEngine,
                         testing::Values(On{"custom", {"solver=continuous"}}, On{"custom", {"solver=simple"}},
                                         On{"box2d", {}}, On{"reference", {}}),
                         [](const auto& test) {
                             std::string name = test.param.engine;
                             for (const std::string& setting : test.param.settings)
                                 name += "_" + setting.substr(setting.find('=') + 1);
                             return name;
                         });

TEST(Recorder, AChangeInTheMiddleIsPartOfThePast) {
    Recorded recorded("custom", {"solver=continuous"}, "toy");
    recorded.press(control::Launch{0.7, 2, 1});
    recorded.run(70);
    recorded.change("solver", "simple");
    recorded.run(40);
    recorded.change("motion_iterations", "9");
    recorded.run(21);
    recorded.expect_all();
    EXPECT_EQ(recorded.session().settings().choice("solver"), "continuous");
    EXPECT_TRUE(recorded.same_future(50, 28));
}

TEST(Recorder, AThousandBallsTakeLessThanTwoHundredMegabytes) {
    for (const On& on : {On{"custom", {}}, On{"box2d", {}}}) {
        Recorded recorded(on.engine, on.settings, "rain", 1000);
        recorded.run(60);
        const std::size_t second = recorded.recorder().bytes();
        EXPECT_LT(30 * second, 200'000'000U) << on.engine;
        EXPECT_GT(second, 1000 * sizeof(Ball)) << on.engine;
    }
}

}  // namespace
}  // namespace flipside::lab
