#include "app/window/hand.hpp"

#include <algorithm>
#include <span>

#include "app/window/screen.hpp"
#include "lab/session/pick.hpp"

namespace flipside::app {

namespace {

constexpr double click_pixels = 6;  ///< a click may move by so much
constexpr double reach_pixels = 5;  ///< and may miss by so much

std::optional<std::size_t> pane_under(const Layout& layout, Vec2 p) {
    for (std::size_t i = 0; i < layout.panes.size(); ++i)
        if (layout.panes[i].contains(p.x, p.y)) return i;
    return std::nullopt;
}

/// The runs that a pane shows.
std::span<const Run> runs_in(const Stage& stage, const Layout& layout, std::size_t pane) {
    const std::span<const Run> runs = stage.runs();
    return layout.panes.size() == 1 ? runs : runs.subspan(pane, 1);
}

Vec2 metres(const Camera& camera, const Rect& pane, Vec2 pixel) {
    return camera.to_metres(pixel - Vec2{pane.x, pane.y});
}

/// A ball like the one that is picked, or that the scene has.
Ball new_ball(const Stage& stage, const std::optional<Other>& picked, Vec2 at) {
    const Scene& scene = stage.scene();
    Ball ball;
    ball.radius = 0.02 * (view_bounds(scene).max.x - view_bounds(scene).min.x);
    ball.mass = 1;
    if (!scene.balls.empty()) ball = scene.balls.front();
    if (scene.launcher) ball = scene.launcher->ball;
    if (picked && picked->is_ball)
        if (const Ball* like = find_ball(stage.lead().session().world().balls(), picked->index)) ball = *like;
    ball.position = at;
    ball.velocity = {};
    ball.angle = ball.spin = 0;
    ball.asleep = false;
    return ball;
}

}  // namespace

Hand::Took Hand::process(const sf::Event& event, bool adds, const Layout& layout, const Camera& camera,
                         Stage& stage) {
    const auto is_left = [&](sf::Event::EventType type) {
        return event.type == type && event.mouseButton.button == sf::Mouse::Left;
    };
    if (is_left(sf::Event::MouseButtonPressed)) {
        mouse_ = {double(event.mouseButton.x), double(event.mouseButton.y)};
        if (adds) return add(mouse_, layout, camera, stage);
        press(mouse_, layout, camera, stage);
    } else if (is_left(sf::Event::MouseButtonReleased) && pressed_) {
        release(camera, stage);
    } else if (event.type == sf::Event::MouseMoved && pressed_) {
        mouse_ = {double(event.mouseMove.x), double(event.mouseMove.y)};
        moved_ = moved_ || length(mouse_ - pressed_->at) > click_pixels;
        const bool ball = pressed_->on && pressed_->on->is_ball;
        pulled_ = moved_ && ball;
        if (ball) return Took::it;
    } else if (event.type == sf::Event::LostFocus) {
        pressed_.reset();
    }
    return Took::nothing;
}

void Hand::pick(std::optional<Other> what, const Stage& stage) {
    picked_ = what;
    const lab::Session& lead = stage.lead().session();
    if (what && !what->is_ball) extent_ = lab::extent_of(lead.scene(), lead.world().parts(), what->index);
}

void Hand::pick_next_ball(const Stage& stage) {
    const std::span<const Ball> balls = stage.lead().session().world().balls();
    if (balls.empty()) return;
    const bool first = !picked_ || !picked_->is_ball;
    const auto next =
        first ? balls.begin() : std::ranges::upper_bound(balls, picked_->index, {}, &Ball::number);
    pick(Other::ball(next == balls.end() ? balls.front().number : next->number), stage);
}

void Hand::pick_next_part(const Stage& stage) {
    const auto parts = static_cast<PartIndex>(stage.scene().parts.size());
    if (parts == 0) return;
    const bool first = !picked_ || picked_->is_ball;
    pick(Other::part(first ? 0 : (picked_->index + 1) % parts), stage);
}

void Hand::press(Vec2 at, const Layout& layout, const Camera& camera, const Stage& stage) {
    pressed_.reset();
    moved_ = pulled_ = false;
    const auto pane = pane_under(layout, at);
    if (!pane) return;
    pressed_ = Pressed{*pane, layout.panes[*pane], {}, at};
    const Vec2 point = metres(camera, pressed_->place, at);
    // On one table the balls of all runs come before the parts.
    for (const Run& run : runs_in(stage, layout, *pane)) {
        const World& world = run.session().world();
        const auto found = lab::pick(run.session().scene(), world.balls(), world.parts(), point,
                                     reach_pixels / camera.scale);
        if (!pressed_->on || (found && found->is_ball)) pressed_->on = found;
        if (found && found->is_ball) break;
    }
}

Hand::Took Hand::add(Vec2 at, const Layout& layout, const Camera& camera, Stage& stage) const {
    const auto pane = pane_under(layout, at);
    if (!pane) return Took::nothing;
    const Vec2 point = metres(camera, layout.panes[*pane], at);
    return stage.edit(lab::edit::Add{new_ball(stage, picked_, point)}) ? Took::it : Took::no_room;
}

void Hand::release(const Camera& camera, Stage& stage) {
    if (const auto thrown = sling(camera, stage))
        stage.edit(lab::edit::Throw{thrown->ball, thrown->velocity});
    else if (!moved_)
        pick(pressed_->on, stage);
    pressed_.reset();
}

std::optional<Sling> Hand::sling(const Camera& camera, const Stage& stage) const {
    if (!slings()) return std::nullopt;
    const BallNumber number = pressed_->on->index;
    const Vec2 held = metres(camera, pressed_->place, mouse_);
    // From where it is in the pane that was pressed in, or on one table in the first run that has it.
    for (std::size_t i = std::min(pressed_->pane, stage.runs().size() - 1); i < stage.runs().size(); ++i)
        if (const Ball* ball = find_ball(stage.runs()[i].session().world().balls(), number))
            return Sling{number, held, stiffness * (ball->position - held)};
    return std::nullopt;
}

bool Hand::let_go() {
    if (slings()) {
        pressed_.reset();
        return true;
    }
    const bool had = picked_.has_value();
    picked_.reset();
    return had;
}

bool Hand::remove(Stage& stage) {
    return picked_ && picked_->is_ball && stage.edit(lab::edit::Remove{picked_->index});
}

}  // namespace flipside::app
