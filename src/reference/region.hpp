#pragma once
/// Where the centre of a ball is when the ball is in a sensor, or in a gate: the shape, grown by the ball's
/// radius. It is taken apart into regions (discs, convex polygons, bands along arcs), each the common part of
/// a few smooth conditions c(q) ≥ 0. A ball enters at the first time at which all conditions of some region
/// hold, and leaves at the first time at which none of its regions does.

#include "reference/time_of_impact.hpp"

namespace flipside::reference {

template <class R>
struct Region {
    /// n·(q − at) ≤ offset + share·radius
    struct Plane {
        V<R> n, at;
        R offset{};
        int share = 0;
    };
    struct Disc {
        V<R> center;
        R radius{};
    };
    struct Polygon {
        std::vector<Plane> planes;
    };
    /// Along at most half a turn.
    struct Band {
        Curve<R> arc;
    };
    std::variant<Disc, Polygon, Band> is;
};

/// The regions of one part.
template <class R>
[[nodiscard]] std::vector<Region<R>> regions_of(const std::vector<Primitive>& primitives, PartIndex part);

/// Whether the ball is in the part now.
template <class R>
[[nodiscard]] bool inside(const std::vector<Region<R>>& regions, const View<R>& view, const R& radius,
                          const R& time);
/// First time in [from, until] at which a ball that is outside is inside; never otherwise.
template <class R>
[[nodiscard]] R enters(const std::vector<Region<R>>& regions, const View<R>& view, const R& radius,
                       const R& from, const R& until);
/// First time in [from, until] at which a ball that is inside is outside.
template <class R>
[[nodiscard]] R leaves(const std::vector<Region<R>>& regions, const View<R>& view, const R& radius,
                       const R& from, const R& until);

}  // namespace flipside::reference
