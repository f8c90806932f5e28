#include "custom/continuous/glides.hpp"

namespace flipside::custom {

bool Glides::above(const Feature& feature) const {
    const auto below = [&](Vec2 center, double radius) {
        for (std::size_t i = 0; i < count_; ++i) {
            const Vec2 from_face = center - faces_[i].at;
            const double size = std::abs(center.x) + std::abs(center.y) + length(from_face) + radius;
            if (dot(from_face, faces_[i].normal) + radius <= 64 * 0x1p-53 * size) return true;
        }
        return false;
    };
    if (const auto* round = std::get_if<Round>(&feature.is)) return below(round->center, round->radius);
    if (const auto* bow = std::get_if<Bow>(&feature.is)) return below(bow->center, bow->radius);
    return false;
}

}  // namespace flipside::custom
