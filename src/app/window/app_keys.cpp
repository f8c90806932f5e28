/// What keys do in the window.

#include <algorithm>
#include <utility>

#include "app/window/app.hpp"

namespace flipside::app {

namespace {

constexpr double slow_motion = 0.1;   ///< simulated seconds per second
constexpr double nudge_speed = 0.25;  ///< m/s

}  // namespace

bool App::held(Action action) const {
    return pad_.held(action) ||
           std::ranges::any_of(held_, [action](sf::Keyboard::Key key) { return action_of(key) == action; });
}

void App::press(Action action, sf::Keyboard::Key key, bool down) {
    // While nothing moves, Shift goes with other keys; the arrows flip as ever.
    const bool shift = key == sf::Keyboard::LShift || key == sf::Keyboard::RShift;
    if (controls_.bar_open && controls_.paused && shift && down) return;
    if (action == Action::none || down == held_.contains(key)) return;
    if (action == Action::launch && down && play_again()) return;
    if (down)
        held_.insert(key);
    else
        held_.erase(key);
    for (const KeyUse& use : key_uses())
        if (use.action == action) state_.last_key = std::string(use.names) + (down ? " down" : " up");

    perform(action, down);
}

/// By a key or a gamepad, which has noted that it is held or not.
void App::perform(Action action, bool down) {
    if (action == Action::flip_left) return flip(Side::left, action);
    if (action == Action::flip_right) return flip(Side::right, action);
    if (action == Action::launch && !down) {
        stage_.press(control::Launch{state_.charge, 1, controls_.launch_size});
        state_.charge = 0;
    }
    if (down) act(action);
}

void App::flip(Side side, Action action) {
    stage_.press(control::Flip{side, held(action)});
}

void App::nudge(Vec2 velocity) {
    stage_.press(control::Nudge{velocity});
}

void App::act(Action action) {
    switch (action) {
        case Action::none:
        case Action::launch:
        case Action::flip_left:
        case Action::flip_right:
            break;
        case Action::nudge_left:
            return nudge({-nudge_speed, 0});
        case Action::nudge_forward:
            return nudge({0, nudge_speed});
        case Action::nudge_right:
            return nudge({nudge_speed, 0});
        case Action::next_ball:
            return hand_.pick_next_ball(stage_);
        case Action::next_part:
            return hand_.pick_next_part(stage_);
        case Action::remove_ball:
            if (!hand_.remove(stage_)) controls_.notice = no_ball_picked;
            break;
        case Action::restart:
            stage_.restart();
            break;
        case Action::switch_engine:
            stage_.switch_engine();
            break;
        case Action::reference:
            if (!stage_.show_reference(!stage_.reference())) controls_.notice = no_room;
            break;
        case Action::take_up:
            if (!stage_.can_take_up()) controls_.notice.tell(stage_.guide() ? no_reference : no_guide);
            stage_.take_up();
            break;
        case Action::next_view:
            stage_.set_view(static_cast<View>((static_cast<int>(stage_.view()) + 1) % 3));
            break;
        case Action::view_single:
            stage_.set_view(View::single);
            break;
        case Action::view_split:
            stage_.set_view(View::split);
            break;
        case Action::view_overlay:
            stage_.set_view(View::overlay);
            break;
        case Action::next_plots:
            controls_.plots = after(controls_.plots);
            break;
        default:
            return act_on_time(action);
    }
}

/// What stops time, lets it go on, and goes back in it.
void App::act_on_time(Action action) {
    switch (action) {
        case Action::pause:
            controls_.paused = !controls_.paused;
            break;
        case Action::step_once:
            if (controls_.bar_open) return act_inside(action);
            if (controls_.paused && stage_.step_forward()) break;
            controls_.paused = true;
            ++controls_.single_steps;
            break;
        case Action::stage_back:
            if (controls_.bar_open) return act_inside(action);
            controls_.paused = true;
            stage_.step_back();
            break;
        case Action::to_record_begin:
        case Action::to_record_end:
            controls_.paused = true;
            stage_.go_to(action == Action::to_record_end ? stage_.record_end() : stage_.record_begin());
            break;
        case Action::step_whole:
        case Action::item_next:
        case Action::item_back:
        case Action::look_at_next:
            if (controls_.bar_open) act_inside(action);
            break;
        case Action::look_inside:
            controls_.bar_open = !controls_.bar_open;
            microscope_.close();
            break;
        case Action::mute:
            controls_.muted = !controls_.muted;
            break;
        case Action::slow_motion:
            controls_.speed = controls_.speed < 1 ? 1 : slow_motion;
            break;
        default:
            return act_on_window(action);
    }
}

/// What has nothing to do with the table.
void App::act_on_window(Action action) {
    switch (action) {
        case Action::fold_panel:
            controls_.panel_open = !controls_.panel_open;
            break;
        case Action::work_controls:
            controls_.by_keys = !controls_.by_keys;
            controls_.panel_open |= controls_.by_keys;
            break;
        case Action::larger:
            return change_scale(scale_step);
        case Action::smaller:
            return change_scale(-scale_step);
        case Action::usual_size:
            controls_.scale = 0;
            break;
        case Action::drop_slowest:
            return drop_slowest();
        case Action::last_impact:
            controls_.impact_open = !controls_.impact_open;
            break;
        case Action::screenshot:
            screenshot_wanted_ = true;
            break;
        case Action::save_game:
            controls_.save_wanted = true;
            break;
        case Action::export_plots:
            export_wanted_ = layout_.strip.height > 0;
            if (!export_wanted_) controls_.notice = "No plots are on show: I closes the step bar";
            break;
        case Action::edit:
            return editor_.on() ? end_edit() : begin_edit();
        case Action::scenes:
            return browse();
        case Action::help:
            controls_.help_open = !controls_.help_open;
            break;
        case Action::quit:
            if (controls_.by_keys)
                controls_.by_keys = false;
            else if (controls_.help_open)
                controls_.help_open = false;
            else if (!hand_.let_go() && !std::exchange(controls_.impact_open, false))
                leave();
            break;
        default:
            break;
    }
}

/// By a key that also closes other things: it would be a pity to press it once too often.
void App::leave() {
    constexpr std::string_view question = "A game is under way. Esc once more ends it.";
    if (!is_game_under_way(stage_) || controls_.notice.words() == question) return close();
    controls_.notice.tell(question);
}

void App::drop_slowest() {
    if (stage_.runs().size() == 1) return;
    microscope_.close();
    stage_.remove_contender(stage_.slowest());
}

/// With the step bar open.
void App::act_inside(Action action) {
    if (stage_.under_way()) return;
    const bool shown = microscope_.shows(stage_);
    if (action == Action::step_once && !(shown && microscope_.next())) {
        controls_.paused = true;
        microscope_.take_step(stage_);
    }
    if (action == Action::step_whole) {
        controls_.paused = true;
        microscope_.take_step(stage_);
        microscope_.to_last();
    }
    if (!shown) return;
    if (action == Action::stage_back) microscope_.back();
    if (action == Action::item_next) microscope_.pick_next();
    if (action == Action::item_back) microscope_.pick_before();
    if (action == Action::look_at_next) microscope_.look_at((microscope_.run() + 1) % stage_.runs().size());
}

}  // namespace flipside::app
