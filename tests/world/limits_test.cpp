// What every engine refuses, by name.

#include "world/limits.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "world/refusal.hpp"
#include "world/scene_builder.hpp"

namespace flipside {
namespace {

std::string refusal_of(const Event& event, const Scene& scene) {
    try {
        require_finite("engine", event, scene);
    } catch (const Refusal& refusal) {
        return refusal.what();
    }
    return "";
}

TEST(Limits, AnEventWithANumberThatIsNoneIsRefused) {
    Scene scene = empty_scene();
    add_part(scene, segment({0, 0}, {1, 0})).name = "floor";
    const Event event{1.5, EventKind::impact, 3, Other::part(0), {1, 2}, {0, 1}, 4, 5};
    EXPECT_EQ(refusal_of(event, scene), "");
    double Vec2::*const coordinates[] = {&Vec2::x, &Vec2::y};
    Vec2 Event::*const vectors[] = {&Event::point, &Event::normal};
    double Event::*const numbers[] = {&Event::speed, &Event::impulse};
    const std::string says =
        "engine: ball 3 and floor at 1.5 s: what they do to each other is beyond the numbers of this engine";
    for (const double none : {double{NAN}, double{INFINITY}, -double{INFINITY}}) {
        for (Vec2 Event::*const vector : vectors)
            for (double Vec2::*const coordinate : coordinates) {
                Event bad = event;
                bad.*vector.*coordinate = none;
                EXPECT_EQ(refusal_of(bad, scene), says);
            }
        for (double Event::*const number : numbers) {
            Event bad = event;
            bad.*number = none;
            EXPECT_EQ(refusal_of(bad, scene), says);
        }
    }
}

TEST(Limits, ALostBallNeedsNoPartToBeNamed) {
    const Event lost{1, EventKind::lost, 0, {}, {NAN, 0}, {}, 0, 0};
    EXPECT_NE(refusal_of(lost, empty_scene()).find("ball 0 and the bounds at 1 s"), std::string::npos);
}

}  // namespace
}  // namespace flipside
