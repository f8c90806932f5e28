/// The same scene, settings and script give the same bits, whatever compiled the program and whatever runs
/// it: one checksum over the states of each scene on the custom engine and on the reference, as JSON (which
/// holds every double exactly). A state is taken every 20 steps, so that a scene whose balls end asleep is
/// judged by the way there. The table is the same for every build, so two builds that pass it agree with each
/// other.
///
/// A change of an engine's arithmetic changes these on purpose; then take over what the test prints.

#include <algorithm>
#include <iterator>
#include <ostream>
#include <string_view>
#include <vector>

#include <boost/crc.hpp>
#include <gtest/gtest.h>

#include "custom/engine.hpp"
#include "lab/files/assets.hpp"
#include "lab/session/run_settings.hpp"
#include "lab/session/session.hpp"
#include "reference/engine.hpp"
#include "world/scene_file.hpp"
#include "world/script_file.hpp"
#include "world/state_file.hpp"

namespace flipside::lab {
namespace {

constexpr int steps_between_samples = 20;

struct Golden {
    const char* scene;
    const char* how;  ///< "reference", or the solver of the custom engine
    int steps;
    std::uint32_t checksum;
};

/// Rain has 320 balls. After 76 steps some are in resting contact with each other, which the reference
/// refuses.
constexpr Golden golden[] = {
    {"bowl", "continuous", 600, 0x5ead033c},    {"bowl", "reference", 600, 0xe08160d3},
    {"box", "continuous", 600, 0xc4c093cf},     {"box", "reference", 600, 0x02ec3582},
    {"cradle", "continuous", 600, 0x07b2c072},  {"cradle", "reference", 600, 0xbb6781c8},
    {"drop", "continuous", 600, 0x4d13b8f4},    {"drop", "reference", 600, 0x60c3acdc},
    {"pinball", "continuous", 600, 0xf4204405}, {"pinball", "reference", 600, 0xa32d8405},
    {"rain", "continuous", 120, 0x1ef68875},    {"rain", "reference", 60, 0x0bb4f183},
    {"toy", "continuous", 600, 0x405a1d80},     {"toy", "reference", 600, 0x02f296f5},
    {"bowl", "simple", 600, 0xa37a95cd},        {"box", "simple", 600, 0x581d0c9d},
    {"cradle", "simple", 600, 0x298368f9},      {"drop", "simple", 600, 0x687ee19f},
    {"pinball", "simple", 600, 0x56628824},     {"rain", "simple", 120, 0x60483566},
    {"toy", "simple", 600, 0xf0279768},
};

void PrintTo(const Golden& g, std::ostream* out) {
    *out << g.scene << ' ' << g.how;
}

/// A scene under its own script.
class Replay {
  public:
    explicit Replay(const Golden& what)
        : scene_(std::make_shared<const Scene>(load_scene(scene_file(what.scene)))),
          session_(start(what.how)) {
        if (const auto file = script_beside(scene_file(what.scene))) script_ = load_script(*file, *scene_);
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
    /// Of the state alone: the fingerprint of its table, the same all along, is left out.
    void sample() {
        std::string text = to_json(session_.world().save(), *scene_);
        const std::size_t table = text.find(R"("table":)");
        text.erase(table, text.find(',', table) + 1 - table);
        crc_.process_bytes(text.data(), text.size());
    }
    [[nodiscard]] Session start(std::string_view how) const {
        const Engine& engine = how == "reference" ? reference::engine() : custom::engine();
        Settings settings = settings_for(engine, *scene_);
        if (how != "reference") settings.set("solver", how);
        return {scene_, engine, settings};
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
    Replay run(GetParam());
    run.steps(GetParam().steps);
    EXPECT_EQ(run.checksum(), GetParam().checksum) << std::hex << "0x" << run.checksum();
}

/// The reference begins a path anew where it is restored, and rounds otherwise than in the midst of one.
class CustomHash : public GoldenHash {};

TEST_P(CustomHash, SameBitsAfterSaveAndRestoreInMidRun) {
    Replay run(GetParam());
    run.steps(GetParam().steps / 2 - 7);
    run.save_and_restore();
    run.steps(GetParam().steps / 2 + 7);
    EXPECT_EQ(run.checksum(), GetParam().checksum) << std::hex << "0x" << run.checksum();
}

std::string name_of(const testing::TestParamInfo<Golden>& test) {
    return std::string(test.param.scene) + "_" + test.param.how;
}

std::vector<Golden> those(bool (*fit)(std::string_view how)) {
    std::vector<Golden> found;
    std::ranges::copy_if(golden, std::back_inserter(found), [&](const Golden& g) { return fit(g.how); });
    return found;
}

INSTANTIATE_TEST_SUITE_P(Scenes, GoldenHash, testing::ValuesIn(golden), name_of);
INSTANTIATE_TEST_SUITE_P(Scenes, CustomHash,
                         testing::ValuesIn(those([](std::string_view how) { return how != "reference"; })),
                         name_of);

TEST(GoldenHashes, CoverEveryScene) {
    for (const std::string& name : scene_names())
        for (const std::string_view how : {"simple", "continuous", "reference"})
            EXPECT_TRUE(
                std::ranges::any_of(golden, [&](const Golden& g) { return g.scene == name && g.how == how; }))
                << name << ' ' << how;
}

}  // namespace
}  // namespace flipside::lab
