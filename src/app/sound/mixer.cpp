#include "app/sound/mixer.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace flipside::app::sound {

namespace {

constexpr double least_loudness = 1e-3;              ///< −60 dB: not heard
constexpr double fade = 1.0 / (0.01 * sample_rate);  ///< per sample
constexpr double longest_delay = 1;                  ///< s
constexpr double room = 0.9;                         ///< all voices together are no louder
constexpr double release = 0.985;                    ///< of the limiter, per block: 0.1 s to 1/e

/// Both at once. Their waves are not in step: their powers add up, not their amplitudes.
Strike together(const Strike& one, const Strike& other) {
    const double square = one.strength * one.strength, others = other.strength * other.strength;
    Strike both = square > others ? one : other;
    both.strength = std::sqrt(square + others);
    both.pan = (square * one.pan + others * other.pan) / (square + others);
    return both;
}

}  // namespace

void Mixer::strike(const Strike& strike, double delay) {
    if (muted_ || !(loudness_of(strike) >= least_loudness)) return;
    // What is mixed next is heard later the less of the block before it has been read.
    const auto wait =
        static_cast<int>(sample_rate * std::clamp(delay, 0.0, longest_delay) + static_cast<double>(read_));
    Playing* at = std::ranges::find_if(playing_, [&](const Playing& other) {
        return other.strike.source == strike.source && other.voice.waits() > 0 &&
               std::abs(other.voice.waits() - wait) < static_cast<int>(block_size);
    });
    if (at != playing_.end()) {
        const Strike both = together(at->strike, strike);
        *at = {both, Voice(both, std::min(wait, at->voice.waits()))};
        return;
    }
    at = std::ranges::min_element(playing_, {}, &Playing::level);
    if (at->level() < loudness_of(strike)) *at = {strike, Voice(strike, wait)};
}

double Mixer::crowd_gain() const {
    double power = 0;
    for (const Playing& one : playing_)
        if (one.voice.waits() < static_cast<int>(block_size)) power += one.level() * one.level();
    return 1 / std::sqrt(1 + power / (room * room));
}

void Mixer::roll(std::size_t pane, const Roll& roll) {
    if (pane < most_rolling) rolling_[pane].set(roll);
}

std::size_t Mixer::voices() const {
    return static_cast<std::size_t>(
        std::ranges::count_if(playing_, [](const Playing& one) { return !one.voice.ended(); }));
}

Mixer::Block Mixer::mix() {
    Block block{};
    const double before = std::exchange(crowd_, crowd_gain());
    for (Playing& one : playing_)
        if (!one.voice.ended()) one.voice.add_to(block);
    for (std::size_t i = 0; i < block_size; ++i) {
        const double gain = before + (crowd_ - before) * static_cast<double>(i + 1) / block_size;
        block[i] = {gain * block[i].left, gain * block[i].right};
    }
    for (Rolling& rolling : rolling_) rolling.add_to(block);
    for (Stereo& sample : block) {
        open_ = std::clamp(open_ + (muted_ ? -fade : fade), 0.0, 1.0);
        sample.left *= open_;
        sample.right *= open_;
    }
    if (open_ == 0) playing_ = {};
    return block;
}

/// Between blocks the gain suits the peaks of both, and within a block it goes evenly from one such value to
/// the other: so it suits every sample, and has no steps.
void Mixer::limit_next_block() {
    const Block after = mix();
    double peak = 0;
    for (const Stereo& sample : after) peak = std::max({peak, std::abs(sample.left), std::abs(sample.right)});
    held_ = std::max(held_ * release, std::max(peak_, peak));
    const double before = std::exchange(gain_, 1 / std::max(1.0, held_));
    for (std::size_t i = 0; i < block_size; ++i) {
        const double way = static_cast<double>(i + 1) / block_size;
        const double gain = ceiling * (before + way * (gain_ - before));
        now_[i] = {gain * next_[i].left, gain * next_[i].right};
    }
    next_ = after;
    peak_ = peak;
    read_ = 0;
}

void Mixer::render(std::span<std::int16_t> samples) {
    for (std::size_t i = 0; i + 1 < samples.size(); i += 2) {
        if (read_ == block_size) limit_next_block();
        const Stereo& sample = now_[read_++];
        samples[i] = static_cast<std::int16_t>(std::lround(sample.left));
        samples[i + 1] = static_cast<std::int16_t>(std::lround(sample.right));
    }
}

}  // namespace flipside::app::sound
