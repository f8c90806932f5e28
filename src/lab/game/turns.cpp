#include "lab/game/turns.hpp"

namespace flipside::lab {

namespace {

/// Between two balls that the table fires, so that they do not meet in the launcher's lane.
constexpr double between_brought = 1;  // s

}  // namespace

void Turns::resume(std::size_t balls, std::size_t waiting) {
    in_play_ = static_cast<long>(balls);
    own_ = std::min(own_, in_play_);
    coming_ = std::min(coming_, static_cast<int>(waiting));
}

void Turns::start_multiball(int balls, double time) {
    multiball_ = true;
    save_until_ = std::max(save_until_, time + ball_save_);
    to_bring_ = std::max(0, balls - static_cast<int>(own_));
    next_bring_ = time + between_brought;
}

void Turns::forfeit() {
    save_until_ = -1;
    to_bring_ = 0;
    fresh_ = false;
}

void Turns::brought(double time) {
    --to_bring_;
    ++coming_;
    next_bring_ = time + between_brought;
}

void Turns::enter(long entered) {
    launched_ += entered;
    const long brought = std::min<long>(entered, coming_);
    const long mine = std::min<long>(entered - brought, left_);
    coming_ -= static_cast<int>(brought);
    left_ -= static_cast<int>(mine);
    own_ += brought + mine;
    if (brought + mine == 0) return;
    open_ = true;
    again_ = false;
}

void Turns::lose(int lost, double time, Change& change) {
    lost_ += lost;
    if (saves(time) && lost > 0) {
        change.saved = static_cast<int>(std::min<long>(own_, lost));
        own_ -= change.saved;
        if (multiball_) {
            to_bring_ += change.saved;
        } else if (change.saved > 0) {
            left_ += change.saved;
            again_ = change.again = true;
            fresh_ = false;
        }
    }
    if (own_ <= in_play_) return;
    own_ = in_play_;
    again_ = false;  // of several that were launched at once, the last one was lost for good
}

Turns::Change Turns::count(std::size_t balls, int lost, int gone, double time) {
    const long now = static_cast<long>(balls);
    const long entered = std::max(0L, now - (in_play_ - gone));
    in_play_ = now;
    enter(entered);
    Change change;
    lose(lost, time, change);
    multiball_ &= own_ + coming_ + to_bring_ > 1;
    if (!open_ || in_play_ > 0 || bringing() || again_) return change;
    open_ = false;
    fresh_ = true;
    save_until_ = -1;
    change.ended = true;
    return change;
}

int Turns::number() const {
    const int next = open_ && !again_ ? 0 : 1;
    return std::clamp(turns_ - left_ + next, 1, std::max(1, turns_));
}

}  // namespace flipside::lab
