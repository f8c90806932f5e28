#include "lab/session/checksum.hpp"

#include <bit>

namespace flipside::lab {

namespace {

class Fnv1a {
  public:
    void add(std::uint64_t word) {
        constexpr std::uint64_t prime = 0x100000001b3;
        for (int byte = 0; byte < 8; ++byte) sum_ = (sum_ ^ ((word >> (8 * byte)) & 0xff)) * prime;
    }
    void add(double number) { add(std::bit_cast<std::uint64_t>(number)); }
    void add(Vec2 vector) {
        add(vector.x);
        add(vector.y);
    }
    [[nodiscard]] std::uint64_t sum() const { return sum_; }

  private:
    std::uint64_t sum_ = 0xcbf29ce484222325;
};

}  // namespace

std::uint64_t checksum_of(const World& world, const Game& game) {
    Fnv1a hash;
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
