#include "lab/session/recording.hpp"

#include <algorithm>
#include <utility>

namespace flipside::lab {

Recording::Recording(const Engine& engine, Settings settings, Vec2 gravity)
    : start_(std::make_shared<const move::Change>(move::Change{&engine, std::move(settings), gravity})) {}

Recording& Recording::operator=(const Recording& other) {
    if (this != &other) *this = Recording(other);
    return *this;
}

Recording& Recording::operator=(Recording&& other) noexcept {
    drop();
    start_ = std::move(other.start_);
    last_ = std::move(other.last_);
    size_ = other.size_;
    steps_ = other.steps_;
    dt_ = other.dt_;
    spoiled_ = std::move(other.spoiled_);
    return *this;
}

void Recording::drop() noexcept {
    while (last_ && last_.use_count() == 1) last_ = std::exchange(last_->before, nullptr);
    last_.reset();
}

void Recording::add(Move move) {
    last_ = std::make_shared<Link>(Link{{steps_, std::move(move)}, std::move(last_)});
    ++size_;
}

void Recording::begin_step(double dt) {
    if (dt == dt_) return;
    dt_ = dt;
    add(move::StepLength{dt});
}

void Recording::spoil(const std::string& reason) {
    if (!spoiled_) spoiled_ = reason;
}

std::vector<Recording::Entry> Recording::entries() const {
    std::vector<Entry> all;
    all.reserve(size_);
    for (const Link* link = last_.get(); link != nullptr; link = link->before.get())
        all.push_back(link->entry);
    std::ranges::reverse(all);
    return all;
}

Script Recording::controls() const {
    Script script;
    const auto add = [&](double time, const Control& control) {
        script.push_back({script.empty() ? time : std::max(time, script.back().time), control});
    };
    for (const Entry& entry : entries()) {
        if (const auto* press = std::get_if<move::Press>(&entry.move)) add(press->time, press->control);
        if (const auto* scripted = std::get_if<move::Scripted>(&entry.move))
            add(scripted->timed.time, scripted->timed.control);
    }
    return script;
}

}  // namespace flipside::lab
