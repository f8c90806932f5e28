#include <cstdio>

#include "checker.hpp"

namespace certificate {

Checker::Checker(const Run& run, double bound) : run_(run), bound_(bound) {
    for (const Primitive& primitive : run.primitives) features_.push_back(features_of(primitive, run));
}

Verdict Checker::check() {
    for (const Part& part : run_.parts) check_turning(part);
    check_targets();
    for (const Ball& ball : run_.balls) {
        ++verdict_.balls;
        ball_ = &ball;
        for (leg_ = 0; leg_ < ball.legs.size(); ++leg_) {
            ++verdict_.legs;
            set_scales();
            check_beginning();
            check_motion();
            for (std::size_t primitive = 0; primitive < run_.primitives.size(); ++primitive)
                check_clear_of(primitive);
            for (const Ball& other : run_.balls)
                if (other.number > ball.number && meets(ball, other)) check_clear_of(other);
            for (const Passage& passage : run_.passages)
                if (passage.ball == ball.number) check_passage(passage);
        }
        if (!ball.gone.empty()) check_gone();
    }
    return verdict_;
}

void Checker::reject(const std::string& what, double time, double by) const {
    char figures[96];
    std::snprintf(figures, sizeof figures, ", not so at %.12g s by %.3g", time, by);
    throw Rejected("ball " + std::to_string(ball_->number) + ", segment " + std::to_string(leg_) + ": " +
                   what + figures);
}
void Checker::require(const char* what, double value, double scale, double time) {
    if (!(value <= bound_ * scale)) reject(what, time, value);
    double& largest = verdict_.largest[what];
    largest = std::max(largest, value / (bound_ * scale));
}
void Checker::require_same(const char* what, const I& a, const I& b, double scale, double time) {
    require(what, size(a - b), scale, time);
}

void Checker::set_scales() {
    const double g = std::hypot(run_.gravity[0], run_.gravity[1]), r = ball_->radius;
    const auto speed = [&](double vx, double vy, double spin) {
        return std::hypot(vx, vy) + r * std::abs(spin);
    };
    speed_ = std::sqrt(r * g) + speed(leg().velocity_before[0], leg().velocity_before[1], leg().spin_before);
    for (const double time : {leg().start, leg().end}) {
        const Motion m = motion_of(leg(), I(time));
        speed_ += speed(size(m.place.x.c[1]), size(m.place.y.c[1]), size(m.spin.c[0]));
    }
    acceleration_ = g + speed_ * speed_ / r;
}

void Checker::check_turning(const Part& part) const {
    for (std::size_t i = 1; i < part.turns.size(); ++i) {
        const Span &a = part.turns[i - 1], &b = part.turns[i];
        const double jump = std::abs(a.angle + a.rate * (b.since - a.since) - b.angle);
        if (!(jump <= bound_ * (1 + std::abs(b.angle)) && a.since <= b.since))
            throw Rejected("part " + part.name + ": its angle jumps at " + std::to_string(b.since) +
                           " s by " + std::to_string(jump));
    }
}

/// A target goes down by a hit only.
void Checker::check_targets() const {
    for (std::size_t part = 0; part < run_.parts.size(); ++part)
        for (const Change& change : run_.parts[part].target) {
            bool hit = !change.down || change.time == 0;
            for (const Ball& ball : run_.balls)
                for (const Leg& one : ball.legs)
                    hit = hit || (one.why == "part" && one.start == change.time &&
                                  run_.primitives[one.met].part == part);
            if (!hit)
                throw Rejected("part " + run_.parts[part].name + ": goes down without a hit at " +
                               std::to_string(change.time) + " s");
        }
}

/// A ball that is lost is on the border of the table, or beyond.
void Checker::check_gone() {
    leg_ = ball_->legs.size() - 1;
    const Motion m = motion_of(leg(), I(ball_->gone[0]));
    const I &x = m.place.x.c[0], &y = m.place.y.c[0];
    const double inside = std::min(
        {low(x) - run_.least[0], run_.most[0] - high(x), low(y) - run_.least[1], run_.most[1] - high(y)});
    require("is at the border when it is lost", std::max(0.0, inside), ball_->radius, leg().end);
}

/// How the part turns at a time; of two spans that meet there the earlier.
const Span* Checker::span_at(const Part& part, double time) {
    const Span* found = part.turns.empty() ? nullptr : part.turns.data();
    for (const Span& span : part.turns)
        if (span.since < time) found = &span;
    return found;
}

double Checker::friction_with(const Part& part) const {
    return std::sqrt(run_.materials[ball_->material].friction * run_.materials[part.material].friction);
}

Verdict check(const Run& run, double bound) {
    return Checker(run, bound).check();
}

}  // namespace certificate
