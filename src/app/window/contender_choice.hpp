#pragma once
/// The choice of contenders: the engine and the step of each contender, one more, one less.

#include <optional>
#include <span>

#include "app/window/controls.hpp"
#include "app/window/stage.hpp"

namespace flipside::app {

/// The engine and the step of the run at `index`, and a button that takes it away; false if that was pressed.
/// What cannot be becomes the `notice`.
bool choose_contender(Stage& stage, std::size_t index, ControlPlaces& places, Notice& notice);
/// Over the step in each header, where it stands: a click opens the list of steps.
void choose_steps_in_headers(std::span<const std::optional<Rect>> steps, Stage& stage, ControlPlaces& places,
                             Notice& notice);
/// A button for one more, where there is room.
void add_contender(Stage& stage, ControlPlaces& places, Notice& notice);

}  // namespace flipside::app
