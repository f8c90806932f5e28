#include "app/film/film.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "app/sound/hearing.hpp"
#include "lab/process/failure.hpp"

namespace flipside::app::film {

namespace {

constexpr double same_time = 1e-9;  ///< s

/// Hears a stage, and hands on each sample in its time: what the mixer's latency delays is cut off before.
class Soundtrack {
  public:
    explicit Soundtrack(const Audience& audience) : audience_(audience) {}

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
        const std::size_t cut = std::min(late_, samples_.size());
        late_ -= cut;
        audience_.sound(std::span(samples_).subspan(cut));
    }

    const Audience& audience_;
    sound::Mixer mixer_;
    sound::Hearing hearing_;
    std::vector<std::int16_t> samples_;
    std::uint64_t rendered_ = 0;
    std::size_t late_ = std::size_t{2} * sound::Mixer::latency;
};

}  // namespace

Film::Film(double seconds, unsigned frames_per_second) : seconds_(seconds), rate_(frames_per_second) {
    if (!(seconds <= longest))
        throw lab::Failure("the game lasts " + std::to_string(std::llround(seconds / 3600)) +
                           " hours; a film may last " + std::to_string(std::llround(longest / 3600)));
}

std::uint64_t Film::frames() const {
    return static_cast<std::uint64_t>(std::floor(seconds_ * rate_ + same_time)) + 1;
}

std::uint64_t Film::sample_at(std::uint64_t frame) const {
    return frame * sound::sample_rate / rate_;
}

void Film::play(ReplayStage& stage, const Audience& audience) const {
    Soundtrack track(audience);
    for (std::uint64_t frame = 0; frame < frames(); ++frame) {
        const double time = static_cast<double>(frame) / rate_;
        while (stage.time() < time - same_time) {
            const double from = stage.time();
            stage.step();
            track.hear(stage.stage(), from);
        }
        track.go_on(stage.stage(), sample_at(frame));
        if (audience.frame) audience.frame(stage.stage());
        if (audience.progress) audience.progress(time);
    }
    // What the last frame shows sounds while it is shown.
    track.go_on(stage.stage(), samples());
    track.finish();
}

}  // namespace flipside::app::film
