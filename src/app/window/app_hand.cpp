/// What the mouse does to what lies on the table, and the card that tells of it.

#include "app/window/app.hpp"
#include "app/window/card_view.hpp"

namespace flipside::app {

/// What is on the table comes before the table.
void App::touch(const sf::Event& event) {
    const ImGuiIO& io = ImGui::GetIO();
    const Hand::Took took = hand_.process(event, io.KeyShift || io.KeyCtrl, layout_, camera_, stage_);
    if (took == Hand::Took::no_room) controls_.notice = no_place;
    if (took == Hand::Took::nothing)
        mouse_.process(event, clock_.getElapsedTime().asSeconds(), layout_, camera_);
}

/// Where in the window a ball is in each run, or the picked part in each pane: what no card should cover.
std::vector<Rect> App::places_of(Other subject) const {
    std::vector<Rect> places;
    const auto add = [&](const Rect& pane, const Box& box) {
        const Vec2 a = camera_.to_pixels(box.min), b = camera_.to_pixels(box.max);
        const double around = 8 * scale_;  // px
        places.push_back(
            {pane.x + a.x - around, pane.y + b.y - around, b.x - a.x + 2 * around, a.y - b.y + 2 * around});
    };
    if (!subject.is_ball)
        for (const Rect& pane : layout_.panes) add(pane, hand_.extent());
    for (std::size_t i = 0; subject.is_ball && i < stage_.runs().size(); ++i) {
        const Rect& pane = layout_.panes[std::min(i, layout_.panes.size() - 1)];
        if (const Ball* ball = find_ball(stage_.runs()[i].session().world().balls(), subject.index)) {
            const Vec2 radius{ball->radius, ball->radius};
            add(pane, {ball->position - radius, ball->position + radius});
        }
    }
    return places;
}

/// The card of what is picked, or of the last impact.
void App::inspect() {
    state_.card.reset();
    if (controls_.help_open) return;  // it would lie over the help
    if (hand_.picked() || controls_.impact_open) state_.card = card_of(stage_, hand_.picked());
    if (!state_.card) {
        card_place_ = {};
    } else if (!draw_card(*state_.card, stage_, layout_, places_of(state_.card->subject), card_place_,
                          places_)) {
        controls_.impact_open = false;
        hand_.let_go();
    }
}

}  // namespace flipside::app
