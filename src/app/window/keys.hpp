#pragma once
/// What each key does: one table that the input, the help and the tests share.

#include <span>
#include <string_view>

#include <SFML/Window/Event.hpp>

namespace flipside::app {

enum class Action {
    none,
    launch,
    flip_left,
    flip_right,
    nudge_left,
    nudge_forward,
    nudge_right,
    pause,
    step_once,
    step_whole,
    to_record_begin,
    to_record_end,
    stage_back,
    item_next,
    item_back,
    look_inside,
    look_at_next,
    slow_motion,
    mute,
    restart,
    switch_engine,
    reference,
    take_up,
    next_view,
    view_single,
    view_split,
    view_overlay,
    next_plots,
    next_ball,
    next_part,
    last_impact,
    remove_ball,
    fold_panel,
    scenes,
    edit,
    work_controls,
    larger,
    smaller,
    usual_size,
    drop_slowest,
    screenshot,
    save_game,
    export_plots,
    help,
    quit
};

/// What is held down with a key. What is held with Ctrl or Alt otherwise does nothing.
enum class Held { nothing, shift, ctrl };

struct KeyUse {
    Action action;
    sf::Keyboard::Key keys[3];  ///< any of them; Unknown where there are fewer
    Held with;
    std::string_view names;  ///< as printed on them
    std::string_view meaning;
};

/// In the order of the help.
[[nodiscard]] std::span<const KeyUse> key_uses();
/// Of the key alone.
[[nodiscard]] Action action_of(sf::Keyboard::Key key);
/// With what is held beside it.
[[nodiscard]] Action action_of(const sf::Event::KeyEvent& key);

}  // namespace flipside::app
