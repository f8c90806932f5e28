#pragma once
/// Scenes in which energy must be conserved: elastic and without friction.

#include "world/scene.hpp"

namespace flipside::lab {

/// Discs in a walled square of which they cover a fifth, without gravity.
[[nodiscard]] Scene elastic_gas(int balls);
/// A ball above a floor, which it reaches at 4.4 m/s again and again.
[[nodiscard]] Scene elastic_drop();

}  // namespace flipside::lab
