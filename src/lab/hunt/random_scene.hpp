#pragma once
/// Random scenes: a closed box with every shape, motion and material, and one to six balls. Where a seed
/// leads stays as it is: tests name seeds.

#include <initializer_list>
#include <numbers>
#include <random>

#include "world/scene_builder.hpp"

namespace flipside::lab {

class RandomScene {
  public:
    explicit RandomScene(std::uint64_t seed) : random_(seed) {}

    /// Balls may overlap each other and parts: see lab/scenes/clear_starts.hpp.
    Scene make();
    /// In or out of the box's middle, with a motion or without.
    void add_part_to(Scene& scene);
    void add_ball_to(Scene& scene);
    [[nodiscard]] Material material();
    [[nodiscard]] Shape shape();

    [[nodiscard]] double real(double low, double high) {
        return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
    }
    [[nodiscard]] int whole(int low, int high) {
        return low + static_cast<int>(random_() % static_cast<unsigned>(high - low + 1));
    }
    template <class T>
    [[nodiscard]] T pick(std::initializer_list<T> of) {
        return *(of.begin() + whole(0, static_cast<int>(of.size()) - 1));
    }
    [[nodiscard]] Vec2 direction() { return from_angle(real(0, 2 * std::numbers::pi)); }
    /// A vector in any direction.
    [[nodiscard]] Vec2 vector(double shortest, double longest);
    [[nodiscard]] Vec2 place() { return {real(-0.8, 0.8), real(-0.8, 0.8)}; }

  private:
    std::mt19937_64 random_;
};

}  // namespace flipside::lab
