#pragma once
/// Hears one session: what sounds in each of its steps, from its events and from what has changed.

#include <memory>
#include <span>
#include <vector>

#include "app/sound/rolling.hpp"
#include "app/sound/sources.hpp"
#include "lab/session/session.hpp"

namespace flipside::app::sound {

/// A strike at its time. Its pan is the place on the table.
struct Heard {
    double time = 0;  ///< s
    Strike strike;
};

class Ear {
  public:
    /// What sounded on the way to the session as it is, from the moment of the last call. `events` are those
    /// since `from` s, which is the time of that moment; where it is not, the session was put into another
    /// state, and only its events sound. Valid until the next call.
    std::span<const Heard> listen(const lab::Session& session, std::span<const Event> events, double from);
    /// How its balls roll now: all of them where the table slows them down (Scene::damping), else those that
    /// touch something.
    [[nodiscard]] Roll roll(const lab::Session& session) const;

  private:
    void begin(const lab::Session& session);
    void remember(const lab::Session& session);
    void hear_events(const lab::Session& session, std::span<const Event> events);
    void hear_flippers(const lab::Session& session, double from);
    void hear_launches(const lab::Session& session, std::span<const Event> events, double from);
    void hear_spinners(const lab::Session& session, double from);
    void hear_rules(const lab::Session& session);
    void add(double time, Source source, double strength, double x, double pitch = 1);
    [[nodiscard]] double place(double x) const;

    std::shared_ptr<const Scene> scene_;
    std::vector<PartSound> parts_;
    std::vector<Heard> heard_;
    /// As it was at the last call.
    struct {
        double time = -1;
        std::size_t told = 0;  ///< captions of the game
        std::vector<Ball> balls;
        std::vector<PartState> parts;
        std::vector<bool> moving;  ///< flippers
        std::vector<double> spins;
    } before_;
};

}  // namespace flipside::app::sound
