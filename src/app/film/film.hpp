#pragma once
/// A replay as a film: a picture and the sound of every frame, in step with simulated time.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "app/film/replay_stage.hpp"

namespace flipside::app::film {

/// The receivers of frames and samples, in order of time; each may be empty.
struct Audience {
    /// The stage at the time of the next frame: as of its first step that ends then or later.
    std::function<void(const Stage&)> frame;
    /// What sounds from there on, left and right in turn.
    std::function<void(std::span<const std::int16_t>)> sound;
    std::function<void(double time)> progress;
};

/// Of a game what lies between two times, s.
struct Part {
    double from = 0;
    std::optional<double> to;  ///< none: the end of the game
};

/// Frames and samples of a part are those of the whole film: what rings at its beginning is heard.
class Film {
  public:
    static constexpr double longest = 6 * 3600;  ///< s: what a WAV file has room for, and a little less

    /// Of a game of so many seconds. Throws InputError where the part is not within it or no frame lies in
    /// the part, lab::Failure where the film would be longer than `longest`.
    Film(double seconds, unsigned frames_per_second, const Part& part = {});

    [[nodiscard]] double from() const { return from_; }  ///< s
    [[nodiscard]] double to() const { return to_; }      ///< s
    [[nodiscard]] std::uint64_t frames() const { return end_ - first_; }
    /// Of sound, on each side: as long as all frames together.
    [[nodiscard]] std::uint64_t samples() const { return sample_at(end_) - sample_at(first_); }
    /// The stage must not have made a step.
    void play(ReplayStage& stage, const Audience& audience) const;

  private:
    [[nodiscard]] std::uint64_t frames_until(double time) const;
    [[nodiscard]] std::uint64_t sample_at(std::uint64_t frame) const;

    double from_, to_;  ///< s
    unsigned rate_;
    /// Numbers in the whole film: of the first frame, of the one after the last, and of how many there are.
    std::uint64_t first_ = 0, end_ = 0, of_game_ = 0;
};

}  // namespace flipside::app::film
