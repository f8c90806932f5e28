#include "app/window/keys.hpp"

#include <algorithm>

namespace flipside::app {

namespace {

using K = sf::Keyboard;
constexpr K::Key no = K::Unknown;

constexpr KeyUse uses[] = {
    {Action::launch, {K::Space, no, no}, "Space", "Launch; hold it to charge"},
    {Action::flip_left, {K::LShift, K::Left, no}, "left Shift  ←", "Raise the left flippers while held"},
    {Action::flip_right, {K::RShift, K::Right, no}, "right Shift  →", "Raise the right flippers while held"},
    {Action::nudge_left, {K::B, no, no}, "B", "Nudge the table to the left"},
    {Action::nudge_forward, {K::N, no, no}, "N", "Nudge it forward; too much of this tilts it"},
    {Action::nudge_right, {K::M, no, no}, "M", "Nudge it to the right"},
    {Action::pause, {K::P, no, no}, "P", "Pause, or go on"},
    {Action::step_once,
     {K::Period, no, no},
     ".",
     "Pause, and take one step; inside a step, go to its next stage"},
    {Action::look_inside, {K::I, no, no}, "I", "Look inside a step, stage by stage, or close that"},
    {Action::stage_back,
     {K::Comma, no, no},
     ",",
     "Pause, and go back one step; inside a step, to the stage before"},
    {Action::to_record_begin, {K::Home, no, no}, "Home", "Back by all of the last half minute"},
    {Action::to_record_end, {K::End, no, no}, "End", "And forth again to its end"},
    {Action::step_whole, {no, no, no}, "Shift .", "Inside a step: the whole next step"},
    {Action::item_back, {K::LBracket, no, no}, "[", "Inside a step: the item before"},
    {Action::item_next, {K::RBracket, no, no}, "]", "Inside a step: the next item"},
    {Action::look_at_next, {K::C, no, no}, "C", "Inside a step: look at the next engine's"},
    {Action::slow_motion, {K::S, no, no}, "S", "Slow motion, ten times slower"},
    {Action::restart, {K::R, no, no}, "R", "Start the scene again"},
    {Action::switch_engine, {K::Tab, no, no}, "Tab", "Switch the engine under the running ball"},
    {Action::reference, {K::E, no, no}, "E", "Show the exact reference, or hide it"},
    {Action::take_up, {K::T, no, no}, "T", "Take up the reference again from the state on show"},
    {Action::next_view, {K::V, no, no}, "V", "Next view"},
    {Action::view_single, {K::Num1, K::Numpad1, no}, "1", "One engine"},
    {Action::view_split, {K::Num2, K::Numpad2, no}, "2", "The engines side by side"},
    {Action::view_overlay, {K::Num3, K::Numpad3, no}, "3", "The engines on one table"},
    {Action::next_plots, {K::G, no, no}, "G", "Next plots: distance, energy, cost, tests"},
    {Action::fold_panel, {K::F2, no, no}, "F2", "Fold the controls away, or open them"},
    {Action::screenshot, {K::F12, no, no}, "F12", "Save a picture of the window"},
    {Action::export_plots, {K::F11, no, no}, "F11", "Save the plots as a picture, and their numbers as CSV"},
    {Action::help, {K::F1, no, no}, "F1", "This help"},
    {Action::quit, {K::Escape, no, no}, "Esc", "Close this help, or the window"}};

}  // namespace

std::span<const KeyUse> key_uses() {
    return uses;
}

Action action_of(sf::Keyboard::Key key) {
    if (key == no) return Action::none;
    for (const KeyUse& use : uses)
        if (std::ranges::find(use.keys, key) != std::end(use.keys)) return use.action;
    return Action::none;
}

Action action_of(const sf::Event::KeyEvent& key) {
    return key.shift && key.code == K::Period ? Action::step_whole : action_of(key.code);
}

}  // namespace flipside::app
