#pragma once
/// What the user has set in the window, by keys or in the panel.

#include <map>
#include <string>
#include <string_view>

#include "app/window/layout.hpp"
#include "app/window/notice.hpp"
#include "app/window/plots.hpp"
#include "app/window/table_view.hpp"

namespace flipside::app {

struct WindowControls {
    Look look;
    bool paused = false;
    int single_steps = 0;  ///< to take while paused
    double speed = 1;      ///< simulated seconds per second
    bool panel_open = true;
    bool help_open = false;
    bool impact_open = false;  ///< the card of the last impact, while nothing is picked
    bool bar_open = false;     ///< the step bar
    bool by_keys = false;      ///< keys work the controls instead of the table
    bool muted = false;
    bool has_sound = false;         ///< there is a device to play sound
    double scale = 0;               ///< of letters and controls; 0: as suits the window
    bool newcomer = false;          ///< has an offer of where to begin
    bool lesson_wanted = false;     ///< the lessons come to the front of the panel
    bool artwork_left_out = false;  ///< for want of time to draw it
    PlotChoice plots = PlotChoice::distance_and_energy;
    double strip = 0;          ///< height of the plots, as in LayoutNeeds
    bool save_wanted = false;  ///< this game, as a replay
    bool edit_wanted = false, browse_wanted = false;
    bool table_wanted = true;  ///< or the table does
    int launch_count = 1;
    double launch_size = 1;        ///< radius over that of the launcher's ball
    double launch_strength = 0.7;  ///< 0…1 between the launcher's slowest and fastest
    Notice notice;
};

inline constexpr std::string_view no_place = "There is no free place for a ball";
inline constexpr std::string_view no_ball_picked = "Pick a ball first: click it, or O";
inline constexpr std::string_view no_reference = "There is no reference to take up: E shows it";
inline constexpr std::string_view no_guide =
    "Only the reference is on show: there is no other to take its state from";
inline constexpr std::string_view no_room = "There is room for four panes: take one away first";

/// How busy the program is, over the last second.
struct Load {
    double frames_per_second = 0;
    double busy = 0;     ///< share of a frame's time spent working, 0…1
    double physics = 0;  ///< the part of it that the engines took
    double asked = 1;    ///< simulated seconds per second that were due
    double reached = 1;  ///< and as the engines made them
};

/// Where the controls of the panel were drawn, by label, px.
struct ControlPlaces : std::map<std::string, Rect> {
    std::string focus;  ///< the label of the one that keys work
};

}  // namespace flipside::app
