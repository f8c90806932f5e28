#pragma once
/// What a player can do now, where that is not plain to see.

#include <span>
#include <string>

#include "app/window/stage.hpp"

namespace flipside::app {

/// In a pane that shows these runs of the stage; "" where the table speaks for itself.
[[nodiscard]] std::string advice(std::span<const Run> shown, const Stage& stage);

}  // namespace flipside::app
