#include "plugin/handover.hpp"

namespace flipside::plugin {

namespace {

flipside_part part_of(const Part& part, const PartState& state, const Pose& pose) {
    flipside_part out{};
    if (part.sensor) out.flags |= FLIPSIDE_PART_SENSOR;
    if (Table::moves(part)) out.flags |= FLIPSIDE_PART_MOVES;
    if (const shape::Gate* gate = gate_of(part)) {
        out.flags |= FLIPSIDE_PART_GATE | (state.open ? FLIPSIDE_PART_OPEN : 0U);
        out.normal = as_c(gate->normal);
    }
    out.material = part.material;
    out.layer = part.layer;
    out.collides_with = part.collides_with;
    out.pivot = as_c(pose.pivot);
    out.angle = pose.angle;
    return out;
}

}  // namespace

flipside_vec as_c(Vec2 v) {
    return {v.x, v.y};
}

flipside_ball as_c(const Ball& ball) {
    return {
        {ball.number, ball.asleep ? 1U : 0U, as_c(ball.position), as_c(ball.velocity), ball.angle, ball.spin},
        ball.radius,
        ball.mass,
        ball.material,
        ball.layer,
        ball.collides_with,
        0};
}

void note_motions(const Table& table, std::vector<flipside_motion>& motions) {
    motions.clear();
    for (const PartIndex part : table.moving_parts()) {
        const Table::Turning now = table.turning(part, 0);
        motions.push_back({part, 0, now.pose.angle, now.rate, now.until_stop});
    }
}

Handover::Handover(const Table& table, const std::vector<Primitive>& primitives,
                   std::span<const Ball> balls) {
    const Scene& scene = table.scene();
    name_ = scene.name;
    numbers_.time = table.time();
    numbers_.gravity = as_c(scene.gravity);
    numbers_.damping = scene.damping;
    numbers_.rest_speed = scene.rest_speed;
    numbers_.bounds_min = as_c(scene.bounds.min);
    numbers_.bounds_max = as_c(scene.bounds.max);
    for (const Material& material : scene.materials)
        materials_.push_back({material.restitution, material.friction, material.kick});
    for (const Ball& ball : balls) balls_.push_back(as_c(ball));
    for (PartIndex i = 0; i < scene.parts.size(); ++i) {
        parts_.push_back(part_of(scene.parts[i], table.parts()[i], table.pose(i)));
        part_names_.push_back(scene.parts[i].name);
    }
    for (const Primitive& primitive : primitives)
        if (!table.parts()[primitive.part].down) add(primitive);
    for (const Blocked& blocked : table.blocked()) blocked_.push_back({blocked.gate, blocked.ball});
}

void Handover::add(const Primitive& primitive) {
    flipside_primitive out{};
    out.part = primitive.part;
    struct Fill {
        flipside_primitive& out;
        std::vector<flipside_vec>& points;

        void operator()(const primitive::Point& p) const {
            out.kind = FLIPSIDE_POINT;
            out.a = as_c(p.at);
        }
        void operator()(const primitive::Segment& s) const {
            out.kind = FLIPSIDE_SEGMENT;
            out.a = as_c(s.a);
            out.b = as_c(s.b);
        }
        void operator()(const primitive::Arc& arc) const {
            out.kind = FLIPSIDE_ARC;
            out.a = as_c(arc.center);
            out.radius_a = arc.radius;
            out.from = arc.from;
            out.to = arc.to;
        }
        void operator()(const primitive::Circle& c) const {
            out.kind = FLIPSIDE_CIRCLE;
            out.a = as_c(c.center);
            out.radius_a = c.radius;
        }
        void operator()(const primitive::Polygon& p) const {
            out.kind = FLIPSIDE_POLYGON;
            out.first_point = static_cast<std::uint32_t>(points.size());
            out.point_count = static_cast<std::uint32_t>(p.points.size());
            for (const Vec2 point : p.points) points.push_back(as_c(point));
        }
        void operator()(const primitive::Taper& t) const {
            out.kind = FLIPSIDE_TAPER;
            out.a = as_c(t.a);
            out.b = as_c(t.b);
            out.radius_a = t.radius_a;
            out.radius_b = t.radius_b;
        }
    };
    std::visit(Fill{out, points_}, primitive.is);
    primitives_.push_back(out);
}

void Handover::write(Writer& out) const {
    out.text(name_);
    out.value(numbers_);
    out.array(std::span(materials_));
    out.array(std::span(balls_));
    out.array(std::span(parts_));
    for (const std::string& part : part_names_) out.text(part);
    out.array(std::span(primitives_));
    out.array(std::span(points_));
    out.array(std::span(blocked_));
}

void Handover::read(Reader& in) {
    name_ = in.text();
    numbers_ = in.value<flipside_scene>();
    in.array(materials_);
    in.array(balls_);
    in.array(parts_);
    part_names_.clear();
    for (std::size_t i = 0; i < parts_.size(); ++i) part_names_.push_back(in.text());
    in.array(primitives_);
    in.array(points_);
    in.array(blocked_);
}

flipside_scene Handover::view(const std::string& json) {
    for (std::size_t i = 0; i < parts_.size(); ++i) parts_[i].name = part_names_[i].c_str();
    const auto count = [](const auto& list) { return static_cast<std::uint32_t>(list.size()); };
    flipside_scene scene = numbers_;
    scene.size = sizeof scene;
    scene.material_count = count(materials_);
    scene.ball_count = count(balls_);
    scene.part_count = count(parts_);
    scene.primitive_count = count(primitives_);
    scene.point_count = count(points_);
    scene.blocked_count = count(blocked_);
    scene.name = name_.c_str();
    scene.json = json.c_str();
    scene.materials = materials_.data();
    scene.balls = balls_.data();
    scene.parts = parts_.data();
    scene.primitives = primitives_.data();
    scene.points = points_.data();
    scene.blocked = blocked_.data();
    return scene;
}

}  // namespace flipside::plugin
