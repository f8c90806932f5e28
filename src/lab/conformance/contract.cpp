/// What the interface asks for beyond physics: numbers, events, contacts, controls, states, refusals.

#include <algorithm>
#include <cmath>

#include "flipside/engine.h"
#include "lab/conformance/check.hpp"
#include "plugin/needs.hpp"
#include "world/input_error.hpp"
#include "world/trace.hpp"

namespace flipside::lab {

namespace {

constexpr double usual_step = 1.0 / 60;  ///< s

/// Balls side by side that never meet.
std::string row_of_balls(int count) {
    std::string balls;
    for (int i = 0; i < count; ++i)
        balls += std::string(i == 0 ? "" : ", ") + R"({"position": [)" + std::to_string(i - 3) +
                 R"(, 3], "velocity": [0, 1], "radius": 0.1, "mass": 1})";
    return R"("gravity": [0, -9.81], "balls": [)" + balls + "]";
}

Finding keeps_numbers(const Subject& subject) {
    const int count = subject.declares(FLIPSIDE_BALL_PAIRS) ? 5 : 1;
    const auto world = subject.world(row_of_balls(count));
    world->step(usual_step);
    if (count == 1) return passes("The one ball keeps its number.");
    world->remove(2);
    Ball added = world->balls().back();
    added.position = {4, 4};
    world->add(added);
    world->step(usual_step);
    std::string numbers;
    for (const Ball& ball : world->balls())
        numbers += (numbers.empty() ? "" : ", ") + std::to_string(ball.number);
    return numbers == "0, 1, 3, 4, 5"
               ? passes("Of five balls the third goes and a sixth comes: their numbers are " + numbers + ".")
               : fails("Of five balls the third goes and a sixth comes: their numbers are " + numbers +
                       " instead of 0, 1, 3, 4, 5.");
}

Finding refuses_by_name(const Subject& subject) {
    std::string missing;
    for (const plugin::Feature& feature : plugin::features())
        if (!subject.declares(feature.bit))
            missing += (missing.empty() ? "" : ", ") + std::string(feature.name);
    try {
        const auto world = subject.world(
            R"("gravity": [0, -1], "damping": 0.1, "materials": {"m": {"friction": 0.1, "kick": 0.1}},
               "balls": [{"position": [0, 5], "radius": 0.1, "mass": 1, "material": "m"},
                         {"position": [1, 5], "radius": 0.1, "mass": 1, "material": "m"}],
               "parts": [
                 {"name": "arc", "material": "m", "shape": {"type": "arc", "center": [0, 5], "radius": 5, "from_deg": 200, "to_deg": 340}},
                 {"name": "circle", "shape": {"type": "circle", "center": [3, 0], "radius": 0.5}},
                 {"name": "polygon", "shape": {"type": "polygon", "points": [[-5, -5], [-4, -5], [-4, -4]]}},
                 {"name": "left", "motion": {"type": "flip", "side": "left", "raised_deg": 30, "up_rate": 20, "down_rate": 10},
                  "shape": {"type": "flipper", "pivot": [-3, -3], "length": 0.5, "base_radius": 0.1, "tip_radius": 0.05, "rest_deg": -30}},
                 {"name": "lane", "sensor": true, "shape": {"type": "segment", "a": [4, 4], "b": [5, 4]}},
                 {"name": "deck", "collides_with": [], "shape": {"type": "segment", "a": [4, 5], "b": [5, 5]}},
                 {"name": "gate", "shape": {"type": "gate", "a": [4, 6], "b": [5, 6], "normal": [0, 1]}}])");
        run_for(*world, 1, usual_step, [] {});
    } catch (const InputError& error) {
        return missing.empty()
                   ? fails(error.what())
                   : passes("A scene that needs everything is refused, since it lacks: " + missing + ".");
    }
    return missing.empty() ? passes("A scene that needs everything runs.")
                           : fails("A scene that needs everything runs, though it lacks: " + missing + ".");
}

std::string dropped_ball(const Subject& subject, const char* restitution) {
    return R"("gravity": [0, -9.81], "materials": {"m": {"restitution": )" + std::string(restitution) +
           R"(}}, "balls": [{"position": [0, 1.1], "radius": 0.1, "mass": 2}], "parts": [)" +
           subject.floor(R"("material": "m", )") + "]";
}

Finding reports_events(const Subject& subject) {
    if (!subject.description().offers.events)
        return {Grade::not_offered, "It reports no events: impacts are not counted, and nothing scores."};
    const auto world = subject.world(dropped_ball(subject, "0.5"));
    std::vector<Event> impacts;
    run_for(*world, 0.6, 1.0 / 240, [&] {
        for (const Event& event : world->events())
            if (event.kind == EventKind::impact) impacts.push_back(event);
    });
    if (impacts.size() != 1)
        return fails("A ball falls on the floor once, and " + counted(impacts.size(), "impact") +
                     " is reported.");
    const Event& impact = impacts.front();
    const double speed = std::sqrt(2 * 9.81), impulse = 2 * 1.5 * speed;
    const double error =
        std::max({std::abs(impact.time - std::sqrt(2 / 9.81)), length(impact.normal - Vec2{0, 1}),
                  std::abs(impact.speed - speed) / speed, std::abs(impact.impulse - impulse) / impulse});
    return graded(error, 0.02, 0.2,
                  "The impact of a falling ball is reported at " + brief(impact.time) + " s with " +
                      brief(impact.speed) + " m/s and " + brief(impact.impulse) + " N s; exact are " +
                      brief(std::sqrt(2 / 9.81)) + " s, " + brief(speed) + " m/s and " + brief(impulse) +
                      " N s.");
}

Finding reports_contacts(const Subject& subject) {
    if (!subject.description().offers.contacts)
        return {Grade::not_offered, "It reports no contacts: how deep things overlap is not known."};
    const auto world = subject.world(dropped_ball(subject, "0"));
    run_for(*world, 1.5, 1.0 / 240, [] {});
    const auto contacts = world->contacts();
    if (contacts.size() != 1)
        return fails("A ball lies on the floor, and " + counted(contacts.size(), "contact") +
                     " is reported.");
    const double error =
        std::max(length(contacts[0].normal - Vec2{0, 1}), std::abs(contacts[0].separation) / 0.1);
    return graded(error, 0.02, 0.2,
                  "A ball that lies on the floor touches it with a separation of " +
                      brief(1e3 * contacts[0].separation) + " mm.");
}

Finding follows_controls(const Subject& subject) {
    const auto world = subject.world(row_of_balls(1));
    world->step(usual_step);
    const Vec2 before = world->balls().front().velocity;
    world->apply(control::Nudge{{2, 0}});
    world->step(usual_step);
    const double error = std::abs(world->balls().front().velocity.x - before.x - 2);
    if (error > 1e-9) return fails("A nudge of 2 m/s changes a ball's speed by another amount.");
    return subject.description().offers.control
               ? passes("A nudge of 2 m/s is one of 2 m/s.")
               : Finding{Grade::part,
                         "It follows no controls, so that the world is made anew for every one of them.",
                         0.5};
}

/// The balls after a second and a half, of which the second half was run in a world that was restored.
std::vector<Ball> with_a_break(const Subject& subject, const std::string& scene, bool restored) {
    auto world = subject.world(scene);
    run_for(*world, 0.75, usual_step, [] {});
    if (restored) {
        const State state = world->save();
        world = subject.world(scene);
        world->restore(state);
    }
    run_for(*world, 0.75, usual_step, [] {});
    return {world->balls().begin(), world->balls().end()};
}

Finding goes_on_from_a_state(const Subject& subject) {
    const std::string scene = dropped_ball(subject, "0.9");
    const std::vector<Ball> whole = with_a_break(subject, scene, false),
                            broken = with_a_break(subject, scene, true);
    if (whole == broken) return passes("A world that is restored goes on with the same bits.");
    const double apart =
        whole.empty() || broken.empty() ? 10 : length(whole[0].position - broken[0].position);
    if (subject.description().offers.save)
        return fails("It saves and restores, and goes on with other bits: " + brief(apart) + " m apart.");
    return apart < 0.05
               ? Finding{Grade::part, "A world that is restored goes on " + brief(apart) + " m apart.", 0.5}
               : fails("A world that is restored goes on " + brief(apart) + " m apart.");
}

constexpr ContractItem contract[] = {
    {"ball numbers", "Balls keep their numbers when others come and go.", 5, 0, true, keeps_numbers},
    {"refusal", "What it does not declare is refused by name; what it declares runs.", 3, 0, true,
     refuses_by_name},
    {"events", "Impacts are reported with their time, normal, speed and impulse.", 5, 0, false,
     reports_events},
    {"contacts", "What touches is reported.", 3, 0, false, reports_contacts},
    {"controls", "What changes from outside is followed.", 2, 0, false, follows_controls},
    {"states", "A run goes on from a saved state.", 2, 0, false, goes_on_from_a_state},
};

}  // namespace

std::span<const ContractItem> contract_items() {
    return contract;
}

}  // namespace flipside::lab
