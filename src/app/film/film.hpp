#pragma once
/// A replay as a film: a picture and the sound of every frame, in step with simulated time.

#include <cstdint>
#include <functional>
#include <span>

#include "app/film/replay_stage.hpp"

namespace flipside::app::film {

/// Who takes what comes, in order of time; each may be empty.
struct Audience {
    /// The stage at the time of the next frame: as of its first step that ends then or later.
    std::function<void(const Stage&)> frame;
    /// What sounds from there on, left and right in turn.
    std::function<void(std::span<const std::int16_t>)> sound;
    std::function<void(double time)> progress;
};

/// From the beginning of the replay to its end.
class Film {
  public:
    static constexpr double longest = 6 * 3600;  ///< s: what a WAV file has room for, and a little less

    /// Throws lab::Failure where it would be longer than that.
    Film(double seconds, unsigned frames_per_second);

    [[nodiscard]] std::uint64_t frames() const;
    /// Of sound, on each side: as long as all frames together.
    [[nodiscard]] std::uint64_t samples() const { return sample_at(frames()); }
    /// Nobody has made a step on the stage.
    void play(ReplayStage& stage, const Audience& audience) const;

  private:
    [[nodiscard]] std::uint64_t sample_at(std::uint64_t frame) const;

    double seconds_;
    unsigned rate_;
};

}  // namespace flipside::app::film
