/// The same scene, settings and script give the same bits, whatever compiled the program: one checksum over
/// the states of each scene in 600 steps of the custom engine, as JSON (which holds every double exactly). A
/// state is taken every 20 steps, so that a scene whose balls end asleep is judged by the way there. The
/// table is the same for every build, so two builds that pass it agree with each other.
///
/// A change of the engine's arithmetic changes these on purpose; then take over what the test prints.

#include <algorithm>
#include <iterator>
#include <ostream>
#include <string_view>
#include <vector>

#include <boost/crc.hpp>
#include <gtest/gtest.h>

#include "custom/engine.hpp"
#include "lab/assets.hpp"
#include "lab/run_settings.hpp"
#include "lab/session.hpp"
#include "world/scene_file.hpp"
#include "world/script_file.hpp"
#include "world/state_file.hpp"

namespace flipside::lab {
namespace {

constexpr int steps = 600;
constexpr int steps_between_samples = 20;

struct Golden {
    const char* scene;
    const char* solver;
    std::uint32_t checksum;
};

/// Rain, with its 320 balls, is for the discrete solver.
constexpr Golden golden[] = {
    {"bowl", "discrete", 0xcb908546},    {"bowl", "continuous", 0x5ce28c7a},
    {"box", "discrete", 0x84f071c4},     {"box", "continuous", 0xbeb4c505},
    {"cradle", "discrete", 0xcf8a14cf},  {"cradle", "continuous", 0x7e870ccc},
    {"drop", "discrete", 0x420c2da0},    {"drop", "continuous", 0x76d82cc0},
    {"pinball", "discrete", 0xae199227}, {"pinball", "continuous", 0x700740b9},
    {"rain", "discrete", 0x340f6843},    {"toy", "discrete", 0x76846e3b},
    {"toy", "continuous", 0x0855c431},
};

void PrintTo(const Golden& g, std::ostream* out) {
    *out << g.scene << ' ' << g.solver;
}

/// A scene under its own script, on the custom engine.
class Replay {
  public:
    Replay(const std::string& scene, std::string_view solver, std::string_view look_ahead = {})
        : scene_(std::make_shared<const Scene>(load_scene(scene_file(scene)))),
          session_(start(solver, look_ahead)) {
        if (const auto file = script_beside(scene_file(scene))) script_ = load_script(*file, *scene_);
    }
    void steps(int count) {
        for (int i = 0; i < count; ++i) {
            session_.step(step_for(*scene_), script_, next_);
            if (++steps_done_ % steps_between_samples == 0) sample();
        }
    }
    /// Goes on in a new world, made from the saved state alone.
    void save_and_restore() { session_ = session_.fork(); }
    /// Of all samples so far.
    [[nodiscard]] std::uint32_t checksum() const { return crc_.checksum(); }

  private:
    void sample() {
        const std::string text = to_json(session_.world().save(), *scene_);
        crc_.process_bytes(text.data(), text.size());
    }
    [[nodiscard]] Session start(std::string_view solver, std::string_view look_ahead) const {
        Settings settings = settings_for(custom::engine(), *scene_);
        settings.set("solver", solver);
        if (!look_ahead.empty()) settings.set("look_ahead", look_ahead);
        return {scene_, custom::engine(), settings};
    }

    std::shared_ptr<const Scene> scene_;
    Session session_;
    Script script_;
    std::size_t next_ = 0;
    int steps_done_ = 0;
    boost::crc_32_type crc_;
};

class GoldenHash : public testing::TestWithParam<Golden> {};

TEST_P(GoldenHash, SameBitsInEveryBuild) {
    Replay run(GetParam().scene, GetParam().solver);
    run.steps(steps);
    EXPECT_EQ(run.checksum(), GetParam().checksum) << std::hex << "0x" << run.checksum();
}

TEST_P(GoldenHash, SameBitsAfterSaveAndRestoreInMidRun) {
    Replay run(GetParam().scene, GetParam().solver);
    run.steps(steps / 2 - 7);
    run.save_and_restore();
    run.steps(steps / 2 + 7);
    EXPECT_EQ(run.checksum(), GetParam().checksum) << std::hex << "0x" << run.checksum();
}

class ContinuousHash : public GoldenHash {};

// Looking ahead saves searches that find nothing, and nothing else.
TEST_P(ContinuousHash, IsTheSameHoweverFarItLooksAhead) {
    for (const auto* radii : {"0", "2", "100"}) {
        Replay run(GetParam().scene, GetParam().solver, radii);
        run.steps(steps);
        EXPECT_EQ(run.checksum(), GetParam().checksum) << radii;
    }
}

std::string name_of(const testing::TestParamInfo<Golden>& test) {
    return std::string(test.param.scene) + "_" + test.param.solver;
}

std::vector<Golden> continuous_ones() {
    std::vector<Golden> found;
    std::ranges::copy_if(golden, std::back_inserter(found),
                         [](const Golden& g) { return std::string_view(g.solver) == "continuous"; });
    return found;
}

INSTANTIATE_TEST_SUITE_P(Scenes, GoldenHash, testing::ValuesIn(golden), name_of);
INSTANTIATE_TEST_SUITE_P(Scenes, ContinuousHash, testing::ValuesIn(continuous_ones()), name_of);

TEST(GoldenHashes, CoverEveryScene) {
    for (const std::string& name : scene_names())
        EXPECT_TRUE(std::ranges::any_of(golden, [&](const Golden& g) { return g.scene == name; })) << name;
}

}  // namespace
}  // namespace flipside::lab
