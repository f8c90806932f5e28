#include "lab/session/checksum.hpp"

#include <bit>

#include "world/fnv1a.hpp"

namespace flipside::lab {

namespace {

class Sum {
  public:
    void add(std::uint64_t word) {
        char bytes[8];  // the lowest first, on every machine
        for (char& byte : bytes) byte = static_cast<char>(word), word >>= 8U;
        sum_ = fnv1a({bytes, sizeof bytes}, sum_);
    }
    void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
    void add(Vec2 vector) {
        add(vector.x);
        add(vector.y);
    }
    [[nodiscard]] std::uint64_t sum() const { return sum_; }

  private:
    std::uint64_t sum_ = fnv1a({});
};

}  // namespace

std::uint64_t checksum_of(const World& world, const Game& game) {
    Sum hash;
    hash.add(world.time());
    for (const Ball& ball : world.balls()) {
        hash.add(std::uint64_t{ball.number});
        hash.add(ball.position);
        hash.add(ball.velocity);
        hash.add(ball.angle);
        hash.add(ball.spin);
        hash.add(ball.radius);
    }
    for (const PartState& part : world.parts()) {
        hash.add(part.angle);
        hash.add(std::uint64_t{part.open} + 2 * std::uint64_t{part.down});
    }
    hash.add(static_cast<std::uint64_t>(game.score()));
    hash.add(static_cast<std::uint64_t>(game.balls_left()));
    return hash.sum();
}

}  // namespace flipside::lab
