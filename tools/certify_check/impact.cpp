#include <limits>

#include "checker.hpp"

namespace certificate {

void Checker::check_beginning() {
    const Leg& now = leg();
    const double t = now.start, r = ball_->radius;
    const Motion is = motion_of(now, I(t));
    require_same("velocity as stated", is.place.x.c[1], I(now.velocity[0]), speed_, t);
    require_same("velocity as stated", is.place.y.c[1], I(now.velocity[1]), speed_, t);
    if (leg_ == 0) return check_given(nullptr);
    const Leg& before = ball_->legs[leg_ - 1];
    const Motion was = motion_of(before, I(t));
    require_same("position is continuous", was.place.x.c[0], is.place.x.c[0], r, t);
    require_same("position is continuous", was.place.y.c[0], is.place.y.c[0], r, t);
    if (now.why == "given") return check_given(&was);
    After after{was.place.x.c[1], was.place.y.c[1], was.spin.c[0]};
    if (now.why != "goes on") {
        require_same("velocity before as stated", after.vx, I(now.velocity_before[0]), speed_, t);
        require_same("velocity before as stated", after.vy, I(now.velocity_before[1]), speed_, t);
        require_same("spin before as stated", r * after.spin, I(r * now.spin_before), speed_, t);
        now.why == "part" ? hit_part(before, after) : hit_ball(before, was, after);
    }
    require_same("velocity follows the law", after.vx, is.place.x.c[1], speed_, t);
    require_same("velocity follows the law", after.vy, is.place.y.c[1], speed_, t);
    require_same("spin follows the law", r * after.spin, r * is.spin.c[0], speed_, t);
}

/// At the start, or by an input.
void Checker::check_given(const Motion* was) {
    const Leg& now = leg();
    ++verdict_.given;
    if (was == nullptr && now.start == 0) return;
    const Motion is = motion_of(now, I(now.start));
    double wrong = std::numeric_limits<double>::infinity();
    for (const Input& input : run_.inputs) {
        if (input.time != now.start ||
            (input.ball >= 0 && static_cast<std::size_t>(input.ball) != ball_->number))
            continue;
        const bool adds = input.ball < 0 && was != nullptr;
        const I x = input.velocity[0] + (adds ? was->place.x.c[1] : I(0));
        const I y = input.velocity[1] + (adds ? was->place.y.c[1] : I(0));
        wrong = std::min(wrong, std::max(size(x - is.place.x.c[1]), size(y - is.place.y.c[1])));
    }
    require("velocity is that of an input", wrong, speed_, now.start);
}

/// The gap is zero, changes its sign within the interval stated, and falls all over it. Without an interval
/// it is a touch without approach, which changes nothing, or a graze.
template <class Gap>
void Checker::check_touch(const Gap& gap, const I& closing) {
    const Leg& now = leg();
    require("gap at an impact is 0", size(gap(I(now.start)).c[0]), ball_->radius, now.start);
    if (now.within < 0) {
        ++(size(closing) <= bound_ * speed_ ? verdict_.touches : verdict_.not_isolated);
        return;
    }
    ++verdict_.impacts;
    const double from = now.start - now.within, to = now.start + now.within;
    if (!(low(gap(I(from)).c[0]) > 0))
        reject("gap before the isolating interval is above 0", from, now.within);
    if (!(high(gap(I(to)).c[0]) < 0)) reject("gap after the isolating interval is below 0", to, now.within);
    const I slope = range([&](const I& t) { return gap(t).derivative(); }, from, to);
    if (!(high(slope) < 0)) reject("gap falls all over the isolating interval", from, high(slope));
}

void Checker::check_normal(const I& nx, const I& ny) {
    require_same("normal as stated", nx, I(leg().normal[0]), 1, leg().start);
    require_same("normal as stated", ny, I(leg().normal[1]), 1, leg().start);
}

/// Restitution and kick, unless it is slower than the rest speed (so near to it that either may be, what was
/// done decides: `parting`, the speed at which they part). A disc resists a push at its rim with a third of
/// its mass.
Checker::Push Checker::push(const Material& other, const I& closing, const I& slip, const I& parting) const {
    const Material& own = run_.materials[ball_->material];
    const double near = bound_ * speed_, over = low(closing) - run_.rest_speed;
    const bool rests = over < -near || (over <= near && high(parting) <= 2 * near);
    const I back = own.restitution * other.restitution * closing, kick(std::max(own.kick, other.kick));
    const I along = closing + (rests ? I(0) : low(back) >= low(kick) ? back : kick);
    const I most = std::sqrt(own.friction * other.friction) * along, stop = -slip / 3;
    return {along, low(stop) > high(most) ? most : high(stop) < low(-most) ? I(-most) : stop};
}

void Checker::hit_part(const Leg& before, After& after) {
    const Leg& now = leg();
    const Part& part = part_of(now.met);
    const Span* span = span_at(part, now.start);
    const double r = ball_->radius;
    const auto lie_at = [&](const Feature& f, const I& t) {
        return lie_of(f, part, span, motion_of(before, t).place, r, t);
    };
    const Feature* touched = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const Feature& f : features_[now.met]) {
        const Lie at = lie_at(f, I(now.start));
        const double wrong = size(at.gap.c[0]) / r + size(at.normal.x.c[0] - now.normal[0]) +
                             size(at.normal.y.c[0] - now.normal[1]);
        if (at.facing && wrong < least) least = wrong, touched = &f;
    }
    if (touched == nullptr) reject("the primitive that it meets faces it", now.start, 0);
    const Lie at = lie_at(*touched, I(now.start));
    const I nx = at.normal.x.c[0], ny = at.normal.y.c[0], ux = at.velocity.x.c[0], uy = at.velocity.y.c[0];
    const I x = after.vx - ux, y = after.vy - uy, closing = -(x * nx + y * ny);
    check_normal(nx, ny);
    check_touch([&](const I& t) { return lie_at(*touched, t).gap; }, closing);
    const Push given = push(run_.materials[part.material], closing, nx * y - ny * x - r * after.spin,
                            (now.velocity[0] - ux) * nx + (now.velocity[1] - uy) * ny);
    after.vx += given.along * nx - given.across * ny;
    after.vy += given.along * ny + given.across * nx;
    after.spin -= 2 * given.across / r;
}

void Checker::hit_ball(const Leg& before, const Motion& was, After& after) {
    const Leg& now = leg();
    const auto other = std::ranges::find(run_.balls, now.met, &Ball::number);
    if (other == run_.balls.end()) reject("the ball that it meets is there", now.start, 0);
    // Two balls may meet more than once at an instant: the n-th of the one is the n-th of the other.
    const auto meetings = [&](const Ball& ball, std::size_t met, std::size_t last) {
        std::vector<std::size_t> legs;
        for (std::size_t i = 1; i < ball.legs.size() && i <= last; ++i)
            if (ball.legs[i].why == "ball" && ball.legs[i].met == met && ball.legs[i].start == now.start)
                legs.push_back(i);
        return legs;
    };
    const std::size_t n = meetings(*ball_, now.met, leg_).size();
    const auto theirs = meetings(*other, ball_->number, other->legs.size());
    if (n > theirs.size()) reject("the ball that it meets meets it", now.start, 0);
    const Leg &partner = other->legs[theirs[n - 1] - 1], &partner_now = other->legs[theirs[n - 1]];
    const auto gap = [&](const I& t) {
        const Motion a = motion_of(before, t), b = motion_of(partner, t);
        return length(a.place.x - b.place.x, a.place.y - b.place.y) - (I(ball_->radius) + other->radius);
    };
    const Motion met = motion_of(partner, I(now.start));
    const I dx = was.place.x.c[0] - met.place.x.c[0], dy = was.place.y.c[0] - met.place.y.c[0];
    const I far = sqrt(I(square(dx) + square(dy))), nx = dx / far, ny = dy / far;
    const I x = after.vx - met.place.x.c[1], y = after.vy - met.place.y.c[1], closing = -(x * nx + y * ny);
    check_normal(nx, ny);
    check_touch(gap, closing);
    const I slip = nx * y - ny * x - ball_->radius * after.spin - other->radius * met.spin.c[0];
    const Push given = push(run_.materials[other->material], closing, slip,
                            (now.velocity[0] - I(partner_now.velocity[0])) * nx +
                                (now.velocity[1] - I(partner_now.velocity[1])) * ny);
    const I share = I(other->mass) / (I(ball_->mass) + other->mass);
    after.vx += share * (given.along * nx - given.across * ny);
    after.vy += share * (given.along * ny + given.across * nx);
    after.spin -= 2 * share * given.across / ball_->radius;
}

}  // namespace certificate
