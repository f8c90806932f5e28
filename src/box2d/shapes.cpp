#include "box2d/shapes.hpp"

#include <algorithm>
#include <numbers>
#include <span>

#include <box2d/b2_body.h>
#include <box2d/b2_circle_shape.h>
#include <box2d/b2_collision.h>
#include <box2d/b2_edge_shape.h>
#include <box2d/b2_polygon_shape.h>

namespace flipside::box2d {

namespace {

/// Chords over an angle of `sweep` rad so that none strays further than `error` from the arc: the
/// sagitta of a chord over δ is R(1 − cos δ/2) = 2R·sin²(δ/4).
int chord_count(double radius, double sweep, double error) {
    constexpr int most = 4096;
    const double sagitta = std::min(error, radius);
    const double quarter = math::atan2(std::sqrt(sagitta), std::sqrt(2 * radius - sagitta));
    const double count = std::ceil(sweep / (4 * quarter));
    return static_cast<int>(std::clamp(count, 2.0, double{most}));
}

struct Builder {
    b2Body& body;
    PartIndex part;
    bool sensor;
    const Units& frame;
    double chord_error;

    void add(const b2Shape& shape, bool cornerless = false) const {
        b2FixtureDef fixture;
        fixture.shape = &shape;
        fixture.isSensor = sensor;
        fixture.userData.pointer = Tag{Other::part(part), cornerless}.packed();
        body.CreateFixture(&fixture);
    }

    void disc(Vec2 center, double radius) const {
        b2CircleShape circle;
        circle.m_p = frame.point(center);
        circle.m_radius = frame.distance(radius);
        add(circle);
    }
    /// An edge from a to b between neighbours that come from `before` and go on to `after`.
    void edge(Vec2 before, Vec2 a, Vec2 b, Vec2 after, bool one_sided = false) const {
        b2EdgeShape shape;
        shape.SetOneSided(frame.point(before), frame.point(a), frame.point(b), frame.point(after));
        shape.m_oneSided = one_sided;
        shape.m_radius = 0;
        add(shape);
    }
    /// At most b2_maxPolygonVertices points, anticlockwise. Fills the shape directly: Set() would weld
    /// near corners and reorder the others.
    void polygon(std::span<const Vec2> points, bool cornerless) const {
        b2PolygonShape shape;
        shape.m_count = static_cast<int32>(points.size());
        Vec2 mean;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec2 along = unit(points[(i + 1) % points.size()] - points[i]);
            shape.m_vertices[i] = frame.point(points[i]);
            shape.m_normals[i] = {static_cast<float>(along.y), static_cast<float>(-along.x)};
            mean += points[i] / static_cast<double>(points.size());
        }
        shape.m_centroid = frame.point(mean);
        shape.m_radius = 0;
        add(shape, cornerless);
    }

    void operator()(const primitive::Point& p) const { disc(p.at, 0); }
    void operator()(const primitive::Segment& s) const {
        edge(s.a - (s.b - s.a), s.a, s.b, s.b + (s.b - s.a));
    }
    void operator()(const primitive::Arc& arc) const {
        const double sweep = arc.to - arc.from;
        const int count = chord_count(arc.radius, sweep, chord_error);
        const auto corner = [&](int i) {
            return arc.center + arc.radius * from_angle(arc.from + sweep * i / count);
        };
        // Beyond its ends an open arc goes on along its tangent, a full circle along its next chord.
        const bool closed = sweep >= 2 * std::numbers::pi;
        const double step = arc.radius * sweep / count;
        const Vec2 before = closed ? corner(-1) : corner(0) - step * perp(from_angle(arc.from));
        const Vec2 after = closed ? corner(1) : corner(count) + step * perp(from_angle(arc.to));
        for (int i = 0; i < count; ++i)
            edge(i == 0 ? before : corner(i - 1), corner(i), corner(i + 1),
                 i + 1 == count ? after : corner(i + 2));
    }
    void operator()(const primitive::Circle& c) const { disc(c.center, c.radius); }
    void operator()(const primitive::Polygon& p) const {
        const std::size_t n = p.points.size();
        if (n <= b2_maxPolygonVertices) return polygon(p.points, false);
        if (!sensor) {
            // Sides face outwards: Box2D's normal is to the right of a → b.
            for (std::size_t i = 0; i < n; ++i)
                edge(p.points[(i + n - 1) % n], p.points[i], p.points[(i + 1) % n], p.points[(i + 2) % n],
                     true);
            return;
        }
        for (std::size_t first = 1; first + 1 < n; first += b2_maxPolygonVertices - 2) {
            std::vector<Vec2> fan{p.points[0]};
            for (std::size_t i = first; i < std::min(n, first + b2_maxPolygonVertices - 1); ++i)
                fan.push_back(p.points[i]);
            polygon(fan, false);
        }
    }
    void operator()(const primitive::Taper& t) const {
        disc(t.a, t.radius_a);
        disc(t.b, t.radius_b);
        // The outer tangents touch both circles where the outward normal n has n·(b−a) = ra − rb.
        const Vec2 axis = t.b - t.a;
        const double sine = (t.radius_a - t.radius_b) / length(axis);
        const Vec2 along = unit(axis), aside = std::sqrt(1 - sine * sine) * perp(along);
        const Vec2 left = sine * along + aside, right = sine * along - aside;
        const Vec2 corners[] = {t.a + t.radius_a * right, t.b + t.radius_b * right, t.b + t.radius_b * left,
                                t.a + t.radius_a * left};
        polygon(corners, true);
    }
};

}  // namespace

void add_primitive(b2Body& body, const Primitive& primitive, bool sensor, const Units& frame,
                   double chord_error) {
    std::visit(Builder{body, primitive.part, sensor, frame, chord_error}, primitive.is);
}

bool at_joint(const b2Fixture& fixture, const b2Manifold& manifold, b2Vec2 center) {
    if (fixture.GetType() == b2Shape::e_polygon) {
        // Box2D calls a contact with a corner one with a face, too, but puts it at the corner.
        const auto& polygon = static_cast<const b2PolygonShape&>(*fixture.GetShape());
        const auto end = polygon.m_vertices + polygon.m_count;
        return Tag::of(fixture).cornerless && std::find(polygon.m_vertices, end, manifold.localPoint) != end;
    }
    if (fixture.GetType() != b2Shape::e_edge || manifold.type != b2Manifold::e_circles) return false;
    const auto& edge = static_cast<const b2EdgeShape&>(*fixture.GetShape());
    // The disc is beyond an end: does it stand over the neighbour there?
    if (manifold.localPoint == edge.m_vertex1)
        return b2Dot(edge.m_vertex1 - edge.m_vertex0, edge.m_vertex1 - center) > 0;
    return b2Dot(edge.m_vertex3 - edge.m_vertex2, center - edge.m_vertex2) > 0;
}

}  // namespace flipside::box2d
