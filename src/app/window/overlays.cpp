#include "app/window/overlays.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "app/window/contender_colour.hpp"

namespace flipside::app {

namespace {

/// Draws what the engine shows of itself.
class Insides : public Inspector {
  public:
    /// `own`: in the colour of the engine, where others show themselves on the same table.
    Insides(Canvas& canvas, const Camera& camera, const Shows& shows, std::optional<sf::Color> own)
        : canvas_(canvas), camera_(camera), shows_(shows), own_(own), width_(canvas.scaled(1)) {}

    [[nodiscard]] bool wants(Topic topic) const override { return has(shows_, show_of(topic)); }
    void box(Topic topic, const Box& box) override { rectangle(box, color_of(topic)); }
    void cell(const Box& box, int count) override {
        const sf::Color color = color_of(Topic::cells);
        rectangle(box, with_alpha(color, count > 0 ? 0.8 : 0.3));
        if (count > 0 && camera_.scale * (box.max.x - box.min.x) > canvas_.scaled(24))
            canvas_.text(camera_.to_pixels({box.min.x, box.max.y}) + Vec2{3, 1}, std::to_string(count),
                         Type::small, color);
    }
    void pair(Vec2 a, Vec2 b) override { segment(Topic::pairs, a, b); }
    void contact(const Contact& contact) override {
        const Vec2 at = camera_.to_pixels(contact.point);
        const Vec2 normal{contact.normal.x, -contact.normal.y};
        canvas_.disc(at, canvas_.scaled(2.5), colour::warning);
        canvas_.arrow(at, at + canvas_.scaled(14) * normal, canvas_.scaled(1.5), colour::warning);
    }
    void segment(Topic topic, Vec2 a, Vec2 b) override {
        canvas_.line(camera_.to_pixels(a), camera_.to_pixels(b), width_, color_of(topic));
    }
    void circle(Topic topic, Vec2 center, double radius) override {
        canvas_.ring(camera_.to_pixels(center), camera_.scale * radius, width_, color_of(topic));
    }
    void text(Topic topic, Vec2 at, std::string_view words) override {
        canvas_.text(camera_.to_pixels(at), words, Type::small, color_of(topic));
    }

  private:
    static Show show_of(Topic topic) {
        switch (topic) {
            case Topic::boxes:
                return Show::boxes;
            case Topic::cells:
                return Show::cells;
            case Topic::pairs:
                return Show::pairs;
            case Topic::contacts:
                return Show::contacts;
            case Topic::sleep:
                break;
        }
        return Show::sleep;
    }
    [[nodiscard]] sf::Color color_of(Topic topic) const {
        switch (topic) {
            case Topic::boxes:
                return own_.value_or(colour::boxes);
            case Topic::cells:
                return own_.value_or(colour::cells);
            case Topic::pairs:
                return with_alpha(own_.value_or(colour::pairs), 0.7);
            case Topic::contacts:
                return colour::warning;
            case Topic::sleep:
                break;
        }
        return colour::quiet;
    }
    void rectangle(const Box& box, sf::Color color) {
        const Vec2 a = camera_.to_pixels(box.min), b = camera_.to_pixels(box.max);
        const Vec2 corners[] = {a, {b.x, a.y}, b, {a.x, b.y}};
        canvas_.stroke(corners, true, width_, color);
    }

    Canvas& canvas_;
    const Camera& camera_;
    const Shows& shows_;
    std::optional<sf::Color> own_;
    double width_;
};

/// Sectors and tangents of a shape's curves.
struct Geometry {
    Canvas& canvas;
    const Camera& camera;
    const Pose& pose;
    bool sectors, tangents;

    void tangent(Vec2 at, Vec2 way) const {
        const Vec2 from = camera.to_pixels(pose.apply(at));
        const Vec2 turned = rotated(way, pose.angle);
        canvas.arrow(from, from + canvas.scaled(22) * Vec2{turned.x, -turned.y}, canvas.scaled(1.2),
                     colour::tangents);
    }
    void operator()(const shape::Segment& s) const {
        if (!tangents) return;
        const Vec2 along = unit(s.b - s.a);
        tangent(s.a, -along);
        tangent(s.b, along);
    }
    void operator()(const shape::Arc& s) const {
        const Vec2 from = from_angle(s.from), to = from_angle(s.to);
        if (sectors)
            for (const Vec2 end : {from, to})
                canvas.line(camera.to_pixels(pose.apply(s.center)),
                            camera.to_pixels(pose.apply(s.center + s.radius * end)), canvas.scaled(1),
                            with_alpha(colour::sectors, 0.8));
        if (!tangents) return;
        tangent(s.center + s.radius * from, -perp(from));
        tangent(s.center + s.radius * to, perp(to));
    }
    void operator()(const shape::Polyline& s) const {
        if (!tangents || s.closed) return;
        tangent(s.points.front(), unit(s.points.front() - s.points[1]));
        tangent(s.points.back(), unit(s.points.back() - s.points[s.points.size() - 2]));
    }
    void operator()(const shape::Compound& s) const {
        for (const Shape& shape : s.of) std::visit(*this, shape.is);
    }
    template <class Other>
    void operator()(const Other&) const {}
};

void draw_tracks(Canvas& canvas, const Camera& camera, const Run& run) {
    const sf::Color color = colour_of(run);
    for (const auto& [number, track] : run.traces().tracks())
        for (std::size_t i = 1; i < track.size(); ++i)
            canvas.line(camera.to_pixels(track[i - 1]), camera.to_pixels(track[i]), canvas.scaled(1.5),
                        with_alpha(color, static_cast<double>(i) / static_cast<double>(track.size())));
}

/// Faster hits spin faster; hits between balls are squares, others crosses.
void draw_reticle(Canvas& canvas, Vec2 at, const Hit& hit, double age, double fade) {
    const double radius = canvas.scaled(9), turn = age * 4 * std::sqrt(hit.speed) + hit.at.x;
    const sf::Color color = with_alpha(colour::lit, fade);
    Vec2 corners[4];
    for (int i = 0; i < 4; ++i) corners[i] = at + radius * from_angle(turn + i * std::numbers::pi / 2);
    if (hit.between_balls) {
        canvas.stroke(corners, true, canvas.scaled(1.5), color);
        return;
    }
    canvas.ring(at, 0.7 * radius, canvas.scaled(1.2), color);
    for (const Vec2 corner : corners) canvas.line(0.5 * (at + corner), corner, canvas.scaled(1.5), color);
}

}  // namespace

void draw_overlays(Canvas& canvas, const Camera& camera, const Run& run, const Look& look) {
    const lab::Session& session = run.session();
    const bool sectors = has(look.shows, Show::sectors), tangents = has(look.shows, Show::tangents);
    for (std::size_t i = 0; (sectors || tangents) && i < session.scene().parts.size(); ++i) {
        const Part& part = session.scene().parts[i];
        const Pose pose = pose_of(part, session.world().parts()[i]);
        std::visit(Geometry{canvas, camera, pose, sectors, tangents}, part.shape.is);
    }
    if (has(look.shows, Show::tracks)) draw_tracks(canvas, camera, run);
}

void draw_marks(Canvas& canvas, const Camera& camera, const Run& run, const Look& look, bool alone) {
    const World& world = run.session().world();
    Insides insides(canvas, camera, look.shows, alone ? std::nullopt : std::optional(colour_of(run)));
    world.inspect(insides);
    if (has(look.shows, Show::velocity))
        for (const Ball& ball : world.balls())
            canvas.arrow(camera.to_pixels(ball.position),
                         camera.to_pixels(ball.position + 0.1 * ball.velocity), canvas.scaled(1.5),
                         colour_of(run));
    for (const Hit& hit : run.traces().hits()) {
        const double age = world.time() - hit.time, fade = 1 - age / Traces::hit_seconds;
        const Vec2 at = camera.to_pixels(hit.at);
        if (has(look.shows, Show::hit_points))
            canvas.disc(at, canvas.scaled(3), with_alpha(colour::lit, fade));
        if (has(look.shows, Show::reticles)) draw_reticle(canvas, at, hit, age, fade);
    }
}

}  // namespace flipside::app
