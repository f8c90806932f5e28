#pragma once
/// What a player can do now, where that is not plain to see.

#include <optional>
#include <span>

#include "app/window/playfield/captions.hpp"
#include "app/window/stage.hpp"

namespace flipside::app {

/// In a pane that shows these runs of the stage; nothing where the table speaks for itself.
[[nodiscard]] std::optional<CaptionWords> advice(std::span<const Run> shown, const Stage& stage);

}  // namespace flipside::app
