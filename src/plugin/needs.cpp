#include "plugin/needs.hpp"

#include <algorithm>
#include <functional>
#include <optional>

#include "flipside/engine.h"
#include "world/json_file.hpp"
#include "world/table.hpp"

namespace flipside::plugin {

namespace {

constexpr Feature all[] = {
    {FLIPSIDE_POINTS, "points and corners"},
    {FLIPSIDE_SEGMENTS, "segments"},
    {FLIPSIDE_ARCS, "arcs"},
    {FLIPSIDE_CIRCLES, "circles"},
    {FLIPSIDE_POLYGONS, "polygons"},
    {FLIPSIDE_TAPERS, "capsules and flippers"},
    {FLIPSIDE_BALL_PAIRS, "several balls"},
    {FLIPSIDE_FRICTION, "friction"},
    {FLIPSIDE_KICKS, "kicks"},
    {FLIPSIDE_DAMPING, "damping"},
    {FLIPSIDE_MOVING, "moving parts"},
    {FLIPSIDE_SENSORS, "sensors"},
    {FLIPSIDE_LAYERS, "layers"},
    {FLIPSIDE_GATES, "gates"},
};

/// What first needs a feature; nothing where nothing does.
using Reason = std::optional<std::string>;

/// Answers, feature by feature, what of a scene needs it.
class Needs {
  public:
    Needs(const Scene& scene, const std::vector<Primitive>& primitives)
        : scene_(scene), primitives_(primitives) {
        for (std::size_t i = 0; i < scene.balls.size(); ++i)
            balls_.push_back({&scene.balls[i], "ball " + std::to_string(i)});
        if (scene.launcher) balls_.push_back({&scene.launcher->ball, "the launcher's balls"});
    }

    [[nodiscard]] Reason operator()(std::uint64_t feature) const {
        switch (feature) {
            case FLIPSIDE_POINTS:
                return primitive<primitive::Point>();
            case FLIPSIDE_SEGMENTS:
                return primitive<primitive::Segment>();
            case FLIPSIDE_ARCS:
                return primitive<primitive::Arc>();
            case FLIPSIDE_CIRCLES:
                return primitive<primitive::Circle>();
            case FLIPSIDE_POLYGONS:
                return primitive<primitive::Polygon>();
            case FLIPSIDE_TAPERS:
                return primitive<primitive::Taper>();
            case FLIPSIDE_BALL_PAIRS:
                return scene_.balls.size() > 1 || scene_.launcher ? Reason(balls_.back().name) : std::nullopt;
            case FLIPSIDE_FRICTION:
                return friction();
            case FLIPSIDE_KICKS:
                return material(&Material::kick);
            case FLIPSIDE_DAMPING:
                return scene_.damping > 0 ? Reason("the whole scene") : std::nullopt;
            case FLIPSIDE_MOVING:
                return part(Table::moves);
            case FLIPSIDE_SENSORS:
                return part(&Part::sensor);
            case FLIPSIDE_GATES:
                return part([](const Part& one) { return gate_of(one) != nullptr; });
            case FLIPSIDE_LAYERS:
                return layers();
            default:
                return std::nullopt;
        }
    }

  private:
    struct NamedBall {
        const Ball* ball;
        std::string name;
    };

    static std::string name_of(const Part& part) { return "part " + in_quotes(part.name); }
    [[nodiscard]] Reason part(const std::function<bool(const Part&)>& needs) const {
        const auto at = std::ranges::find_if(scene_.parts, needs);
        return at == scene_.parts.end() ? std::nullopt : Reason(name_of(*at));
    }
    template <class Kind>
    [[nodiscard]] Reason primitive() const {
        const auto at = std::ranges::find_if(
            primitives_, [](const Primitive& one) { return std::holds_alternative<Kind>(one.is); });
        return at == primitives_.end() ? std::nullopt : Reason(name_of(scene_.parts[at->part]));
    }
    /// Of a part or ball for which this is above 0.
    [[nodiscard]] Reason material(double Material::*value) const {
        const auto has = [&](const auto& thing) { return scene_.materials[thing.material].*value > 0; };
        if (Reason found = part([&](const Part& one) { return has(one); })) return found;
        const auto at = std::ranges::find_if(balls_, [&](const NamedBall& one) { return has(*one.ball); });
        return at == balls_.end() ? std::nullopt : Reason(at->name);
    }
    /// Takes two: µ is the root of the product, and a ball is one of them.
    [[nodiscard]] Reason friction() const {
        const auto rough = [&](const NamedBall& one) {
            return scene_.materials[one.ball->material].friction > 0;
        };
        const auto ball = std::ranges::find_if(balls_, rough);
        if (ball == balls_.end()) return std::nullopt;
        if (Reason found = part(
                [&](const Part& one) { return !one.sensor && scene_.materials[one.material].friction > 0; }))
            return found;
        return scene_.launcher || std::count_if(balls_.begin(), balls_.end(), rough) > 1 ? Reason(ball->name)
                                                                                         : std::nullopt;
    }
    /// Of two things that do not meet.
    [[nodiscard]] Reason layers() const {
        std::uint32_t layers = 0, masks = ~0U;
        const auto see = [&](const auto& thing) {
            layers |= thing.layer;
            masks &= thing.collides_with;
        };
        std::ranges::for_each(scene_.parts, see);
        for (const NamedBall& one : balls_) see(*one.ball);
        if ((layers & ~masks) == 0) return std::nullopt;
        const auto shuns = [&](const auto& thing) { return (layers & ~thing.collides_with) != 0; };
        if (Reason found = part([&](const Part& one) { return shuns(one); })) return found;
        const auto at = std::ranges::find_if(balls_, [&](const NamedBall& one) { return shuns(*one.ball); });
        return at->name;
    }

    const Scene& scene_;
    const std::vector<Primitive>& primitives_;
    std::vector<NamedBall> balls_;
};

}  // namespace

std::span<const Feature> features() {
    return all;
}

std::string missing_features(const Scene& scene, const std::vector<Primitive>& primitives,
                             std::uint64_t offered) {
    const Needs needs(scene, primitives);
    std::string missing;
    for (const Feature& feature : all) {
        if ((offered & feature.bit) != 0) continue;
        if (const Reason reason = needs(feature.bit))
            missing += (missing.empty() ? "" : ", ") + std::string(feature.name) + " (" + *reason + ")";
    }
    return missing;
}

}  // namespace flipside::plugin
