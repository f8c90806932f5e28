#include <vector>

#include <gtest/gtest.h>

#include "custom/islands/contact_solver.hpp"
#include "rapidcheck/gtest.h"

namespace flipside::custom {
namespace {

std::vector<ContactForce> some_forces(double normal) {
    std::vector<ContactForce> forces;
    for (BallNumber b = 0; b < 12; ++b)
        for (BallNumber a = 0; a < 6; ++a)
            if (*rc::gen::inRange(0, 3) == 0) forces.push_back({a, b, normal + a + 100.0 * b, 0});
    return forces;
}

// For balls with and without forces.
RC_GTEST_PROP(ForceCache, AgreesWithALinearSearch, ()) {
    const std::vector<ContactForce> forces = some_forces(1);
    ForceCache known;
    const std::vector<ContactForce> backwards(forces.rbegin(), forces.rend());
    for (const ContactForce& force : backwards) known.add(force);
    known.merge();
    for (BallNumber b = 0; b < 13; ++b)
        for (BallNumber a = 0; a < 7; ++a) {
            const auto there = std::ranges::find_if(
                forces, [&](const ContactForce& force) { return force.a == a && force.b == b; });
            const ContactForce* const found = known.find(a, b);
            const bool both = found != nullptr && there != forces.end();
            RC_ASSERT((both ? *found == *there : found == nullptr && there == forces.end()));
        }
}

RC_GTEST_PROP(ForceCache, MergesNewForcesWithThoseNotRemoved, ()) {
    const std::vector<ContactForce> old = some_forces(1), fresh = some_forces(2);
    const auto forgotten = *rc::gen::inRange<BallNumber>(0, 12);
    ForceCache known;
    for (const ContactForce& force : old) known.add(force);
    known.merge();
    known.forget_if([&](const ContactForce& force) { return force.b >= forgotten; });
    std::vector<ContactForce> expected;
    for (const ContactForce& force : old)
        if (force.b < forgotten) expected.push_back(force);
    for (const ContactForce& force : fresh)
        if (force.b >= forgotten) known.add(force), expected.push_back(force);
    known.merge();
    RC_ASSERT(std::ranges::equal(known.all(), expected));
}

}  // namespace
}  // namespace flipside::custom
