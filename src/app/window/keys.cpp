#include "app/window/keys.hpp"

#include <algorithm>

namespace flipside::app {

namespace {

using K = sf::Keyboard;
constexpr K::Key no = K::Unknown;
constexpr Held none = Held::nothing;

constexpr KeyUse uses[] = {
    {Action::launch,
     {K::Space, no, no},
     none,
     "Space",
     "Launch; hold it to charge. After a game: play again"},
    {Action::flip_left,
     {K::LShift, K::Left, no},
     none,
     "left Shift  ←",
     "Raise the left flippers while held"},
    {Action::flip_right,
     {K::RShift, K::Right, no},
     none,
     "right Shift  →",
     "Raise the right flippers while held"},
    {Action::nudge_left, {K::B, no, no}, none, "B", "Nudge the table to the left"},
    {Action::nudge_forward, {K::N, no, no}, none, "N", "Nudge it forward; too much of this tilts it"},
    {Action::nudge_right, {K::M, no, no}, none, "M", "Nudge it to the right"},
    {Action::pause, {K::P, no, no}, none, "P", "Pause, or go on"},
    {Action::step_once,
     {K::Period, no, no},
     none,
     ".",
     "Pause, and take one step; inside a step, go to its next stage"},
    {Action::look_inside, {K::I, no, no}, none, "I", "Look inside a step, stage by stage, or close that"},
    {Action::stage_back,
     {K::Comma, no, no},
     none,
     ",",
     "Pause, and go back one step; inside a step, to the stage before"},
    {Action::to_record_begin, {K::Home, no, no}, none, "Home", "Back by all of the last half minute"},
    {Action::to_record_end, {K::End, no, no}, none, "End", "Forward again to its end"},
    {Action::step_whole, {K::Period, no, no}, Held::shift, "Shift .", "Inside a step: the whole next step"},
    {Action::item_back, {K::LBracket, no, no}, none, "[", "Inside a step: the item before"},
    {Action::item_next, {K::RBracket, no, no}, none, "]", "Inside a step: the next item"},
    {Action::look_at_next, {K::C, no, no}, none, "C", "Inside a step: look at the next engine's"},
    {Action::slow_motion, {K::S, no, no}, none, "S", "Slow motion, ten times slower"},
    {Action::mute, {K::Q, no, no}, none, "Q", "Quiet: sound off, or on again"},
    {Action::restart, {K::R, no, no}, none, "R", "Start the scene again"},
    {Action::switch_engine, {K::Tab, no, no}, none, "Tab", "Switch the engine under the running ball"},
    {Action::reference, {K::E, no, no}, none, "E", "Show the exact reference, or hide it"},
    {Action::take_up, {K::T, no, no}, none, "T", "Take up the reference again from the state on show"},
    {Action::next_view, {K::V, no, no}, none, "V", "Next view"},
    {Action::view_single, {K::Num1, K::Numpad1, no}, none, "1", "One engine"},
    {Action::view_split, {K::Num2, K::Numpad2, no}, none, "2", "The engines side by side"},
    {Action::view_overlay, {K::Num3, K::Numpad3, no}, none, "3", "The engines on one table"},
    {Action::drop_slowest, {K::X, no, no}, none, "X", "Take the slowest of several panes away"},
    {Action::next_plots, {K::G, no, no}, none, "G", "Next plots: distance, energy, cost, tests"},
    {Action::next_ball, {K::O, no, no}, none, "O", "Pick the next ball"},
    {Action::next_part, {K::L, no, no}, none, "L", "Pick the next part"},
    {Action::last_impact, {K::K, no, no}, none, "K", "The last impact on every engine, or close that"},
    {Action::remove_ball, {K::Delete, no, no}, none, "Delete", "Take the picked ball off the table"},
    {Action::fold_panel, {K::F2, no, no}, none, "F2", "Fold the controls away, or open them"},
    {Action::scenes, {K::F3, no, no}, none, "F3", "All scenes, with pictures"},
    {Action::edit, {K::F4, no, no}, none, "F4", "Draw the table by hand, or play what is drawn"},
    {Action::work_controls,
     {K::F6, no, no},
     none,
     "F6",
     "Work the controls by arrows, Space and Enter; Esc goes back"},
    {Action::larger, {K::Equal, K::Add, no}, Held::ctrl, "Ctrl +", "Everything larger"},
    {Action::smaller, {K::Hyphen, K::Subtract, no}, Held::ctrl, "Ctrl −", "Everything smaller"},
    {Action::usual_size, {K::Num0, K::Numpad0, no}, Held::ctrl, "Ctrl 0", "The size that suits the window"},
    {Action::save_game, {K::F5, no, no}, none, "F5", "Save this game as a replay"},
    {Action::screenshot, {K::F12, no, no}, none, "F12", "Save a picture of the window"},
    {Action::export_plots,
     {K::F11, no, no},
     none,
     "F11",
     "Save the plots as a picture, and their numbers as CSV"},
    {Action::help, {K::F1, no, no}, none, "F1", "This help"},
    {Action::quit,
     {K::Escape, no, no},
     none,
     "Esc",
     "Close this help, what is picked, or the window (in a game: twice)"}};

}  // namespace

std::span<const KeyUse> key_uses() {
    return uses;
}

namespace {

Action action_of(sf::Keyboard::Key key, Held with) {
    if (key == no) return Action::none;
    for (const KeyUse& use : uses)
        if (use.with == with && std::ranges::find(use.keys, key) != std::end(use.keys)) return use.action;
    return Action::none;
}

}  // namespace

Action action_of(sf::Keyboard::Key key) {
    return action_of(key, Held::nothing);
}

Action action_of(const sf::Event::KeyEvent& key) {
    if (key.alt) return Action::none;
    if (key.control) return action_of(key.code, Held::ctrl);
    const Action shifted = key.shift ? action_of(key.code, Held::shift) : Action::none;
    return shifted == Action::none ? action_of(key.code) : shifted;
}

}  // namespace flipside::app
