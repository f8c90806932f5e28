#include "app/window/browser/thumbnail.hpp"

#include <stdexcept>

#include <SFML/Graphics/Image.hpp>
#include <SFML/Graphics/RenderTexture.hpp>

#include "app/window/playfield/ground.hpp"
#include "app/window/screen.hpp"
#include "app/window/table_view.hpp"
#include "lab/contenders/engines.hpp"

namespace flipside::app {

namespace {

Run run_at_start(const std::shared_ptr<const Scene>& scene) {
    const lab::Contender contender =
        lab::contender_for(lab::plain_contender(*lab::engines().front()), *scene, lab::step_for(*scene), {});
    return {contender,
            lab::Session(scene, *contender.engine, contender.settings, lab::WithoutWorld::refuse_steps),
            {}};
}

}  // namespace

std::shared_ptr<const sf::Texture> thumbnail_of(const std::shared_ptr<const Scene>& scene,
                                                const Lettering& lettering, unsigned width, unsigned height) {
    sf::RenderTexture picture;
    if (!picture.create(width, height))
        throw std::runtime_error("there is no picture of this size to be had");
    picture.clear(colour::around);
    Camera camera;
    camera.size = {double(width), double(height)};
    constexpr double margin = 6;  // px
    camera.fit(view_bounds(*scene), margin);
    const Run run = run_at_start(scene);
    Canvas canvas(lettering);
    Ground ground;
    const Look look;
    if (!ground.draw(picture, canvas, scene, camera, false)) draw_bare_ground(canvas, camera, *scene);
    draw_table(canvas, camera, run, look);
    draw_balls(canvas, camera, run, run.session().world().balls(), look);
    canvas.flush(picture);
    picture.display();
    auto texture = std::make_shared<sf::Texture>();
    if (!texture->loadFromImage(picture.getTexture().copyToImage()))
        throw std::runtime_error("the picture cannot be kept");
    texture->setSmooth(true);
    return texture;
}

}  // namespace flipside::app
