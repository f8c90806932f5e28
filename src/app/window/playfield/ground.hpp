#pragma once
/// The ground of a table as a picture, drawn once for a camera and kept: the chart's tints and lines, and the
/// shadows of what stands on it.

#include <memory>

#include <SFML/Graphics/RenderTexture.hpp>
#include <SFML/Graphics/Texture.hpp>

#include "app/window/camera.hpp"
#include "app/window/canvas.hpp"
#include "app/window/playfield/chart.hpp"
#include "app/window/playfield/inserts.hpp"

namespace flipside::app {

class Ground {
  public:
    /// Fills the pane that `target` views. `canvas` must have nothing that waits to be drawn. Under overlays
    /// it is `dimmed`. False, and nothing is drawn, where there is no picture of that size to be had.
    bool draw(sf::RenderTarget& target, Canvas& canvas, const std::shared_ptr<const Scene>& scene,
              const Camera& camera, bool dimmed);
    /// Of a scene, whether or not its ground is drawn.
    [[nodiscard]] std::span<const Insert> inserts(const std::shared_ptr<const Scene>& scene) {
        if (!scene->rules) return {};
        if (scene != scene_) survey(scene);
        return inserts_;
    }

  private:
    void survey(const std::shared_ptr<const Scene>& scene);
    void paint(Canvas& canvas, const Camera& camera);
    void paint_lines(Canvas& canvas, const Camera& camera) const;
    void paint_shadows(Canvas& canvas, const Camera& camera) const;

    std::shared_ptr<const Scene> scene_;
    Chart chart_;
    std::vector<Insert> inserts_;
    sf::Texture tints_;  ///< a pixel per sample of the chart
    sf::RenderTexture picture_;
    std::optional<Camera> painted_for_;
};

}  // namespace flipside::app
