#pragma once
/// Draws a scene that is edited: the grid, the parts in plain lines, handles, what is being drawn, and what
/// is wrong beside the part that is wrong.

#include "app/window/canvas.hpp"
#include "app/window/editor/editor.hpp"

namespace flipside::app {

/// A header, the table and a line of advice (in place of the plots); no other panes.
[[nodiscard]] Layout edit_layout(double width, double height, double scale, bool panel_open);
/// What is seen of the scene as a whole.
[[nodiscard]] Box view_bounds(const Editor& editor);
/// All but the control column.
void draw_editor(sf::RenderTarget& target, Canvas& canvas, const Editor& editor, const Layout& layout,
                 const Camera& camera);

}  // namespace flipside::app
