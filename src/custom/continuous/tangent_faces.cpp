#include "custom/continuous/tangent_faces.hpp"

namespace flipside::custom {

bool TangentFaces::above(const Feature& feature) const {
    const auto below = [&](Vec2 center, double radius) {
        for (std::size_t i = 0; i < count_; ++i) {
            const Vec2 from_face = center - faces_[i].at;
            const double size = std::abs(center.x) + std::abs(center.y) + length(from_face) + radius;
            if (dot(from_face, faces_[i].normal) + radius <= 64 * 0x1p-53 * size) return true;
        }
        return false;
    };
    if (const auto* circle = std::get_if<Circle>(&feature.is)) return below(circle->center, circle->radius);
    if (const auto* arc = std::get_if<Arc>(&feature.is)) return below(arc->center, arc->radius);
    return false;
}

}  // namespace flipside::custom
