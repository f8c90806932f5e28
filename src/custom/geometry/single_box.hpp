#pragma once
/// A box as the broad phase keeps it, in single precision and rounded outward: what overlaps still does, what
/// does not may if it is nearer than 4e-7 of its distance from the origin. It takes half the memory of a Box,
/// and four sides are compared at once.

#include <array>
#include <bit>
#include <cstdint>
#include <limits>

#include "world/vec2.hpp"
#ifdef __SSE__
#include <xmmintrin.h>
#endif

namespace flipside::custom {

class SingleBox {
  public:
    SingleBox() = default;
    SingleBox(Vec2 min, Vec2 max)
        : sides_(__builtin_shufflevector(below(Two{min.x, min.y}), below(-Two{max.x, max.y}), 0, 1, 2, 3)) {}
    SingleBox(const Box& box) : SingleBox(box.min, box.max) {}
    operator Box() const { return {{left(), bottom()}, {right(), top()}}; }

    /// m
    [[nodiscard]] double left() const { return sides_[0]; }
    [[nodiscard]] double bottom() const { return sides_[1]; }
    [[nodiscard]] double right() const { return -sides_[2]; }
    [[nodiscard]] double top() const { return -sides_[3]; }

    /// Closed boxes: those that only share a border overlap.
    [[nodiscard]] friend bool overlap(const SingleBox& a, const SingleBox& b) {
        return all(b.sides_ <= -__builtin_shufflevector(a.sides_, a.sides_, 2, 3, 0, 1));
    }
    /// Whether no part of the inner one is outside the other.
    [[nodiscard]] friend bool holds(const SingleBox& outer, const SingleBox& inner) {
        return all(outer.sides_ <= inner.sides_);
    }

  private:
    using Sides = float __attribute__((vector_size(16)));
    using Mask = std::int32_t __attribute__((vector_size(16)));
    using Two = double __attribute__((vector_size(16)));
    using TwoSingles = float __attribute__((vector_size(8)));
    using Bits = std::int64_t __attribute__((vector_size(16)));

    /// Not above these, by three units in the last place at most. What a float can't hold becomes infinite,
    /// at either side, so that its boxes still overlap.
    static TwoSingles below(const Two& sides) {
        constexpr std::int64_t all_but_sign = std::numeric_limits<std::int64_t>::max();
        constexpr double unit = std::numeric_limits<float>::epsilon(),
                         least = std::numeric_limits<float>::min();
        const Two size = reinterpret_cast<Two>(reinterpret_cast<Bits>(sides) & all_but_sign);
        return __builtin_convertvector(sides - (size * unit + least), TwoSingles);
    }
    static bool all(const Mask& mask) {
#ifdef __SSE__
        return _mm_movemask_ps(std::bit_cast<__m128>(mask)) == 0xF;
#else
        const auto halves = std::bit_cast<std::array<std::uint64_t, 2>>(mask);
        return (halves[0] & halves[1]) == ~std::uint64_t{0};
#endif
    }

    Sides sides_{};  ///< m: min.x, min.y, −max.x, −max.y; a larger box has smaller ones
};

}  // namespace flipside::custom
