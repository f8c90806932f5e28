#include "app/sound/sources.hpp"

#include <algorithm>
#include <cmath>

#include "app/window/playfield/nearest.hpp"
#include "world/surface.hpp"

namespace flipside::app::sound {

namespace {

/// What stands by itself and is small enough for a ball to go round it.
bool is_peg(const Part& part) {
    const auto& shape = part.shape.is;
    return std::holds_alternative<shape::Point>(shape) || std::holds_alternative<shape::Circle>(shape) ||
           std::holds_alternative<shape::Capsule>(shape);
}

Source source_of(const Part& part, const Material& material) {
    if (part.sensor) return Source::rollover;
    if (std::holds_alternative<motion::Flip>(part.motion)) return Source::flipper;
    if (part.target) return Source::target;
    if (material.kick > 0)
        return std::holds_alternative<shape::Circle>(part.shape.is) ? Source::bumper : Source::slingshot;
    return is_peg(part) ? Source::post : Source::wall;
}

/// The longer side of the box around each part, m.
std::vector<double> sizes_of(const Scene& scene) {
    std::vector<double> sizes(scene.parts.size());
    for (const Primitive& primitive : surface_of(scene)) {
        const Box box = box_of(primitive);
        double& size = sizes[primitive.part];
        size = std::max({size, box.max.x - box.min.x, box.max.y - box.min.y});
    }
    return sizes;
}

}  // namespace

double pitch_of_size(double size, Source source) {
    return std::clamp(std::sqrt(timbre_of(source).size / std::max(size, 1e-6)), 0.5, 2.0);
}

std::vector<PartSound> part_sounds(const Scene& scene) {
    const std::vector<double> sizes = sizes_of(scene);
    std::vector<PartSound> sounds;
    for (std::size_t i = 0; i < scene.parts.size(); ++i) {
        const Part& part = scene.parts[i];
        const Material& material = scene.materials[part.material];
        const Source source = source_of(part, material);
        sounds.push_back({source, pitch_of_size(sizes[i], source), material.friction,
                          std::min(1.0, material.restitution)});
    }
    return sounds;
}

}  // namespace flipside::app::sound
