#pragma once
/// The lines, arcs and rounds that a primitive of the surface is made of, and a ball's distance to them.

#include "interval.hpp"
#include "reader.hpp"

namespace certificate {

/// A place or a velocity, in time.
struct JetVec {
    Jet x, y;
};

/// Of a ball's centre at a time, or over an interval of it, and its spin.
struct Motion {
    JetVec place;
    Jet spin;
};
[[nodiscard]] Motion motion_of(const Leg& leg, const I& time, int order = Jet::most);

struct Feature {
    enum class Kind { line, arc, round } kind = Kind::round;
    I x, y;                      ///< where a line starts; the centre of the others
    I along_x, along_y, length;  ///< of a line: its unit vector
    I radius;                    ///< of the others
    I from_x, from_y, to_x, to_y;
    bool wide = false, full = true;                    ///< an arc of more than half a turn; of a whole turn
    bool goes_on_first = false, goes_on_last = false;  ///< a smooth joint: no point is there to be hit
};
[[nodiscard]] std::vector<Feature> features_of(const Primitive& primitive, const Run& run);

/// How a ball lies to a feature.
struct Lie {
    Jet gap;
    JetVec normal;        ///< unit, to the ball
    JetVec velocity;      ///< of the surface where they touch
    bool apart = false;   ///< certainly not within the ends of the feature
    bool facing = false;  ///< certainly within them, joints allowed for
};
/// `span`: null for what stands still.
[[nodiscard]] Lie lie_of(const Feature& feature, const Part& part, const Span* span, const JetVec& place,
                         double radius, const I& time);

}  // namespace certificate
