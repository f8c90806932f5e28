#include "app/film/film.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "app/sound/hearing.hpp"
#include "lab/cases/text.hpp"
#include "lab/process/failure.hpp"
#include "world/input_error.hpp"

namespace flipside::app::film {

namespace {

constexpr double same_time = 1e-9;  ///< s

std::string text_of(double number) {
    constexpr int digits = 10;
    return lab::text_of(number, digits);
}

/// Hears a stage, and hands on each sample in its time: what the mixer's latency delays is cut off before.
class Soundtrack {
  public:
    /// Hands on so many samples of each side, after so many.
    Soundtrack(const Audience& audience, std::uint64_t after, std::uint64_t length)
        : audience_(audience), late_(2 * (after + sound::Mixer::latency)), due_(2 * length) {}

    void hear(const Stage& stage, double from) {
        if (!audience_.sound) return;
        hearing_.hear(stage, from, static_cast<double>(rendered_) / sound::sample_rate, 1, mixer_);
    }
    /// What sounds until that sample.
    void go_on(const Stage& stage, std::uint64_t until) {
        if (!audience_.sound) return;
        hearing_.roll(stage, true, 1, mixer_);
        render(until - rendered_);
        rendered_ = until;
    }
    void finish() {
        if (audience_.sound) render(sound::Mixer::latency);
    }

  private:
    void render(std::uint64_t length) {
        samples_.resize(2 * length);
        mixer_.render(samples_);
        const std::size_t cut = std::min<std::uint64_t>(late_, samples_.size());
        late_ -= cut;
        const std::size_t taken = std::min<std::uint64_t>(due_, samples_.size() - cut);
        due_ -= taken;
        if (taken > 0) audience_.sound(std::span(samples_).subspan(cut, taken));
    }

    const Audience& audience_;
    sound::Mixer mixer_;
    sound::Hearing hearing_;
    std::vector<std::int16_t> samples_;
    std::uint64_t rendered_ = 0;
    std::uint64_t late_, due_;  ///< samples of both sides still to be left out, and then to be handed on
};

}  // namespace

Film::Film(double seconds, unsigned frames_per_second, const Part& part)
    : from_(part.from), to_(part.to.value_or(seconds)), rate_(frames_per_second) {
    if (!(from_ >= 0 && from_ <= to_ && to_ <= seconds + same_time))
        throw InputError("no part of the game lies from " + text_of(from_) + " s to " + text_of(to_) +
                         " s; allowed are times in order from 0 to " + text_of(seconds) + " s, its end");
    if (!(to_ - from_ <= longest))
        throw lab::Failure("the film would last " + text_of((to_ - from_) / 3600) +
                           " hours; a film may last " + text_of(longest / 3600));
    first_ = static_cast<std::uint64_t>(std::ceil(from_ * rate_ - same_time));
    end_ = frames_until(to_);
    of_game_ = std::max(end_, frames_until(seconds));
    if (first_ >= end_)
        throw InputError("no frame lies from " + text_of(from_) + " s to " + text_of(to_) + " s at " +
                         std::to_string(rate_) + " frames per second");
}

std::uint64_t Film::frames_until(double time) const {
    return static_cast<std::uint64_t>(std::floor(time * rate_ + same_time)) + 1;
}

std::uint64_t Film::sample_at(std::uint64_t frame) const {
    return frame * sound::sample_rate / rate_;
}

void Film::play(ReplayStage& stage, const Audience& audience) const {
    Soundtrack track(audience, sample_at(first_), samples());
    // The last frame sounds while it is shown, and the limiter looks ahead into the one after that.
    const std::uint64_t heard = std::min(end_ + (audience.sound ? 2 : 0), of_game_);
    for (std::uint64_t frame = 0; frame < heard; ++frame) {
        const double time = static_cast<double>(frame) / rate_;
        while (stage.time() < time - same_time) {
            const double from = stage.time();
            stage.step();
            track.hear(stage.stage(), from);
        }
        track.go_on(stage.stage(), sample_at(frame));
        if (audience.frame && frame >= first_ && frame < end_) audience.frame(stage.stage());
        if (audience.progress) audience.progress(std::min(time, to_));
    }
    track.go_on(stage.stage(), sample_at(heard));
    track.finish();
}

}  // namespace flipside::app::film
