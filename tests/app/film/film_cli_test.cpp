/// `flipside replay` that makes films, as a shell runs it.

#include <csignal>
#include <regex>

#include <SFML/Graphics/Image.hpp>
#include <nlohmann/json.hpp>

#include "app/command_line.hpp"
#include "app/real_window.hpp"

namespace flipside::app {
namespace {

class FilmCommand : public CommandLine {
  protected:
    static void SetUpTestSuite() { display = std::make_unique<VirtualDisplay>(); }
    static void TearDownTestSuite() { display.reset(); }
    void SetUp() override {
        CommandLine::SetUp();
        std::ofstream(file("script.json")) << R"({"format": "flipside-script/1", "controls": [
            {"time": 0.1, "control": "launch", "strength": 0.9}]})";
        expect_good("run pinball --engine custom --seconds 1 --script " + file("script.json") +
                    " --replay '" + game + "'");
        environment = "";  // with the display
    }
    [[nodiscard]] std::size_t files_in(const std::string& folder) const {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(file(folder)), fs::directory_iterator{}));
    }
    static bool has(const std::string& program) {
        return std::system((program + " -version > /dev/null 2>&1").c_str()) == 0;
    }
    /// A program of that name that does as the line says.
    void use_ffmpeg(const std::string& line) {
        fs::create_directory(file("bin"));
        std::ofstream(file("bin/ffmpeg")) << "#!/bin/sh\n[ \"$1\" = -version ] && exit 0\n" << line << "\n";
        fs::permissions(file("bin/ffmpeg"), fs::perms::owner_all);
        environment = "PATH=" + file("bin") + ":$PATH";
    }
    void expect_nothing_left() const {
        for (const auto& entry : fs::directory_iterator(folder)) {
            EXPECT_NE(entry.path().extension(), ".mp4") << entry.path();
            EXPECT_NE(entry.path().extension(), ".part") << entry.path();
        }
    }
    static inline std::unique_ptr<VirtualDisplay> display;
    std::string game = file("-a game.flipside-replay");
};

TEST_F(FilmCommand, WritesTheSameSoundTwice) {
    const Result result = flipside("replay '" + game + "' --sound " + file("one.wav"));
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.out, "61 frames, 1 s\n");
    expect_good("replay '" + game + "' --sound " + file("other.wav"));
    const std::string bytes = text_of(file("one.wav"));
    EXPECT_EQ(bytes.size(), 44 + 4U * 61 * 735);
    EXPECT_EQ(bytes, text_of(file("other.wav")));
    EXPECT_NE(bytes.substr(44), std::string(bytes.size() - 44, '\0'));
}

TEST_F(FilmCommand, WritesEveryFrameAndTheSameOnesTwice) {
    const std::string how = "replay '" + game + "' --fps 10 --width 400 --height 600 --frames ";
    const Result result = flipside(how + file("one"));
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.out, "11 frames, 1 s\n");
    EXPECT_EQ(files_in("one"), 12U) << "eleven and their sound";
    expect_good(how + file("other"));
    for (const char* name : {"frame-000000.png", "frame-000010.png", "sound.wav"})
        EXPECT_EQ(text_of(file("one") + "/" + name), text_of(file("other") + "/" + name)) << name;
    sf::Image first, last;
    ASSERT_TRUE(first.loadFromFile(file("one/frame-000000.png")));
    ASSERT_TRUE(last.loadFromFile(file("one/frame-000010.png")));
    EXPECT_EQ(first.getSize(), sf::Vector2u(400, 600));
    EXPECT_NE(text_of(file("one/frame-000000.png")), text_of(file("one/frame-000010.png")));
    expect_refused(how + file("one"), 2, "holds frames already");
}

TEST_F(FilmCommand, WritesAPartOfTheGame) {
    const std::string how = "replay '" + game + "' --fps 10 --width 400 --height 600 ";
    const Result result = flipside(how + "--from 0.3 --to 0.75 --frames " + file("part"));
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.out, "5 frames, 0.45 s\n");
    EXPECT_EQ(files_in("part"), 6U) << "five and their sound";
    expect_good(how + "--frames " + file("whole"));
    EXPECT_EQ(text_of(file("part/frame-000004.png")), text_of(file("whole/frame-000007.png")));
    const std::string sound = text_of(file("part/sound.wav"));
    EXPECT_TRUE(sound.substr(44) == text_of(file("whole/sound.wav")).substr(44 + 4 * 3 * 4410, 4 * 5 * 4410));

    for (const char* of_a_film : {"--from 0.3", "--to 0.3", "--fps 10", "--view single", "--show boxes",
                                  "--no-artwork", "--width 400", "--height 400"})
        expect_refused("replay '" + game + "' " + of_a_film, 2,
                       "is said of a film: --frames, --video or --sound asks for one");
    const std::string refused = how + "--sound " + file("x.wav");
    expect_refused(refused + " --from -1", 2, "a number from 0");
    expect_refused(refused + " --to 1.5", 2, "from 0 to 1 s, its end");
    expect_refused(refused + " --from 0.5 --to 0.4", 2, "no part of the game lies from 0.5 s to 0.4 s");
    expect_refused(refused + " --from 0.51 --to 0.52", 2, "no frame lies from 0.51 s to 0.52 s");
    EXPECT_FALSE(fs::exists(file("x.wav")));
}

TEST_F(FilmCommand, AFilmOfAnotherCourseThanTheGamesIsMadeAndEndsWithOne) {
    nlohmann::json replay = nlohmann::json::parse(text_of(game));
    replay["runs"][0]["end"]["checksum"] = "0123456789abcdef";
    std::ofstream(file("parted")) << replay;
    const Result result = flipside("replay " + file("parted") + " --sound " + file("x.wav"));
    EXPECT_EQ(result.code, 1);
    EXPECT_EQ(result.out, "61 frames, 1 s\n");
    EXPECT_NE(result.err.find("is not the game that was saved"), std::string::npos) << result.err;
    EXPECT_TRUE(fs::exists(file("x.wav")));
    replay["runs"][0]["dt"] = 1;
    replay["runs"][0]["steps"] = 24'000;
    replay["runs"][0]["checks"] = std::vector<std::string>(40, "0123456789abcdef");
    std::ofstream(file("long")) << replay;
    expect_refused("replay " + file("long") + " --sound " + file("y.wav"), 1, "a film may last 6");
}

TEST_F(FilmCommand, RefusesWhatCannotBe) {
    expect_refused("replay '" + game + "' --sound '" + game + "'", 2, "which is read");
    expect_refused("replay '" + game + "' --sound x.wav --fps 0", 2, "from 1 to 240");
    expect_refused("replay '" + game + "' --sound " + file("none/x.wav"), 2, "cannot be written");
    expect_refused("replay '" + game + "' --frames " + file("f") + " --show cheese", 2, "cheese");
    expect_refused("replay '" + game + "' --video x.mp4 --width 401", 2, "even");
    environment = "DISPLAY=";
    expect_refused("replay '" + game + "' --frames " + file("f"), 1, "no display");
    EXPECT_FALSE(fs::exists(file("f")));
}

TEST_F(FilmCommand, WithoutFfmpegItSaysWhatToInstall) {
    environment = "PATH=/nowhere";
    expect_refused("replay '" + game + "' --video " + file("x.mp4"), 1, "on Debian install ffmpeg");
    EXPECT_FALSE(fs::exists(file("x.mp4")));
}

TEST_F(FilmCommand, WhatFfmpegSaysOfAFailureIsSaidAndNothingIsLeft) {
    use_ffmpeg("head -c 1000 > /dev/null; echo 'no such \033[31mcodec' >&2; exit 3");
    expect_refused("replay '" + game + "' --video " + file("x.mp4") + " --width 400 --height 600", 1,
                   "codec");
    expect_nothing_left();
}

TEST_F(FilmCommand, InterruptedItEndsFfmpegTooAndLeavesNothing) {
    use_ffmpeg("echo $$ > " + file("number") + "; exec sleep 600");
    environment += " timeout --preserve-status -s TERM 3";
    const Result result = flipside("replay '" + game + "' --video " + file("x.mp4"));
    EXPECT_EQ(result.code, 1);
    EXPECT_EQ(result.err, "flipside: interrupted\n");
    const int number = std::stoi(text_of(file("number")));
    EXPECT_NE(kill(number, 0), 0) << "ffmpeg goes on";
    expect_nothing_left();
}

TEST_F(FilmCommand, WritesAVideoWithSound) {
    if (!has("ffmpeg") || !has("ffprobe")) GTEST_SKIP() << "there is no ffmpeg";
    const std::string video = file("-it's 100% new.mp4");
    const Result result =
        flipside("replay '" + game + "' --fps 30 --width 400 --height 600 --video \"" + video + "\"");
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    const std::string probe =
        "ffprobe -v error -count_frames -show_entries "
        "stream=codec_name,width,height,nb_read_frames,duration -of csv=p=0 ";
    ASSERT_EQ(std::system((probe + "\"file:" + video + "\" > " + file("streams")).c_str()), 0);
    const std::string streams = text_of(file("streams"));
    EXPECT_TRUE(std::regex_search(streams, std::regex("h264,400,600,1\\.03\\d*,31\n"))) << streams;
    EXPECT_TRUE(std::regex_search(streams, std::regex("aac,1\\.03\\d*,"))) << streams;
    // The same sound as by itself, but for what the codec leaves out.
    expect_good("replay '" + game + "' --fps 30 --sound " + file("x.wav"));
    const std::string decode = "ffmpeg -v error -i \"file:" + video + "\" -f s16le " + file("x.raw");
    ASSERT_EQ(std::system(decode.c_str()), 0);
    EXPECT_NEAR(static_cast<double>(fs::file_size(file("x.raw"))), 4 * 1470 * 31, 4 * 2048);
}

}  // namespace
}  // namespace flipside::app
