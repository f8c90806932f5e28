#pragma once
/// What the rules have to tell the player, as data. Words are made where they are shown.

namespace flipside::lab {

/// By rising rank: of two that come at once the later kind is the one to show.
enum class CaptionKind {
    lane,            ///< `value` of `of` rollovers of a group are lit
    target,          ///< `value` of `of` targets of a group are down
    ball_search,     ///< a ball met nothing for long; the table shakes itself
    lanes_complete,  ///< pays `value`; the end bonus is paid `of` times from now on
    bank_complete,   ///< a group of targets is down; pays `value`; `of` more lead to multiball
    skill_shot,      ///< pays `value`
    jackpot,         ///< pays `value`
    multiball,       ///< `value` balls
    ball_saved,      ///< `value` is 1 where the player launches it again, 0 where the table does
    tilt_warning,    ///< the next nudge tilts
    bonus,           ///< `value` points, `of` times
    tilt
};

struct Caption {
    CaptionKind kind;
    double time = 0;  ///< s
    long value = 0, of = 0;

    friend bool operator==(const Caption&, const Caption&) = default;
};

}  // namespace flipside::lab
