#include "app/painter.hpp"

#include <stdexcept>
#include <string>

namespace flipside::app {

Painter::Painter(unsigned width, unsigned height, double scale) : screen_(scale) {
    if (!picture_.create(width, height))
        throw std::runtime_error("cannot make a picture of " + std::to_string(width) + " x " +
                                 std::to_string(height) + " pixels");
}

sf::Image Painter::paint(const Stage& stage, const Look& look) {
    const sf::Vector2u size = picture_.getSize();
    const Layout layout = layout_of(stage, size.x, size.y, screen_.scale(), Column::none);
    Camera camera;
    camera.size = {layout.panes.front().width, layout.panes.front().height};
    camera.fit(view_bounds(stage.scene()), screen_.scale() * pane_margin);
    Readings readings;
    for (const Run& run : stage.runs()) readings.scores.push_back(run.session().game().score());
    const GameEnd end = end_of(stage);
    if (is_over(stage)) readings.end = &end;
    screen_.draw(picture_, stage, layout, camera, look, readings);
    picture_.display();
    return picture_.getTexture().copyToImage();
}

}  // namespace flipside::app
