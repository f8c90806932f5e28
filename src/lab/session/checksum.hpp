#pragma once
/// A number that tells two courses of a game apart.

#include <cstdint>

#include "lab/game/game.hpp"
#include "world/world.hpp"

namespace flipside::lab {

/// FNV-1a, 64 bits, of the bits of what is seen of a world and its game: the time, the balls, the moving
/// parts, gates and targets, score and balls left. It finds what went another way by chance; it is no seal
/// against forgery.
[[nodiscard]] std::uint64_t checksum_of(const World& world, const Game& game);

}  // namespace flipside::lab
