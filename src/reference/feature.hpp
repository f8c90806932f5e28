#pragma once
/// The features of the exact engine: lines and curves, in full precision. A curve is an arc (two-sided, with
/// or without ends) or the outside of a circle (a point has radius 0). Solid shapes are represented by their
/// outlines: a disc outside can only enter through the outline.

#include <variant>
#include <vector>

#include "reference/real.hpp"
#include "world/surface.hpp"

namespace flipside::reference {

/// How far a face extends past its end, m and rad: 0 at an end that can be hit; at a smooth joint it covers
/// the gap and the kink of the joint.
template <class R>
struct Reach {
    bool joined = false;
    R gap{}, kink{};

    [[nodiscard]] R of(const R& radius) const {
        return joined ? gap + (kink + 64 * epsilon<R>()) * radius : R(0);
    }
};

template <class R>
struct Line {
    V<R> start, along;  ///< unit
    R length{};
    Reach<R> before, past;
};

template <class R>
struct Curve {
    V<R> center;
    R radius{};
    bool is_circle = false;  ///< the outside of a circle
    bool full = false;       ///< no ends
    bool wide = false;       ///< more than half a turn
    V<R> from, to;           ///< unit, anticlockwise
    Reach<R> before, past;
};

template <class R>
struct Feature {
    std::variant<Line<R>, Curve<R>> is;
    PartIndex part = 0;
    std::uint32_t primitive = 0;  ///< to which it belongs
};

/// All features of parts that are no sensors, in the pose of the scene file, sorted by part.
template <class R>
[[nodiscard]] std::vector<Feature<R>> features_of(const std::vector<Primitive>& primitives,
                                                  const Scene& scene);

/// Turned about a pivot by the angle of the unit vector `turn`.
template <class R>
[[nodiscard]] Feature<R> posed(const Feature<R>& feature, const V<R>& pivot, const V<R>& turn);

/// The same numbers in a wider type.
template <class S, class R>
[[nodiscard]] Feature<S> widened(const Feature<R>& feature) {
    const auto reach = [](const Reach<R>& r) { return Reach<S>{r.joined, S(r.gap), S(r.kink)}; };
    if (const auto* l = std::get_if<Line<R>>(&feature.is))
        return {Line<S>{V<S>(l->start), V<S>(l->along), S(l->length), reach(l->before), reach(l->past)},
                feature.part, feature.primitive};
    const auto& c = std::get<Curve<R>>(feature.is);
    return {Curve<S>{V<S>(c.center), S(c.radius), c.is_circle, c.full, c.wide, V<S>(c.from), V<S>(c.to),
                     reach(c.before), reach(c.past)},
            feature.part, feature.primitive};
}

/// Smallest box around a feature.
template <class R>
[[nodiscard]] Box bounds_of(const Feature<R>& feature);

}  // namespace flipside::reference
