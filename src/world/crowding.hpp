#pragma once
/// How many balls and primitives of a scene overlap. Engines list the pairs of bounding boxes that overlap,
/// so time and memory of a step grow with their number: with the square of n for n balls at one position.

#include <cstdint>
#include <optional>
#include <span>

#include "world/scene.hpp"

namespace flipside {

/// Something with a box, as broad phases see it.
struct Boxed {
    Box box;
    bool is_ball = false;
    std::uint32_t layer = 1, collides_with = ~0U;
};

/// The first thing, from left to right, at which the number of overlapping pairs goes beyond `most`; none
/// where it does not. Pairs are counted of balls whose layers meet, of a ball and a part whose layers meet,
/// and of parts. (Of more than eight different sets of layers the rest count as one that meets all.) Boxes
/// are closed. Cost: O(n log n), nothing where n things cannot have so many pairs.
[[nodiscard]] std::optional<std::size_t> crowded_at(std::span<const Boxed> things, std::uint64_t most);

/// Appends the boxes of the points, lines, arcs (whole circles) and solids that a shape consists of.
void append_boxes(const Shape& shape, std::vector<Box>& boxes);

}  // namespace flipside
