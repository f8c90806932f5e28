#pragma once
/// What the things on a table sound like: each is a few modes, damped oscillations that a hit sets off at
/// once (K. van den Doel and D. Pai 1998, "The sounds of physical shapes", Presence 7). The numbers are made
/// up for this table, in the range of small steel, rubber and wooden bodies.

#include <array>

namespace flipside::app::sound {

enum class Source {
    wall,
    post,
    bumper,
    slingshot,
    flipper,
    target,
    ball,
    rollover,  ///< the switch of a lane or a spinner
    coil,      ///< of a flipper: it starts, or arrives
    launch,
    drain,
    tilt,
    bonus
};
inline constexpr std::size_t source_count = 13;

struct Mode {
    double frequency = 0;  ///< Hz
    double decay = 0;      ///< s until it has fallen to 1/e
    double gain = 0;       ///< share of the whole; together at most 1
};

struct Timbre {
    std::array<Mode, 5> modes;
    double contact = 0;   ///< s that a hit at 1 m/s takes: the longer, the duller
    double loudness = 0;  ///< of a change of speed by 1 m/s; 1 is as loud as there is
    double size = 0;      ///< m, of the body that these modes are of
};

[[nodiscard]] const Timbre& timbre_of(Source source);

/// One hit.
struct Strike {
    Source source = Source::wall;
    double strength = 0;     ///< m/s by which it changes a ball's speed, or as much
    double pitch = 1;        ///< on all frequencies; what is higher decays sooner
    double friction = 0;     ///< µ of the surface: rubber has much of it, and a hit of rubber takes longer
    double restitution = 1;  ///< e of the surface: the lower, the greater the damping of the modes
    double pan = 0;          ///< −1 left … 1 right
};

/// As in Timbre.
[[nodiscard]] inline double loudness_of(const Strike& strike) {
    return strike.strength * timbre_of(strike.source).loudness;
}

/// How long the two bodies touch, s: by Hertz's law the −1/5th power of the speed (W. Goldsmith 1960,
/// "Impact").
[[nodiscard]] double contact_seconds(const Strike& strike);

}  // namespace flipside::app::sound
