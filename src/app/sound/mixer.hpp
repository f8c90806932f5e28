#pragma once
/// Everything that sounds at a time, as samples. Knows no device: what plays or writes asks for them. After
/// its construction nothing is allocated.

#include <array>
#include <cstdint>
#include <span>

#include "app/sound/rolling.hpp"

namespace flipside::app::sound {

class Mixer {
  public:
    static constexpr std::size_t most_voices = 32;
    static constexpr std::size_t most_rolling = 4;  ///< one for each pane
    /// Samples from what happens to what is heard of it, always: the limiter looks ahead.
    static constexpr int latency = 128;

    /// `delay` s after what was rendered last. What is too quiet to be heard is left out. Hits of one kind
    /// within a block are one voice, of the sum of their powers; where all voices are taken, the quietest
    /// gives way to a louder one. Muted, nothing begins. Cost: O(voices).
    void strike(const Strike& strike, double delay);
    void roll(std::size_t pane, const Roll& roll);
    /// Fades out or in within a hundredth of a second. What rings is over then.
    void mute(bool muted) { muted_ = muted; }
    [[nodiscard]] std::size_t voices() const;

    /// The next samples, left and right in turn. None is beyond the limiter's ceiling.
    void render(std::span<std::int16_t> samples);

  private:
    static constexpr std::size_t block_size = latency / 2;
    using Block = std::array<Stereo, block_size>;

    struct Playing {
        Strike strike;
        Voice voice;
        [[nodiscard]] double level() const { return voice.level(); }
    };

    /// So that n voices are √n times as loud as one while they are few, and never louder than the room.
    [[nodiscard]] double crowd_gain() const;
    [[nodiscard]] Block mix();
    void limit_next_block();

    std::array<Playing, most_voices> playing_{};
    std::array<Rolling, most_rolling> rolling_{};
    bool muted_ = false;
    double open_ = 1;                ///< 0 muted … 1
    double crowd_ = 1;               ///< gain of all voices, at the end of next_
    Block next_{};                   ///< mixed, not limited yet
    Block now_{};                    ///< limited
    std::size_t read_ = block_size;  ///< of it
    double peak_ = 0;                ///< of next_
    double held_ = 0;                ///< what the limiter still remembers of louder peaks
    double gain_ = 1;                ///< of the limiter, at the end of now_
};

/// The loudest sample, of 32,768: −0.2 dB.
inline constexpr int ceiling = 32'000;

}  // namespace flipside::app::sound
