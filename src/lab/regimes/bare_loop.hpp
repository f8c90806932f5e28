#pragma once
/// The floor under the cost of a rain of balls: a bare loop in single precision, four sub-steps a frame,
/// balls sorted into cells in every sub-step, impulses between those that overlap, reflection off the
/// nearest point of segments and circles. No continuous collision, no events, no touches, no arcs, no spin,
/// no numbers that balls keep: what it leaves out is what the engines spend the rest of their time on.

#include <cstdint>
#include <vector>

#include "world/scene.hpp"

namespace flipside::lab::regimes {

class BareLoop {
  public:
    /// Takes balls of one radius, and the still segments and circles of a scene.
    explicit BareLoop(const Scene& scene);

    void step(float dt);
    /// Balls that left the scene's bounds.
    [[nodiscard]] std::size_t lost() const;

  private:
    struct Wall {
        float ax, ay, bx, by;  ///< of a circle twice the centre
        float radius, bounce;  ///< m; restitution
    };
    struct Balls {
        std::vector<float> x, y, vx, vy;
        void resize(std::size_t n);
    };

    [[nodiscard]] std::uint32_t cell(float x, float y) const;
    void list_walls();
    void sort();
    void hit_walls();
    void hit_balls();
    void hit(std::uint32_t i, std::uint32_t k);

    float gravity_x_, gravity_y_, radius_, bounce_;
    Box bounds_;
    float left_, bottom_, per_cell_;
    std::uint32_t columns_, rows_;
    std::vector<Wall> walls_;
    std::vector<std::uint32_t> wall_begin_, walls_in_;  ///< per cell, and what lies near it
    std::vector<std::uint32_t> begin_, home_;
    Balls balls_, sorted_;
};

}  // namespace flipside::lab::regimes
