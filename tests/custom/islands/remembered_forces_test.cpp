#include "custom/islands/remembered_forces.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "rapidcheck/gtest.h"

namespace flipside::custom {
namespace {

// For the ball that was gone on to and for later ones, there or not.
RC_GTEST_PROP(RememberedForces, FindsWhatALookAtEachFinds, ()) {
    std::vector<ContactForce> forces;
    for (BallNumber b = 0; b < 12; ++b)
        for (BallNumber a = 0; a < 6; ++a)
            if (*rc::gen::inRange(0, 3) == 0) forces.push_back({a, b, 1.0 + a + 100.0 * b, 0});
    RememberedForces known(forces);
    for (BallNumber b = 0; b < 12; b += *rc::gen::inRange<BallNumber>(1, 4)) {
        known.go_on_to(b);
        for (BallNumber later = b; later < 13; ++later)
            for (BallNumber a = 0; a < 7; ++a) {
                const auto there = std::ranges::find_if(
                    forces, [&](const ContactForce& force) { return force.a == a && force.b == later; });
                const ContactForce* const found = known.find(a, later);
                RC_ASSERT((found == nullptr) == (there == forces.end()));
                RC_ASSERT(found == nullptr || found == &*there);
            }
    }
}

}  // namespace
}  // namespace flipside::custom
