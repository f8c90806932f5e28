#include <algorithm>
#include <numbers>

#include <boost/random/mersenne_twister.hpp>
#include <boost/random/uniform_real_distribution.hpp>

#include "world/scene_reader.hpp"

// Generators: rows of balls or pins, and a field of balls, segments and bumpers placed at random.
//
// The field is filled by rejection sampling: a position is drawn until it overlaps nothing placed before.
// A grid of cells finds neighbours, so that placing n shapes costs O(n) as long as there is free space.

namespace flipside {

namespace {

/// The same numbers on every machine and with every compiler.
class Random {
  public:
    explicit Random(const Node& node) : engine_(static_cast<std::uint32_t>(node.integer("seed", 1))) {}

    double between(double min, double max) {
        return min < max ? boost::random::uniform_real_distribution<double>(min, max)(engine_) : min;
    }
    /// In any direction, of a length up to `most`.
    Vec2 velocity(double most) {
        if (most == 0) return {};
        const double speed = between(0, most);
        return speed * from_angle(between(-std::numbers::pi, std::numbers::pi));
    }

  private:
    boost::random::mt19937 engine_;
};

std::string numbered(const char* what, std::size_t number) {
    return std::string(what) + "-" + std::to_string(number);
}

void generate_rows(const Node& node, SceneReader& reader) {
    const bool balls = node.text("of") == "balls";
    const auto count = node.integer("count"), rows = node.integer("rows", 1);
    if (rows > 1 && !node.has("row_step"))
        node.fail("the key \"row_step\" is missing; more than one row needs it");
    for (const char* key : {"radius", "mass"})
        if (balls && !node.has(key))
            node.fail("the key \"" + std::string(key) + "\" is missing; balls need it");
    for (const char* key : {"mass", "speed", "seed"})
        if (!balls && node.has(key)) node.fail(key, "pins have none; allowed with \"of\": \"balls\"");
    if (count > 0 && rows > static_cast<std::int64_t>(most_things) / count)
        node.fail("makes too many; allowed are 1000000 in a scene");

    Random random(node);
    const Vec2 step = node.vector("step");
    std::size_t pins = 0;
    for (std::int64_t row = 0; row < rows; ++row)
        for (std::int64_t i = 0; i < count; ++i) {
            const double along = static_cast<double>(i) + (node.toggle("stagger") && row % 2 == 1 ? 0.5 : 0);
            const Vec2 at =
                node.vector("from") + along * step + static_cast<double>(row) * node.vector("row_step");
            if (balls) {
                Ball ball = reader.ball_kind(node);
                ball.position = at;
                ball.velocity = random.velocity(node.real("speed", 0));
                reader.add_ball(node, ball);
            } else {
                Part pin;
                pin.name = numbered("pin", ++pins);
                pin.material = reader.material(node);
                if (node.has("radius"))
                    pin.shape = {shape::Circle{at, node.real("radius")}};
                else
                    pin.shape = {shape::Point{at}};
                reader.add_part(node, std::move(pin));
            }
        }
}

/// Every shape in a field is a segment with a radius; that of a disc is a point.
struct Item {
    Vec2 a, b;
    double radius;
};

double distance(Vec2 p, Vec2 a, Vec2 b) {
    const double l2 = length_squared(b - a);
    const double t = l2 > 0 ? std::clamp(dot(p - a, b - a) / l2, 0.0, 1.0) : 0;
    return length(p - (a + t * (b - a)));
}

double distance(const Item& p, const Item& q) {
    const auto side = [](Vec2 a, Vec2 b, Vec2 c) { return cross(b - a, c - a); };
    if (side(p.a, p.b, q.a) * side(p.a, p.b, q.b) < 0 && side(q.a, q.b, p.a) * side(q.a, q.b, p.b) < 0)
        return 0;
    return std::min(
        {distance(p.a, q.a, q.b), distance(p.b, q.a, q.b), distance(q.a, p.a, p.b), distance(q.b, p.a, p.b)});
}

/// A square [0, side]² with the shapes placed in it.
class Field {
  public:
    Field(double side, double cell)
        : side_(side),
          per_side_(std::clamp(static_cast<std::size_t>(side / cell), std::size_t{1}, most_per_side)),
          cells_(per_side_ * per_side_) {}

    /// Places it if at least `gap` lies between it and everything else, the walls included.
    bool place(const Item& item, double gap) {
        const double reach = item.radius + gap;
        const Vec2 low{std::min(item.a.x, item.b.x) - reach, std::min(item.a.y, item.b.y) - reach};
        const Vec2 high{std::max(item.a.x, item.b.x) + reach, std::max(item.a.y, item.b.y) + reach};
        if (low.x < 0 || low.y < 0 || high.x > side_ || high.y > side_) return false;
        bool free = true;
        each_cell(low, high, [&](const std::vector<std::uint32_t>& cell) {
            looks_ += 1 + cell.size();
            for (const std::uint32_t i : cell)
                free = free && distance(item, items_[i]) >= reach + items_[i].radius;
        });
        if (!free) return false;
        each_cell(low, high, [&](std::vector<std::uint32_t>& cell) {
            cell.push_back(static_cast<std::uint32_t>(items_.size()));
        });
        items_.push_back(item);
        return true;
    }
    /// Number of cells and shapes tested so far.
    [[nodiscard]] std::uint64_t looks() const { return looks_; }

  private:
    static constexpr std::size_t most_per_side = 1024;

    void each_cell(Vec2 low, Vec2 high, auto&& visit) {
        const auto index = [&](double x) {
            const double i = x / side_ * static_cast<double>(per_side_);
            return std::min(static_cast<std::size_t>(i), per_side_ - 1);
        };
        for (std::size_t y = index(low.y); y <= index(high.y); ++y)
            for (std::size_t x = index(low.x); x <= index(high.x); ++x) visit(cells_[y * per_side_ + x]);
    }

    double side_;
    std::size_t per_side_;
    std::vector<std::vector<std::uint32_t>> cells_;  ///< indices into items_, row by row
    std::vector<Item> items_;
    std::uint64_t looks_ = 0;
};

double field_side(const Node& node) {
    return std::sqrt(node.real("balls") / node.real("density"));
}

/// Fills a field as its generator describes.
class FieldMaker {
  public:
    FieldMaker(const Node& node, SceneReader& reader)
        : node_(node),
          reader_(reader),
          random_(node),
          ball_(reader.ball_kind(node.at("ball"))),
          side_(field_side(node)),
          field_(side_, 4 * ball_.radius) {}

    void make() {
        walls();
        // A ball always fits between static shapes.
        const double passage = 2.2 * ball_.radius;
        obstacles("bumpers", "bumper", "radius", [&](double radius) {
            const Item item = place("bumpers", passage, [&] {
                const Vec2 at = anywhere();
                return Item{at, at, radius};
            });
            return Shape{shape::Circle{item.a, radius}};
        });
        obstacles("segments", "segment", "length", [&](double length) {
            const Item item = place("segments", passage, [&] {
                const Vec2 at = anywhere();
                const Vec2 half = 0.5 * length * from_angle(random_.between(0, std::numbers::pi));
                return Item{at - half, at + half, 0};
            });
            return Shape{shape::Segment{item.a, item.b}};
        });
        balls();
    }

  private:
    Vec2 anywhere() {
        const double x = random_.between(0, side_);
        return {x, random_.between(0, side_)};
    }

    /// Draws until a position is free.
    Item place(const char* key, double gap, auto&& draw) {
        // The second limit is for all shapes together: each may find a position, but only after many draws.
        constexpr int enough = 100'000;
        constexpr std::uint64_t enough_looks = 1'000'000'000;
        for (int i = 0; i < enough && field_.looks() < enough_looks; ++i)
            if (const Item item = draw(); field_.place(item, gap)) return item;
        node_.fail(
            key, "there is no room for all of them; allowed is a lower density, or smaller or fewer things");
    }

    void add(const Node& node, std::string name, Shape shape, const char* material = "material") {
        Part part;
        part.name = std::move(name);
        part.material = reader_.material(node, material);
        part.shape = std::move(shape);
        reader_.add_part(node, std::move(part));
    }

    void walls() {
        add(node_, "walls", {shape::Polyline{{{0, 0}, {side_, 0}, {side_, side_}, {0, side_}}, true}},
            "walls");
    }

    /// `per_ball` shapes of a random size; `make` places one.
    void obstacles(const char* key, const char* name, const char* size, auto&& make) {
        if (!node_.has(key)) return;
        const Node node = node_.at(key);
        const Vec2 range = node.vector(size);
        if (range.x > range.y) node.fail(size, "the least is above the greatest; allowed: [least, greatest]");
        const auto count = static_cast<std::size_t>(std::round(node.real("per_ball") * node_.real("balls")));
        for (std::size_t i = 1; i <= count; ++i)
            add(node, numbered(name, i), make(random_.between(range.x, range.y)));
    }

    void balls() {
        const double gap = 0.02 * ball_.radius;
        const double speed = node_.real("speed", 0);
        for (std::int64_t i = 0; i < node_.integer("balls"); ++i) {
            Ball ball = ball_;
            ball.position = place("balls", gap, [&] {
                                const Vec2 at = anywhere();
                                return Item{at, at, ball.radius};
                            }).a;
            ball.velocity = random_.velocity(speed);
            reader_.add_ball(node_, ball);
        }
    }

    const Node& node_;
    SceneReader& reader_;
    Random random_;
    Ball ball_;
    double side_;
    Field field_;
};

}  // namespace

Box field_bounds(const Node& node) {
    // No ball leaves a closed box; one this far outside has passed through the walls.
    const double side = field_side(node), margin = 4 * node.at("ball").real("radius");
    return {{-margin, -margin}, {side + margin, side + margin}};
}

void generate(const Node& generator, SceneReader& reader) {
    if (generator.text("type") == "rows")
        generate_rows(generator, reader);
    else
        FieldMaker(generator, reader).make();
}

}  // namespace flipside
