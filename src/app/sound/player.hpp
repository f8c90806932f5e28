#pragma once
/// Plays what a mixer mixes on the computer's own device, if it has one. The only file here that knows SFML.

#include <functional>
#include <memory>

#include "app/sound/mixer.hpp"

namespace flipside::app::sound {

class Player {
  public:
    /// Where there is no device nothing is played, and nothing said.
    Player();
    ~Player();
    Player(const Player&) = delete;
    Player& operator=(const Player&) = delete;

    [[nodiscard]] bool has_device() const { return stream_ != nullptr; }
    /// Changes what is to be played; another thread renders it. Does nothing without a device.
    void change(const std::function<void(Mixer&)>& change);

  private:
    class Stream;
    std::unique_ptr<Stream> stream_;
};

}  // namespace flipside::app::sound
