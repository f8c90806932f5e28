#pragma once
/// What the window remembers of a run in order to draw it: recent hits, lights, tracks. All times are
/// simulated, so slow motion slows every fade.

#include <deque>
#include <limits>
#include <map>
#include <span>
#include <vector>

#include "world/ball.hpp"
#include "world/events.hpp"

namespace flipside::app {

struct Hit {
    double time = 0;  ///< s
    Vec2 at;
    double speed = 0;  ///< m/s, approach
    bool between_balls = false;
};

class Traces {
  public:
    static constexpr double hit_seconds = 0.5, track_seconds = 1, light_seconds = 0.1;

    explicit Traces(std::size_t parts = 0) : lit_(parts, -std::numeric_limits<double>::infinity()) {}

    /// After each step. Events carry the engine's times; `time` is that of the end of the step.
    void observe(std::span<const Event> events, std::span<const Ball> balls, double time);

    [[nodiscard]] const std::deque<Hit>& hits() const { return hits_; }
    /// Where each ball was, oldest first.
    [[nodiscard]] const std::map<BallNumber, std::deque<Vec2>>& tracks() const { return tracks_; }
    /// Between the last two points of a track, s.
    [[nodiscard]] double track_spacing() const { return spacing_; }
    /// 1 right after a hit of the part, 0 a tenth of a second later.
    [[nodiscard]] double light(PartIndex part, double time) const;

  private:
    void follow(std::span<const Ball> balls, double time);

    static constexpr double track_interval = 1.0 / 120;  ///< s
    static constexpr std::size_t most_hits = 2000;

    std::vector<double> lit_;  ///< time of the last hit by part
    std::deque<Hit> hits_;
    std::map<BallNumber, std::deque<Vec2>> tracks_;
    double followed_ = -1;  ///< time of the last point of the tracks
    double spacing_ = track_interval;
};

}  // namespace flipside::app
