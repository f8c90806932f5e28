#include "custom/layout.hpp"

#include <algorithm>

namespace flipside::custom {

Layout::Layout(const Scene& scene) : scene_(scene), primitives_(surface_of(scene)) {
    const auto moving =
        std::stable_partition(primitives_.begin(), primitives_.end(),
                              [&](const Primitive& p) { return !Table::moves(scene.parts[p.part]); });
    still_ = static_cast<PrimitiveIndex>(moving - primitives_.begin());
    for (PrimitiveIndex i = 0; i < still_; ++i) still_proxies_.push_back(proxy_of(primitives_[i]));
    for (const Primitive& primitive : primitives_) {
        const Part& part = scene.parts[primitive.part];
        always_collides_.push_back(!part.sensor && !part.target && gate_of(part) == nullptr);
    }
    for (PartIndex part = 0; part < scene.parts.size(); ++part)
        if (gate_of(scene.parts[part]) != nullptr) gates_.push_back(part);
}

Proxy Layout::proxy_of(const Primitive& primitive, const Pose& pose) const {
    const Part& part = scene_.parts[primitive.part];
    return {bounds_of(primitive, pose), part.layer, part.collides_with, false};
}

bool Layout::should_collide(const Table& table, PrimitiveIndex i, const Pose& pose, const Ball& ball) const {
    if (always_collides_[i]) return true;
    const PartIndex part = primitives_[i].part;
    if (scene_.parts[part].sensor || table.parts()[part].down) return false;
    return gate_of(scene_.parts[part]) == nullptr || !table.lets_through(part, pose, table.rate(part), ball);
}

void Layout::fill_proxies(const Table& table, std::span<const Ball> balls, double ahead, double margin,
                          std::vector<Proxy>& moving) const {
    moving.clear();
    for (PrimitiveIndex i = still_; i < primitives_.size(); ++i)
        moving.push_back(proxy_of(primitives_[i], table.pose(primitives_[i].part, ahead)));
    for (const Ball& ball : balls)
        moving.push_back(
            {bounds_of(ball.position, ball.radius * (1 + margin)), ball.layer, ball.collides_with, true});
}

}  // namespace flipside::custom
