#include "app/sound/hearing.hpp"

#include <algorithm>
#include <cmath>

namespace flipside::app::sound {

namespace {

constexpr double width = 0.8;  ///< of the stereo picture; 1 would have a sound at an end on one side alone

/// What is on one table is heard there; of panes side by side each has its part of the whole.
double pan_of(double place, std::size_t run, std::size_t runs, View view) {
    if (view != View::split || runs == 1) return width * place;
    const double half = 1.0 / static_cast<double>(runs);
    return width * (-1 + half * (1 + 2 * static_cast<double>(run)) + half * place);
}

/// Slow motion sounds lower, an octave at a sixteenth of the speed: at its own pitch nothing would be heard.
double pitch_of_speed(double speed) {
    return std::sqrt(std::sqrt(speed));
}

/// Several runs are heard together, as loud as one.
double share(std::size_t runs) {
    return 1 / std::sqrt(static_cast<double>(runs));
}

}  // namespace

void Hearing::hear(const Stage& stage, double from, double now, double speed, Mixer& mixer) {
    const auto& runs = stage.runs();
    listeners_.resize(runs.size());
    for (std::size_t i = 0; i < runs.size(); ++i) {
        Listener& listener = listeners_[i];
        if (runs[i].halt()) continue;
        if (listener.run != runs[i].name()) listener = {runs[i].name(), {}};
        for (const Heard& heard : listener.ear.listen(runs[i].session(), runs[i].events(), from)) {
            Strike strike = heard.strike;
            strike.strength *= share(runs.size());
            strike.pitch *= pitch_of_speed(speed);
            strike.pan = pan_of(strike.pan, i, runs.size(), stage.view());
            mixer.strike(strike, (heard.time - now) / speed);
        }
    }
}

void Hearing::roll(const Stage& stage, bool moving, double speed, Mixer& mixer) const {
    const auto& runs = stage.runs();
    for (std::size_t i = 0; i < Mixer::most_rolling; ++i) {
        Roll roll;
        if (moving && i < std::min(runs.size(), listeners_.size()) && !runs[i].halt()) {
            roll = listeners_[i].ear.roll(runs[i].session());
            roll.speed *= share(runs.size());
            roll.pitch = pitch_of_speed(speed);
            roll.pan = pan_of(roll.pan, i, runs.size(), stage.view());
        }
        mixer.roll(i, roll);
    }
}

}  // namespace flipside::app::sound
