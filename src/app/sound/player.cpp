#include "app/sound/player.hpp"

#include <cstdlib>
#include <mutex>
#include <sstream>
#include <vector>

#include <SFML/Audio/SoundBuffer.hpp>
#include <SFML/Audio/SoundStream.hpp>
#include <SFML/System/Err.hpp>
#include <fcntl.h>
#include <unistd.h>

namespace flipside::app::sound {

namespace {

/// While it lives nothing reaches stderr: OpenAL and the libraries below it print there by themselves, a line
/// for each way to a device that they try.
class HushedStderr {
  public:
    HushedStderr() : kept_(fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, STDERR_FILENO + 1)) {
        const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
        if (kept_ >= 0 && nowhere >= 0) dup2(nowhere, STDERR_FILENO);
        if (nowhere >= 0) close(nowhere);
    }
    ~HushedStderr() {
        if (kept_ < 0) return;
        dup2(kept_, STDERR_FILENO);
        close(kept_);
    }
    HushedStderr(const HushedStderr&) = delete;
    HushedStderr& operator=(const HushedStderr&) = delete;

  private:
    int kept_;
};

/// SFML opens the device for the first thing that needs one, and says on its own stream when there is none.
bool opens_device() {
    std::ostringstream said;
    std::streambuf* const before = sf::err().rdbuf(said.rdbuf());
    const sf::SoundBuffer first;
    sf::err().rdbuf(before);
    return said.str().empty();
}

}  // namespace

class Player::Stream : public sf::SoundStream {
  public:
    Stream() {
        initialize(2, sample_rate);
        play();
    }
    ~Stream() override { stop(); }
    Stream(const Stream&) = delete;
    Stream& operator=(const Stream&) = delete;

    void change(const std::function<void(Mixer&)>& change) {
        const std::lock_guard lock(mutex_);
        change(mixer_);
    }

  private:
    bool onGetData(Chunk& chunk) override {
        const std::lock_guard lock(mutex_);
        mixer_.render(samples_);
        chunk.samples = samples_.data();
        chunk.sampleCount = samples_.size();
        return true;
    }
    void onSeek(sf::Time /*to*/) override {}

    // SFML keeps three chunks in hand and looks after them every 10 ms: what happens is heard within 60 ms.
    static constexpr std::size_t chunk_frames = sample_rate / 50;

    std::mutex mutex_;
    Mixer mixer_;
    std::vector<std::int16_t> samples_ = std::vector<std::int16_t>(2 * chunk_frames);
};

Player::Player() {
    const HushedStderr hushed;
    setenv("ALSOFT_LOGLEVEL", "0", 0);  // OpenAL's own, also when the device goes
    if (opens_device()) stream_ = std::make_unique<Stream>();
}

Player::~Player() = default;

void Player::change(const std::function<void(Mixer&)>& change) {
    if (stream_) stream_->change(change);
}

}  // namespace flipside::app::sound
