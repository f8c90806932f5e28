#include "app/window/playfield/chart.hpp"

#include <algorithm>
#include <cmath>

#include "app/window/playfield/nearest.hpp"
#include "world/table.hpp"

namespace flipside::app {

namespace {

constexpr double most_samples = 6e4;

/// A ball's radius, but no less than a 48th of the table's lesser side: closer lines are not told apart.
double interval_of(const Scene& scene) {
    const Vec2 size = scene.bounds.max - scene.bounds.min;
    const double least = std::min(size.x, size.y) / 48;
    const double radius = scene.launcher        ? scene.launcher->ball.radius
                          : scene.balls.empty() ? least
                                                : scene.balls.front().radius;
    return std::max(radius, least);
}

class Survey {
  public:
    explicit Survey(const Scene& scene) : primitives_(surface_of(scene)) {
        std::erase_if(primitives_, [&](const Primitive& one) { return !is_coast(scene.parts[one.part]); });
        chart_.box = scene.bounds;
        chart_.interval = interval_of(scene);
        const Vec2 size = chart_.box.max - chart_.box.min;
        chart_.spacing = std::max(chart_.interval / 3, std::sqrt(size.x * size.y / most_samples));
        chart_.columns = static_cast<int>(size.x / chart_.spacing) + 2;
        chart_.rows = static_cast<int>(size.y / chart_.spacing) + 2;
        const auto samples = static_cast<std::size_t>(chart_.columns) * static_cast<std::size_t>(chart_.rows);
        chart_.depth.assign(samples, (Chart::levels + 1) * chart_.interval);
        owner_.assign(samples, 0);
    }

    Chart chart() {
        for (std::size_t i = 0; i < primitives_.size(); ++i) sound_around(i);
        for (int row = 0; row + 1 < chart_.rows; ++row)
            for (int column = 0; column + 1 < chart_.columns; ++column) draw_cell(column, row);
        return std::move(chart_);
    }

  private:
    struct Node {
        int column, row;
    };
    [[nodiscard]] Vec2 place(Node n) const {
        return chart_.box.min + chart_.spacing * Vec2{double(n.column), double(n.row)};
    }
    [[nodiscard]] std::size_t index(Node n) const {
        return static_cast<std::size_t>(n.row) * static_cast<std::size_t>(chart_.columns) +
               static_cast<std::size_t>(n.column);
    }

    /// What a primitive can be nearest to lies within the greatest depth of it.
    void sound_around(std::size_t primitive) {
        const double reach = Chart::levels * chart_.interval;
        const Box box = box_of(primitives_[primitive]);
        const auto sample = [&](double metres, int most) {
            return static_cast<int>(std::clamp(metres / chart_.spacing, 0.0, double(most)));
        };
        const Vec2 low = box.min - Vec2{reach, reach} - chart_.box.min;
        const Vec2 high = box.max + Vec2{reach, reach} - chart_.box.min;
        const Node last{sample(high.x, chart_.columns - 1), sample(high.y, chart_.rows - 1)};
        for (int row = sample(low.y, chart_.rows - 1); row <= last.row; ++row)
            for (int column = sample(low.x, chart_.columns - 1); column <= last.column; ++column) {
                const Vec2 here = place({column, row});
                const double depth = length(here - nearest_of(primitives_[primitive], here));
                const std::size_t at = index({column, row});
                if (depth >= chart_.depth[at]) continue;
                chart_.depth[at] = depth;
                owner_[at] = primitive;
            }
    }

    void draw_cell(int column, int row) {
        const Node corners[] = {{column, row}, {column + 1, row}, {column + 1, row + 1}, {column, row + 1}};
        double least = chart_.depth[index(corners[0])], most = least;
        for (const Node corner : corners) {
            least = std::min(least, chart_.depth[index(corner)]);
            most = std::max(most, chart_.depth[index(corner)]);
        }
        // Along a ridge, where two coasts are equally far, samples differ too little to say where a line
        // goes.
        if (most - least < 0.5 * chart_.spacing) return;
        const int first = std::max(1, static_cast<int>(std::ceil(least / chart_.interval)));
        const int last = std::min(Chart::levels, static_cast<int>(std::floor(most / chart_.interval)));
        for (int level = first; level <= last; ++level) {
            Vec2 crossings[4];
            std::size_t found = 0;
            for (std::size_t i = 0; i < 4; ++i)
                if (crosses(corners[i], corners[(i + 1) % 4], level))
                    crossings[found++] = crossing(corners[i], corners[(i + 1) % 4], level);
            for (std::size_t i = 0; i + 1 < found; i += 2)
                chart_.strokes.push_back({crossings[i], crossings[i + 1], level});
        }
    }
    [[nodiscard]] bool crosses(Node a, Node b, int level) const {
        const double depth = level * chart_.interval;
        return (chart_.depth[index(a)] < depth) != (chart_.depth[index(b)] < depth);
    }
    /// Between samples the depth is taken as even, then the place is moved onto the line: straight away from
    /// the nearest place of what is nearest there.
    [[nodiscard]] Vec2 crossing(Node a, Node b, int level) const {
        const double depth = level * chart_.interval;
        const double da = chart_.depth[index(a)], db = chart_.depth[index(b)];
        const Vec2 guess = place(a) + (depth - da) / (db - da) * (place(b) - place(a));
        const Vec2 foot_a = nearest_of(primitives_[owner_[index(a)]], guess);
        const Vec2 foot_b = nearest_of(primitives_[owner_[index(b)]], guess);
        const Vec2 foot = length(guess - foot_a) <= length(guess - foot_b) ? foot_a : foot_b;
        const Vec2 moved = foot + depth * unit(guess - foot, {0, 0});
        return length(moved - guess) < chart_.spacing ? moved : guess;
    }

    std::vector<Primitive> primitives_;
    std::vector<std::size_t> owner_;  ///< per sample: the primitive that is nearest
    Chart chart_;
};

}  // namespace

double Chart::near(Vec2 place) const {
    const Vec2 in_samples = (place - box.min) / spacing;
    const auto nearest = [](double sample, int count) {
        return std::clamp(static_cast<int>(std::lround(sample)), 0, count - 1);
    };
    return at(nearest(in_samples.x, columns), nearest(in_samples.y, rows));
}

bool is_coast(const Part& part) {
    return !Table::moves(part) && !part.sensor && !part.target && gate_of(part) == nullptr;
}

Chart chart_of(const Scene& scene) {
    return Survey(scene).chart();
}

}  // namespace flipside::app
