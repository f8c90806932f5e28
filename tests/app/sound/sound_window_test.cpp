/// The real window with real sound: OpenAL's driver `wave` writes to a file what others would play.

#include <cstring>
#include <fstream>

#include "app/window_fixture.hpp"

namespace flipside::app {
namespace {

namespace fs = std::filesystem;

class SoundWindow : public WindowTest {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "flipside-sound-XXXXXX").string();
        ASSERT_NE(mkdtemp(name.data()), nullptr);
        folder = name;
        use_driver("wave");
    }
    void TearDown() override {
        unsetenv("ALSOFT_CONF");
        WindowTest::TearDown();
        fs::remove_all(folder);
    }
    void use_driver(const std::string& driver) const {
        std::ofstream(folder / "openal.conf")
            << "[general]\ndrivers = " << driver << "\n[wave]\nfile = " << wave().string() << "\n";
        setenv("ALSOFT_CONF", (folder / "openal.conf").c_str(), 1);
    }
    void start() {
        if (window) WindowTest::TearDown();
        window = std::make_unique<RealWindow>(std::vector<std::string>{"pinball"}, folder);
    }
    void end() {
        if (window->now()["panes"][0]["launched"] > 0) {  // it asks first
            window->key("Escape");
            window->wait("the question", [](const Json& s) { return s["notice"] != ""; });
        }
        window->key("Escape");
        EXPECT_EQ(window->program().wait(60), 0);
    }
    [[nodiscard]] fs::path wave() const { return folder / "played.wav"; }
    /// The loudest sample of what was played after so many bytes of the file.
    [[nodiscard]] float loudest(std::uintmax_t from = 0) const {
        std::ifstream in(wave(), std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(in), {}};
        const std::size_t data = bytes.find("data");
        if (data == std::string::npos) throw std::runtime_error("nothing was played");
        const std::size_t begin = data + 8 + from / 8 * 8;
        float most = 0;
        for (std::size_t at = begin; at + sizeof(float) <= bytes.size(); at += sizeof(float)) {
            float sample = 0;
            std::memcpy(&sample, &bytes[at], sizeof sample);
            most = std::max(most, std::abs(sample));
        }
        return most;
    }
    /// Waits until what rang before is over.
    void let_ring_out() {
        const auto frame = window->now()["frame"].get<unsigned long>();
        window->wait("some frames", [&](const Json& s) { return s["frame"] > frame + 120; });
    }

    fs::path folder;
};

TEST_F(SoundWindow, AGameIsHeardAndAPastThatIsShownAgainIsNot) {
    start();
    EXPECT_TRUE(window->now()["has_sound"]);
    launch(0.8);
    wait_for_balls();
    window->wait("some time", [](const Json& s) { return s["time"] > 3; });
    const double end_time = pause()["time"];
    let_ring_out();
    const std::uintmax_t played = fs::file_size(wave());
    EXPECT_GT(loudest(), 0.02F);
    for (int i = 0; i < 30; ++i) window->key("comma");
    window->wait("the past", [&](const Json& s) { return s["time"] < end_time - 0.4; });
    for (const char* key : {"period", "period", "Home", "End", "Home"}) window->key(key);
    window->wait("the beginning", [](const Json& s) { return s["time"] < 0.1; });
    let_ring_out();
    end();
    EXPECT_EQ(loudest(played), 0);
}

TEST_F(SoundWindow, QMutesItAndItStaysMutedAtTheNextStart) {
    start();
    window->key("q");
    window->wait("the mute", [](const Json& s) { return s["muted"] == true; });
    launch(0.8);
    wait_for_balls();
    window->wait("some time", [](const Json& s) { return s["time"] > 2; });
    end();
    EXPECT_EQ(loudest(), 0);
    start();
    EXPECT_TRUE(window->now()["muted"]);
    click("Mute");
    window->wait("sound", [](const Json& s) { return s["muted"] == false; });
    launch(0.8);
    wait_for_balls();
    window->wait("some time", [](const Json& s) { return s["time"] > 3; });
    let_ring_out();
    end();
    EXPECT_GT(loudest(), 0.02F);
}

TEST_F(SoundWindow, WithoutADeviceAllElseWorksAndNothingIsSaidOfIt) {
    use_driver("alsa");
    setenv("ALSA_CONFIG_PATH", "/dev/null", 1);  // no card, and the library says so to stderr
    testing::internal::CaptureStderr();
    start();
    EXPECT_FALSE(window->now()["has_sound"]);
    EXPECT_TRUE(scroll_to("Mute")["controls"].contains("Mute"));
    launch(0.8);
    wait_for_balls();
    window->wait("some time", [](const Json& s) { return s["time"] > 1; });
    end();
    const std::string said = testing::internal::GetCapturedStderr();
    unsetenv("ALSA_CONFIG_PATH");
    for (const char* word : {"ALSA", "AL lib", "audio"})
        EXPECT_EQ(said.find(word), std::string::npos) << said;
}

}  // namespace
}  // namespace flipside::app
