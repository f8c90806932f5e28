#include "lab/regimes/bare_loop.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "world/surface.hpp"

namespace flipside::lab::regimes {

namespace {

constexpr int substeps = 4;
constexpr float cell_in_diameters = 2;

float single(double value) {
    return static_cast<float>(value);
}

}  // namespace

void BareLoop::Balls::resize(std::size_t n) {
    for (auto* list : {&x, &y, &vx, &vy}) list->resize(n);
}

BareLoop::BareLoop(const Scene& scene)
    : gravity_x_(single(scene.gravity.x)),
      gravity_y_(single(scene.gravity.y)),
      radius_(single(scene.balls.front().radius)),
      bounds_(scene.bounds) {
    const Material& ball = scene.materials[scene.balls.front().material];
    bounce_ = single(mix(ball, ball).restitution);
    const float size = cell_in_diameters * 2 * radius_;
    left_ = single(bounds_.min.x), bottom_ = single(bounds_.min.y), per_cell_ = 1 / size;
    columns_ = static_cast<std::uint32_t>((single(bounds_.max.x) - left_) / size) + 1;
    rows_ = static_cast<std::uint32_t>((single(bounds_.max.y) - bottom_) / size) + 1;
    for (const Primitive& primitive : surface_of(scene)) {
        const float bounce =
            single(mix(ball, scene.materials[scene.parts[primitive.part].material]).restitution);
        if (const auto* s = std::get_if<primitive::Segment>(&primitive.is))
            walls_.push_back({single(s->a.x), single(s->a.y), single(s->b.x), single(s->b.y), 0, bounce});
        if (const auto* c = std::get_if<primitive::Circle>(&primitive.is))
            walls_.push_back({single(c->center.x), single(c->center.y), single(c->center.x),
                              single(c->center.y), single(c->radius), bounce});
    }
    list_walls();
    balls_.resize(scene.balls.size());
    sorted_.resize(scene.balls.size());
    home_.resize(scene.balls.size());
    for (std::size_t i = 0; i < scene.balls.size(); ++i) {
        const Ball& from = scene.balls[i];
        balls_.x[i] = single(from.position.x), balls_.y[i] = single(from.position.y);
        balls_.vx[i] = single(from.velocity.x), balls_.vy[i] = single(from.velocity.y);
    }
}

std::uint32_t BareLoop::cell(float x, float y) const {
    const auto place = [&](float offset, std::uint32_t count) {
        return static_cast<std::uint32_t>(std::clamp(offset * per_cell_, 0.0F, single(count) - 1));
    };
    return place(y - bottom_, rows_) * columns_ + place(x - left_, columns_);
}

/// Every wall in each cell that its box, larger by a ball, overlaps.
void BareLoop::list_walls() {
    const auto each_cell = [&](const Wall& w, auto&& visit) {
        const float margin = w.radius + radius_;
        const std::uint32_t low = cell(std::min(w.ax, w.bx) - margin, std::min(w.ay, w.by) - margin);
        const std::uint32_t high = cell(std::max(w.ax, w.bx) + margin, std::max(w.ay, w.by) + margin);
        for (std::uint32_t row = low / columns_; row <= high / columns_; ++row)
            for (std::uint32_t at = low % columns_; at <= high % columns_; ++at) visit(row * columns_ + at);
    };
    wall_begin_.assign(columns_ * rows_ + 1, 0);
    for (const Wall& w : walls_) each_cell(w, [&](std::uint32_t at) { ++wall_begin_[at]; });
    std::inclusive_scan(wall_begin_.begin(), wall_begin_.end(), wall_begin_.begin());
    walls_in_.resize(wall_begin_.back());
    for (std::uint32_t i = 0; i < walls_.size(); ++i)
        each_cell(walls_[i], [&](std::uint32_t at) { walls_in_[--wall_begin_[at]] = i; });
}

void BareLoop::step(float dt) {
    const float h = dt / substeps;
    for (int i = 0; i < substeps; ++i) {
        for (std::size_t k = 0; k < balls_.x.size(); ++k) {
            balls_.vx[k] += h * gravity_x_;
            balls_.vy[k] += h * gravity_y_;
            balls_.x[k] += h * balls_.vx[k];
            balls_.y[k] += h * balls_.vy[k];
        }
        sort();
        hit_walls();
        hit_balls();
    }
}

void BareLoop::sort() {
    begin_.assign(columns_ * rows_ + 1, 0);
    const auto count = static_cast<std::uint32_t>(balls_.x.size());
    for (std::uint32_t i = 0; i < count; ++i) ++begin_[home_[i] = cell(balls_.x[i], balls_.y[i])];
    std::inclusive_scan(begin_.begin(), begin_.end(), begin_.begin());
    for (std::uint32_t i = count; i-- > 0;) {
        const std::uint32_t to = --begin_[home_[i]];
        sorted_.x[to] = balls_.x[i], sorted_.y[to] = balls_.y[i];
        sorted_.vx[to] = balls_.vx[i], sorted_.vy[to] = balls_.vy[i];
    }
    std::swap(balls_, sorted_);
}

void BareLoop::hit_walls() {
    auto& [x, y, vx, vy] = balls_;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const std::uint32_t at = cell(x[i], y[i]);
        for (std::uint32_t k = wall_begin_[at]; k < wall_begin_[at + 1]; ++k) {
            const Wall& w = walls_[walls_in_[k]];
            const float dx = w.bx - w.ax, dy = w.by - w.ay, whole = dx * dx + dy * dy;
            const float along = (x[i] - w.ax) * dx + (y[i] - w.ay) * dy;
            const float part = whole > 0 ? std::clamp(along / whole, 0.0F, 1.0F) : 0;
            const float nx = x[i] - w.ax - part * dx, ny = y[i] - w.ay - part * dy;
            const float reach = radius_ + w.radius, square = nx * nx + ny * ny;
            if (square >= reach * reach || square == 0) continue;
            const float per = 1 / std::sqrt(square), out = reach * per - 1;
            x[i] += out * nx, y[i] += out * ny;
            const float speed = (vx[i] * nx + vy[i] * ny) * per;
            if (speed >= 0) continue;
            const float change = -(1 + w.bounce) * speed * per;
            vx[i] += change * nx, vy[i] += change * ny;
        }
    }
}

/// Each ball with the later ones of its cell, of the next one in the row, and of three in the row above.
void BareLoop::hit_balls() {
    for (std::uint32_t row = 0; row < rows_; ++row)
        for (std::uint32_t column = 0; column < columns_; ++column) {
            const std::uint32_t at = row * columns_ + column;
            const std::uint32_t past = at + (column + 1 < columns_ ? 2 : 1);
            for (std::uint32_t i = begin_[at]; i < begin_[at + 1]; ++i) {
                for (std::uint32_t k = i + 1; k < begin_[past]; ++k) hit(i, k);
                if (row + 1 == rows_) continue;
                const std::uint32_t above = at - (column > 0 ? 1 : 0) + columns_;
                for (std::uint32_t k = begin_[above]; k < begin_[past + columns_]; ++k) hit(i, k);
            }
        }
}

void BareLoop::hit(std::uint32_t i, std::uint32_t k) {
    auto& [x, y, vx, vy] = balls_;
    const float dx = x[k] - x[i], dy = y[k] - y[i], square = dx * dx + dy * dy;
    const float reach = 2 * radius_;
    if (square >= reach * reach || square == 0) return;
    const float per = 1 / std::sqrt(square), out = 0.5F * (reach * per - 1);
    x[i] -= out * dx, y[i] -= out * dy;
    x[k] += out * dx, y[k] += out * dy;
    const float speed = ((vx[k] - vx[i]) * dx + (vy[k] - vy[i]) * dy) * per;
    if (speed >= 0) return;
    const float change = 0.5F * (1 + bounce_) * speed * per;
    vx[i] += change * dx, vy[i] += change * dy;
    vx[k] -= change * dx, vy[k] -= change * dy;
}

std::size_t BareLoop::lost() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < balls_.x.size(); ++i)
        count += bounds_.contains({balls_.x[i], balls_.y[i]}) ? 0 : 1;
    return count;
}

}  // namespace flipside::lab::regimes
