#include "app/sound/timbre.hpp"

#include <algorithm>

#include "world/math.hpp"

namespace flipside::app::sound {

namespace {

constexpr double bar = 1046.5;  ///< Hz

/// In the order of Source.
constexpr Timbre timbres[source_count] = {
    // wall: a steel rail
    {.modes = {{{620, 0.030, 0.35},
                {1370, 0.050, 0.30},
                {2490, 0.045, 0.20},
                {4080, 0.030, 0.10},
                {6230, 0.020, 0.05}}},
     .contact = 0.00025,
     .loudness = 0.30,
     .size = 0.3},
    // post: rubber about a peg
    {.modes = {{{210, 0.022, 0.50}, {390, 0.018, 0.30}, {820, 0.012, 0.15}, {1500, 0.010, 0.05}}},
     .contact = 0.0005,
     .loudness = 0.35,
     .size = 0.01},
    // bumper: its coil in the cabinet, and a ring that is struck
    {.modes = {{{95, 0.050, 0.40},
                {560, 0.120, 0.25},
                {1180, 0.160, 0.18},
                {1940, 0.140, 0.10},
                {2890, 0.100, 0.07}}},
     .contact = 0.0006,
     .loudness = 0.27,
     .size = 0.064},
    // slingshot: its coil, and a taut rubber
    {.modes = {{{120, 0.040, 0.50}, {260, 0.030, 0.25}, {740, 0.030, 0.15}, {1600, 0.020, 0.10}}},
     .contact = 0.0008,
     .loudness = 0.27,
     .size = 0.09},
    // flipper: rubber on a plastic lever
    {.modes = {{{180, 0.022, 0.50}, {430, 0.018, 0.30}, {950, 0.012, 0.15}, {2100, 0.006, 0.05}}},
     .contact = 0.0004,
     .loudness = 0.30,
     .size = 0.08},
    // target: a plastic plate that falls
    {.modes = {{{900, 0.015, 0.40}, {1750, 0.020, 0.30}, {3100, 0.015, 0.20}, {4700, 0.010, 0.10}}},
     .contact = 0.0003,
     .loudness = 0.30,
     .size = 0.025},
    // ball on ball: steel
    {.modes = {{{3100, 0.010, 0.50}, {5200, 0.007, 0.30}, {8300, 0.004, 0.20}}},
     .contact = 0.00008,
     .loudness = 0.22,
     .size = 0.027},
    // rollover: a leaf of a switch
    {.modes = {{{2600, 0.006, 0.60}, {4300, 0.004, 0.40}}},
     .contact = 0.0002,
     .loudness = 0.08,
     .size = 0.04},
    // coil of a flipper
    {.modes = {{{70, 0.030, 0.40}, {150, 0.025, 0.30}, {340, 0.020, 0.20}, {1200, 0.008, 0.10}}},
     .contact = 0.002,
     .loudness = 0.22,
     .size = 0.07},
    // launch: a spring and its rod
    {.modes = {{{110, 0.040, 0.40}, {240, 0.050, 0.30}, {530, 0.060, 0.20}, {1260, 0.050, 0.10}}},
     .contact = 0.001,
     .loudness = 0.22,
     .size = 0.027},
    // drain: a wooden trough
    {.modes = {{{75, 0.080, 0.50}, {140, 0.060, 0.30}, {230, 0.040, 0.20}}},
     .contact = 0.003,
     .loudness = 0.55,
     .size = 0.027},
    // tilt: a relay that lets everything fall
    {.modes = {{{55, 0.250, 0.40}, {110, 0.200, 0.30}, {165, 0.150, 0.20}, {900, 0.010, 0.10}}},
     .contact = 0.004,
     .loudness = 0.80,
     .size = 0.1},
    // bonus: a bar with free ends, whose modes stand in these ratios (N. Fletcher and T. Rossing 1998,
    // "The Physics of Musical Instruments", 2.15)
    {.modes = {{{bar, 0.500, 0.60}, {2.756 * bar, 0.250, 0.30}, {5.404 * bar, 0.100, 0.10}}},
     .contact = 0.0004,
     .loudness = 0.45,
     .size = 0.1}};

}  // namespace

const Timbre& timbre_of(Source source) {
    return timbres[static_cast<std::size_t>(source)];
}

double contact_seconds(const Strike& strike) {
    constexpr double soft = 10;           ///< how much longer at µ = 1 it is, at 0 being 1
    constexpr double least_speed = 1e-3;  ///< m/s; below it nothing is heard
    const double slower = 1 / math::root(std::max(strike.strength, least_speed), 5);
    return timbre_of(strike.source).contact * (1 + soft * strike.friction) * slower;
}

}  // namespace flipside::app::sound
