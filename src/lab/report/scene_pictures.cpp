#include "lab/report/scene_pictures.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lab/contenders/engines.hpp"
#include "lab/files/assets.hpp"
#include "lab/files/text_stream.hpp"
#include "lab/report/markup.hpp"
#include "lab/session/run.hpp"
#include "lab/session/session.hpp"
#include "world/math.hpp"
#include "world/script_file.hpp"
#include "world/surface.hpp"

namespace flipside::lab::report {

namespace {

/// Shapes as SVG; y points down there.
class Drawing {
  public:
    explicit Drawing(std::ostream& out) : out_(out) {}

    void operator()(const primitive::Point&) const {}
    void operator()(const primitive::Segment& s) const {
        out_ << "<path d=\"M" << s.a.x << ' ' << -s.a.y << 'L' << s.b.x << ' ' << -s.b.y << "\"/>\n";
    }
    void operator()(const primitive::Arc& arc) const {
        out_ << "<path d=\"";
        constexpr int chords = 32;
        for (int i = 0; i <= chords; ++i) {
            const double angle = arc.from + (arc.to - arc.from) * i / chords;
            out_ << (i == 0 ? 'M' : 'L') << arc.center.x + arc.radius * math::cos(angle) << ' '
                 << -(arc.center.y + arc.radius * math::sin(angle));
        }
        out_ << "\"/>\n";
    }
    void operator()(const primitive::Circle& c) const { disc(c.center, c.radius, "part"); }
    void operator()(const primitive::Polygon& polygon) const {
        out_ << "<path class=\"part\" d=\"";
        for (std::size_t i = 0; i < polygon.points.size(); ++i)
            out_ << (i == 0 ? 'M' : 'L') << polygon.points[i].x << ' ' << -polygon.points[i].y;
        out_ << "Z\"/>\n";
    }
    /// Its ends and the line between them as wide as they are: near enough for a picture.
    void operator()(const primitive::Taper& taper) const {
        disc(taper.a, taper.radius_a, "part");
        disc(taper.b, taper.radius_b, "part");
        const Vec2 along = taper.b - taper.a;
        const Vec2 side = 1 / length(along) * Vec2{-along.y, along.x};
        operator()(primitive::Polygon{{taper.a + taper.radius_a * side, taper.a - taper.radius_a * side,
                                       taper.b - taper.radius_b * side, taper.b + taper.radius_b * side}});
    }
    void disc(Vec2 at, double radius, const char* kind) const {
        out_ << "<circle class=\"" << kind << "\" cx=\"" << at.x << "\" cy=\"" << -at.y << "\" r=\"" << radius
             << "\"/>\n";
    }

  private:
    std::ostream& out_;
};

Picture picture_of(const sweep::Variant& variant) {
    const auto scene = sweep::load(variant);
    const auto script = script_beside(scene_file(variant.scene));
    std::vector<Session> one;
    one.emplace_back(scene, *engines().front(), settings_for(*engines().front(), *scene));
    const double until = std::max(variant.from, 0.5);  // s, so that something has happened
    run(one, Timeline(0, until, step_for(*scene)), script ? load_script(*script, *scene) : Script{},
        [](const Session&, std::uint64_t, double) {});
    return {scene->name, scene->about, scene_svg(*scene, one.front().world().balls())};
}

}  // namespace

std::string scene_svg(const Scene& scene, std::span<const Ball> balls) {
    const Box seen = scene.camera.value_or(scene.bounds);
    const Vec2 size = seen.max - seen.min;
    TextStream out;
    out.precision(5);
    out << "<svg role=\"img\" aria-label=\"" << escape("The scene " + scene.name) << "\" viewBox=\""
        << seen.min.x << ' ' << -seen.max.y << ' ' << size.x << ' ' << size.y << "\"><g>\n";
    const Drawing drawing(out);
    for (const Primitive& primitive : surface_of(scene)) std::visit(drawing, primitive.is);
    for (const Ball& ball : balls) drawing.disc(ball.position, ball.radius, "ball");
    out << "</g></svg>\n";
    return out.str();
}

std::vector<Picture> scene_pictures(std::span<const sweep::Variant> variants) {
    std::vector<Picture> pictures;
    std::vector<std::string> seen;
    for (const sweep::Variant& variant : variants) {
        if (std::ranges::find(seen, variant.scene) != seen.end()) continue;
        seen.push_back(variant.scene);
        pictures.push_back(picture_of(variant));
    }
    return pictures;
}

}  // namespace flipside::lab::report
