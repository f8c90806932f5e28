#include "app/window/playfield/effects.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "app/window/contender_colour.hpp"

namespace flipside::app {

namespace {

constexpr double spark_seconds = 0.35, trail_seconds = 0.1;
constexpr double hard = 1.0 / 6;  ///< heights of the pane per second
constexpr int most_sparks = 14;
constexpr std::size_t most_hits = 100;

/// A number in 0…1 that looks random, for each of a hit's sparks (Steele, Lea and Flood 2014, "Fast
/// splittable pseudorandom number generators": SplitMix64's mixing function).
double chance(const Hit& hit, int spark, int use) {
    std::uint64_t z = std::bit_cast<std::uint64_t>(hit.time) ^ std::bit_cast<std::uint64_t>(hit.at.x) ^
                      (static_cast<std::uint64_t>(2 * spark + use) * 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    return static_cast<double>((z ^ (z >> 31U)) >> 11U) * 0x1p-53;
}

/// Each flies off straight and slows down evenly until it is gone.
void draw_sparks_of(Canvas& canvas, Vec2 at, const Hit& hit, double age, double strength) {
    const double left = 1 - age / spark_seconds, gone = 1 - left * left;
    const int count = 3 + static_cast<int>((most_sparks - 3) * strength);
    for (int i = 0; i < count; ++i) {
        const Vec2 way = from_angle(2 * std::numbers::pi * chance(hit, i, 0));
        const double reach = canvas.scaled(12 + 40 * strength) * (0.4 + 0.6 * chance(hit, i, 1));
        const Vec2 head = at + reach * gone * way, tail = at + reach * gone * (1 - 0.35 * left) * way;
        canvas.line(tail, head, canvas.scaled(1.6), with_alpha(colour::lit, left));
    }
}

}  // namespace

void draw_sparks(Canvas& canvas, const Camera& camera, const Run& run) {
    const double time = run.session().world().time();
    const std::deque<Hit>& hits = run.traces().hits();
    const std::size_t first = hits.size() > most_hits ? hits.size() - most_hits : 0;
    for (std::size_t i = first; i < hits.size(); ++i) {
        const Hit& hit = hits[i];
        const double age = time - hit.time, speed = camera.scale * hit.speed / (hard * camera.size.y);
        if (age < 0 || age >= spark_seconds || speed < 1) continue;
        draw_sparks_of(canvas, camera.to_pixels(hit.at), hit, age, std::min(1.0, (speed - 1) / 8));
    }
}

void draw_trails(Canvas& canvas, const Camera& camera, const Run& run, std::span<const Ball> balls) {
    if (balls.size() > most_trails) return;
    const auto most = static_cast<std::size_t>(std::max(1.0, trail_seconds / run.traces().track_spacing()));
    std::vector<Vec2> way;
    for (const Ball& ball : balls) {
        const auto entry = run.traces().tracks().find(ball.number);
        if (entry == run.traces().tracks().end()) continue;
        const std::deque<Vec2>& track = entry->second;
        way.assign(1, camera.to_pixels(ball.position));
        for (std::size_t i = 0; i < std::min(most, track.size()); ++i) {
            const Vec2 next = camera.to_pixels(track[track.size() - 1 - i]);
            if (length(next - way.back()) > 0.2 * camera.size.y) break;  // it was taken up and put elsewhere
            if (length(next - way.back()) > 0.5) way.push_back(next);
        }
        canvas.trail(way, 1.8 * camera.scale * ball.radius, with_alpha(colour_of(run), 0.6));
    }
}

}  // namespace flipside::app
