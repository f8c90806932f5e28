/// Replays as films: pictures and sound in step with simulated time.

#include "app/film/film.hpp"

#include <fstream>
#include <iterator>

#include <gtest/gtest.h>
#include <unistd.h>

#include "app/sound/samples.hpp"
#include "app/sound/wav_file.hpp"
#include "lab/process/failure.hpp"
#include "world/input_error.hpp"
#include "world/scene_file.hpp"

namespace flipside::app::film {
namespace {

using sound::Samples;

/// A game of two runs that were played, each in a step of its own.
lab::Replay game(double seconds, double launched_at = 0.5) {
    Stage stage("pinball", "custom", View::split, {}, {}, {"one=custom,dt=1/120", "other=box2d"});
    stage.run_until(launched_at);
    stage.press(control::Launch{0.9});
    stage.run_until(seconds - launched_at);
    return stage.game();
}

struct Shown {
    std::vector<double> times, positions;
    Samples samples;
};

Shown shown(const lab::Replay& replay, unsigned rate, const Part& part = {}) {
    ReplayStage stage(replay, View::split, nullptr);
    const Film film(stage.end(), rate, part);
    Shown all;
    film.play(stage, {[&](const Stage& now) {
                          all.times.push_back(now.time());
                          for (const Run& run : now.runs())
                              for (const Ball& ball : run.session().world().balls())
                                  all.positions.push_back(ball.position.y);
                      },
                      [&](std::span<const std::int16_t> samples) {
                          all.samples.insert(all.samples.end(), samples.begin(), samples.end());
                      },
                      {}});
    EXPECT_EQ(all.times.size(), film.frames());
    EXPECT_EQ(all.samples.size(), 2 * film.samples());
    EXPECT_EQ(stage.parted(), nullptr);
    return all;
}

TEST(Film, EveryFrameIsAtItsTime) {
    const lab::Replay replay = game(2);
    for (const unsigned rate : {24U, 60U, 75U}) {
        const Shown film = shown(replay, rate);
        ASSERT_EQ(film.times.size(), 2 * rate + 1);
        for (std::size_t i = 0; i < film.times.size(); ++i) {
            const double due = static_cast<double>(i) / rate;
            EXPECT_GE(film.times[i], due - 1e-9);
            EXPECT_LT(film.times[i], due + 1.0 / 60);
        }
    }
}

TEST(Film, APartIsTheSameToTheBitAsInTheWholeFilm) {
    const lab::Replay replay = game(3);
    const Shown whole = shown(replay, 60), part = shown(replay, 60, {1.01, 2.0});
    ASSERT_EQ(part.times.size(), 60U);  // the first one after 1.01 s is the 61st
    EXPECT_EQ(part.times, std::vector<double>(whole.times.begin() + 61, whole.times.begin() + 121));
    EXPECT_TRUE(
        std::ranges::equal(part.samples, std::span(whole.samples).subspan(2 * 61 * 735, 2 * 60 * 735)));
    EXPECT_GT(sound::peak_of(part.samples), 100);  // it rolls, and what rang before rings on
    EXPECT_EQ(shown(replay, 60, {2, 3}).times.size(), 61U);
    EXPECT_EQ(shown(replay, 60, {3, 3}).times.size(), 1U);
}

TEST(Film, OfAPartThatTheGameDoesNotHaveThereIsNone) {
    for (const Part& part : {Part{-1, {}}, Part{2, 1}, Part{0, 3.1}, Part{3.1, {}}, Part{1.001, 1.002}})
        EXPECT_THROW(Film(3, 60, part), InputError) << part.from;
    EXPECT_EQ(Film(2 * Film::longest, 60, {Film::longest, {}}).frames(), 60 * Film::longest + 1);
}

TEST(Film, BothRunsGoOnAndEndAsInTheGame) {
    const lab::Replay replay = game(3);
    ReplayStage stage(replay, View::split, nullptr);
    ASSERT_EQ(stage.stage().runs().size(), 2U);
    EXPECT_EQ(stage.stage().runs()[0].dt(), 1.0 / 120);
    while (stage.step()) {
    }
    EXPECT_EQ(stage.parted(), nullptr);
    for (std::size_t i = 0; i < 2; ++i) {
        lab::ReplayPlayer player(replay, i);
        while (player.step()) {
        }
        const auto balls = stage.stage().runs()[i].session().world().balls();
        ASSERT_EQ(balls.size(), 1U);
        EXPECT_EQ(balls[0].position, player.session().world().balls()[0].position);
    }
    // The way of one is held against that of the other, as in the window.
    ASSERT_EQ(stage.stage().divergences().size(), 1U);
    EXPECT_GT(stage.stage().divergences()[0].history().size(), 60U);
}

TEST(Film, ARunThatGoesAnotherWayIsNamed) {
    lab::Replay replay = game(2);
    replay.runs[1].end.checksum ^= 1U;
    ReplayStage stage(replay, View::split, nullptr);
    while (stage.step()) {
    }
    ASSERT_NE(stage.parted(), nullptr);
    EXPECT_EQ(*stage.parted(), "other");
}

TEST(Film, TheSingleViewShowsTheFirstRunOrAnotherEngine) {
    const lab::Replay replay = game(1);
    ReplayStage first(replay, View::single, nullptr);
    ASSERT_EQ(first.stage().runs().size(), 1U);
    EXPECT_EQ(first.stage().runs()[0].name(), "one");
    const Engine& reference = lab::engine_named("reference");
    ReplayStage other(replay, View::single, &reference);
    ASSERT_EQ(other.stage().runs().size(), 1U);
    EXPECT_EQ(&other.stage().runs()[0].engine(), &reference);
    while (other.step()) {
    }
    EXPECT_EQ(other.stage().runs()[0].session().world().balls().size(), 1U);
}

/// The first sample that is not silent.
std::size_t first_sound(const Samples& samples) {
    const auto first = std::ranges::find_if(samples, [](std::int16_t s) { return std::abs(s) > 2; });
    return static_cast<std::size_t>(first - samples.begin()) / 2;
}

TEST(Film, TheSoundOfALaunchIsAtItsTimeAtEveryRateAndTheSameTwice) {
    const lab::Replay replay = game(2, 0.75);
    const Samples samples = shown(replay, 60).samples;
    // Half a step of the plunger's contact and the slope of its first waves.
    EXPECT_NEAR(static_cast<double>(first_sound(samples)) / sound::sample_rate, 0.75, 0.002);
    EXPECT_EQ(samples, shown(replay, 60).samples);
    EXPECT_NEAR(static_cast<double>(first_sound(shown(replay, 24).samples)) / sound::sample_rate, 0.75,
                0.002);
    EXPECT_GT(sound::peak_of(samples), 1000);
}

TEST(Film, ARunThatHaltedInTheGameHaltsInTheFilmAndTheOthersGoOn) {
    // The reference refuses moving balls in resting contact with each other.
    const std::string file = testing::TempDir() + "flipside-film-pile-" + std::to_string(getpid()) + ".json";
    std::ofstream(file) << R"({"format": "flipside-scene/1", "name": "pile",
        "bounds": {"min": [-1, -1], "max": [1, 1]}, "gravity": [0, -9.81],
        "balls": [{"position": [-0.1, 0.1], "radius": 0.1, "mass": 1, "material": "soft"},
                  {"position": [0.1, 0.1], "radius": 0.1, "mass": 1, "material": "soft"},
                  {"position": [0, 0.4], "radius": 0.1, "mass": 1, "material": "soft"}],
        "materials": {"soft": {"restitution": 0}},
        "parts": [{"name": "floor", "material": "soft",
                   "shape": {"type": "segment", "a": [-1, 0], "b": [1, 0]}}]})";
    Stage stage(file, "custom", View::split, {}, {}, {"custom=custom", "exact=reference"});
    std::filesystem::remove(file);
    stage.run_until(0.5);
    const auto* exact = stage.exact();
    ASSERT_TRUE(exact->halt());
    const lab::Replay replay = stage.game();
    ReplayStage again(replay, View::split, nullptr);
    while (again.step()) {
    }
    EXPECT_EQ(again.parted(), nullptr);
    ASSERT_TRUE(again.stage().exact()->halt());
    EXPECT_EQ(again.stage().exact()->halt()->reason, exact->halt()->reason);
    EXPECT_EQ(again.stage().exact()->halt()->time, exact->halt()->time);
    EXPECT_FALSE(again.stage().lead().halt());
    EXPECT_EQ(again.stage().time(), stage.time());
}

TEST(Film, AReplayWithoutStepsIsOneFrame) {
    Stage stage("drop", "custom", View::split, {}, {});
    const Shown film = shown(stage.game(), 60);
    EXPECT_EQ(film.times, std::vector<double>{0});
    EXPECT_EQ(sound::peak_of(film.samples), 0);
}

TEST(Film, NoneIsLongerThanItsSoundHasRoomFor) {
    EXPECT_LT(Film(Film::longest, 240).samples(), (std::uint64_t{1} << 30U) - 10);
    EXPECT_THROW(Film(Film::longest + 1, 60), lab::Failure);
    EXPECT_THROW(Film(1e300, 60), lab::Failure);
}

class WavTest : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = (std::filesystem::temp_directory_path() / "flipside-wav-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder = name;
    }
    void TearDown() override { std::filesystem::remove_all(folder); }
    [[nodiscard]] std::string bytes() const {
        std::ifstream in(file(), std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    [[nodiscard]] std::filesystem::path file() const { return folder / "x.wav"; }
    std::filesystem::path folder;
};

TEST_F(WavTest, IsAsItsHeaderSaysAndThereAsAWholeOnly) {
    {
        sound::WavFile wav(file(), 3);
        const std::int16_t samples[] = {1, -2, 0x1234, 7};
        wav.write(samples);
        EXPECT_FALSE(std::filesystem::exists(file()));
        wav.finish();
    }
    using namespace std::string_literals;
    EXPECT_EQ(bytes(),
              "RIFF\x30\0\0\0WAVEfmt \x10\0\0\0\1\0\2\0\x44\xac\0\0\x10\xb1\2\0\4\0\x10\0"s
              "data\x0c\0\0\0\1\0\xfe\xff\x34\x12\7\0\0\0\0\0"s);
}

TEST_F(WavTest, NeverHoldsMoreThanItSays) {
    sound::WavFile wav(file(), 1);
    const std::int16_t samples[] = {1, 2, 3, 4};
    wav.write(samples);
    wav.finish();
    EXPECT_EQ(bytes().size(), 44U + 4U);
}

}  // namespace
}  // namespace flipside::app::film
