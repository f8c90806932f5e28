#include "check.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

namespace certificate {

namespace {

I dot(const JetVec& a, const JetVec& b) {
    return a.x.c[0] * b.x.c[0] + a.y.c[0] * b.y.c[0];
}
JetVec velocity_of(const Motion& m) {
    return {m.place.x.derivative(), m.place.y.derivative()};
}
bool meets(const auto& a, const auto& b) {
    return (a.layer & b.collides_with) != 0 && (b.layer & a.collides_with) != 0;
}

class Checker {
  public:
    Checker(const Run& run, double bound) : run_(run), bound_(bound) {
        for (const Piece& piece : run.pieces) features_.push_back(features_of(piece, run));
    }

    Verdict check() {
        for (const Part& part : run_.parts) check_turning(part);
        for (const Ball& ball : run_.balls) {
            ++verdict_.balls;
            for (leg_ = 0; leg_ < ball.legs.size(); ++leg_) {
                ++verdict_.legs;
                ball_ = &ball;
                set_scales();
                check_beginning();
                check_motion();
                for (std::size_t piece = 0; piece < run_.pieces.size(); ++piece) check_clear_of(piece);
                for (const Ball& other : run_.balls)
                    if (other.number > ball.number && meets(ball, other)) check_clear_of(other);
            }
            if (!ball.gone.empty()) check_gone();
        }
        for (const Passage& passage : run_.passages) verdict_.let_through += passage.until - passage.from;
        return verdict_;
    }

  private:
    [[nodiscard]] const Leg& leg() const { return ball_->legs[leg_]; }

    [[noreturn]] void reject(const std::string& what, double time, double by) const {
        char figures[128];
        std::snprintf(figures, sizeof figures, ", at %.12g s, by %.3g", time, by);
        throw Rejected("ball " + std::to_string(ball_->number) + ", segment " + std::to_string(leg_) + ": " +
                       what + figures);
    }
    /// |value| ≤ bound·scale, or value ≥ −bound·scale.
    void require(const char* what, double value, double scale, double time) {
        double& largest = verdict_.largest[what];
        largest = std::max(largest, value / (bound_ * scale));
        if (!(value <= bound_ * scale)) reject(what, time, value);
    }
    void require_same(const char* what, const I& a, const I& b, double scale, double time) {
        require(what, size(a - b), scale, time);
    }

    void set_scales() {
        const auto speed_at = [&](double time) {
            const Motion m = motion_of(leg(), I(time));
            return std::hypot(size(m.place.x.c[1]), size(m.place.y.c[1])) + ball_->radius * size(m.spin.c[0]);
        };
        const double g = std::hypot(run_.gravity[0], run_.gravity[1]), r = ball_->radius;
        speed_ = std::max(speed_at(leg().start), speed_at(leg().end)) + std::sqrt(r * g);
        if (leg_ > 0)
            speed_ += std::hypot(leg().velocity_before[0], leg().velocity_before[1]) +
                      r * std::abs(leg().spin_before);
        acceleration_ = g + speed_ * speed_ / r;
    }

    void check_turning(const Part& part) const {
        for (std::size_t i = 1; i < part.turns.size(); ++i) {
            const Span &a = part.turns[i - 1], &b = part.turns[i];
            const double jump = std::abs(a.angle + a.rate * (b.since - a.since) - b.angle);
            if (jump > bound_)
                throw Rejected("part " + part.name + ": jumps at " + std::to_string(b.since) + " s");
        }
    }

    /// How the part turns at a time; of two spans that meet there the earlier.
    static const Span* span_at(const Part& part, double time) {
        const Span* found = part.turns.empty() ? nullptr : &part.turns[0];
        for (const Span& span : part.turns)
            if (span.since < time) found = &span;
        return found;
    }

    void check_beginning() {
        const Leg& now = leg();
        const double t = now.start, r = ball_->radius;
        if (now.why == "given") {
            ++verdict_.given;
            return;
        }
        if (leg_ == 0) reject("its first segment is not given", t, 0);
        const Leg& before = ball_->legs[leg_ - 1];
        const Motion was = motion_of(before, I(t)), is = motion_of(now, I(t));
        require_same("position is continuous", was.place.x.c[0], is.place.x.c[0], r, t);
        require_same("position is continuous", was.place.y.c[0], is.place.y.c[0], r, t);
        I vx = was.place.x.c[1], vy = was.place.y.c[1], spin = was.spin.c[0];
        if (now.why == "part" || now.why == "ball") {
            require_same("velocity before as stated", vx, I(now.velocity_before[0]), speed_, t);
            require_same("velocity before as stated", vy, I(now.velocity_before[1]), speed_, t);
            require_same("spin before as stated", r * spin, I(r * now.spin_before), speed_, t);
            now.why == "part" ? hit_part(before, was, vx, vy, spin) : hit_ball(before, was, vx, vy, spin);
        }
        require_same("velocity follows the law", vx, is.place.x.c[1], speed_, t);
        require_same("velocity follows the law", vy, is.place.y.c[1], speed_, t);
        require_same("spin follows the law", r * spin, r * is.spin.c[0], speed_, t);
    }

    /// The gap is zero, changes its sign within the interval stated, and falls all over it.
    template <class Gap>
    void check_touch(const Gap& gap) {
        const Leg& now = leg();
        ++verdict_.impacts;
        require("gap at an impact is 0", size(gap(I(now.start)).c[0]), ball_->radius, now.start);
        if (now.within < 0) {
            ++verdict_.not_isolated;
            return;
        }
        const double from = now.start - now.within, to = now.start + now.within;
        if (!(low(gap(I(from)).c[0]) > 0))
            reject("gap before the isolating interval is above 0", from, now.within);
        if (!(high(gap(I(to)).c[0]) < 0))
            reject("gap after the isolating interval is below 0", to, now.within);
        const I slope = range([&](const I& t) { return gap(t).derivative(); }, from, to);
        if (!(high(slope) < 0)) reject("gap falls all over the isolating interval", from, high(slope));
    }
    void check_normal(const I& nx, const I& ny) {
        require_same("normal as stated", nx, I(leg().normal[0]), 1, leg().start);
        require_same("normal as stated", ny, I(leg().normal[1]), 1, leg().start);
    }

    /// Changes of velocity per impulse (1/m) along the normal and, with the spin, across it.
    struct Answer {
        I along, across;
    };
    /// Impulses per unit of 1/mass; slip is that of the surfaces, of which a disc resists with a third.
    Answer answer(const Material& a, const Material& b, const I& closing, const I& slip, bool rests) const {
        const double e = a.restitution * b.restitution, k = std::max(a.kick, b.kick);
        const double mu = std::sqrt(a.friction * b.friction);
        const I away = rests ? I(0) : low(e * closing) >= k ? I(e * closing) : I(k);
        const I along = closing + away, most = mu * along, stop = -slip / 3;
        return {along, low(stop) > high(most) ? most : high(stop) < low(-most) ? I(-most) : stop};
    }
    /// Slower than the rest speed it does not rebound; so near to it, both are right.
    [[nodiscard]] bool rests(const I& closing, auto&& apart_after) const {
        const double near = bound_ * speed_;
        if (low(closing) > run_.rest_speed + near) return false;
        if (high(closing) < run_.rest_speed - near) return true;
        return !(std::abs(apart_after()) > 2 * near);
    }

    void hit_part(const Leg& before, const Motion& was, I& vx, I& vy, I& spin) {
        const Leg& now = leg();
        const Part& part = run_.parts[run_.pieces[now.met].part];
        const Span* span = span_at(part, now.start);
        const Feature* touched = nullptr;
        double least = INFINITY;
        for (const Feature& f : features_[now.met]) {
            const Lie lie = lie_of(f, part, span, was.place, ball_->radius, I(now.start));
            const double wrong = size(lie.gap.c[0]) + std::hypot(size(lie.normal.x.c[0] - now.normal[0]),
                                                                 size(lie.normal.y.c[0] - now.normal[1]));
            if (lie.facing && wrong < least) least = wrong, touched = &f;
        }
        if (touched == nullptr) reject("the piece that it meets faces it", now.start, 0);
        check_touch([&](const I& t) {
            return lie_of(*touched, part, span, motion_of(before, t).place, ball_->radius, t).gap;
        });
        const Lie lie = lie_of(*touched, part, span, was.place, ball_->radius, I(now.start));
        const I nx = lie.normal.x.c[0], ny = lie.normal.y.c[0];
        check_normal(nx, ny);
        const I rx = vx - lie.velocity.x.c[0], ry = vy - lie.velocity.y.c[0];
        const I closing = -(rx * nx + ry * ny), slip = nx * ry - ny * rx - ball_->radius * spin;
        const Motion is = motion_of(now, I(now.start));
        const bool stays = rests(
            closing, [&] { return low(dot(velocity_of(is), lie.normal) - dot(lie.velocity, lie.normal)); });
        const Answer push =
            answer(run_.materials[ball_->material], run_.materials[part.material], closing, slip, stays);
        vx += push.along * nx - push.across * ny;
        vy += push.along * ny + push.across * nx;
        spin -= 2 * push.across / ball_->radius;
    }

    void hit_ball(const Leg& before, const Motion& was, I& vx, I& vy, I& spin) {
        const Leg& now = leg();
        const auto other = std::ranges::find(run_.balls, now.met, &Ball::number);
        if (other == run_.balls.end()) reject("the ball that it meets is there", now.start, 0);
        // Those two may meet more than once at an instant.
        const auto together = [&](const Ball& ball, std::size_t met, std::size_t last) {
            std::vector<std::size_t> legs;
            for (std::size_t i = 1; i < ball.legs.size() && i <= last; ++i)
                if (ball.legs[i].why == "ball" && ball.legs[i].met == met && ball.legs[i].start == now.start)
                    legs.push_back(i);
            return legs;
        };
        const auto own = together(*ball_, now.met, leg_),
                   others = together(*other, ball_->number, other->legs.size());
        if (own.size() > others.size()) reject("the ball that it meets meets it", now.start, 0);
        const Leg& partner = other->legs[others[own.size() - 1] - 1];
        const Leg& partner_now = other->legs[others[own.size() - 1]];
        check_touch([&](const I& t) {
            const Motion a = motion_of(before, t), b = motion_of(partner, t);
            return length(a.place.x - b.place.x, a.place.y - b.place.y) -
                   Jet(I(ball_->radius) + other->radius);
        });
        const Motion met = motion_of(partner, I(now.start));
        const I x = was.place.x.c[0] - met.place.x.c[0], y = was.place.y.c[0] - met.place.y.c[0];
        const I far = sqrt(I(square(x) + square(y))), nx = x / far, ny = y / far;
        check_normal(nx, ny);
        const I rx = vx - met.place.x.c[1], ry = vy - met.place.y.c[1];
        const I closing = -(rx * nx + ry * ny);
        const I slip = nx * ry - ny * rx - ball_->radius * spin - other->radius * met.spin.c[0];
        const bool stays = rests(closing, [&] {
            return low((now.velocity[0] - I(partner_now.velocity[0])) * nx +
                       (now.velocity[1] - I(partner_now.velocity[1])) * ny);
        });
        const Answer push =
            answer(run_.materials[ball_->material], run_.materials[other->material], closing, slip, stays);
        const I share = I(other->mass) / (I(ball_->mass) + other->mass);
        vx += share * (push.along * nx - push.across * ny);
        vy += share * (push.along * ny + push.across * nx);
        spin -= 2 * share * push.across / ball_->radius;
    }

    /// Calls `holds(from, to)`, which says yes or nothing yet, on ever smaller parts of the segment.
    template <class Holds>
    void everywhere(const char* what, double from, double to, const Holds& holds) {
        std::vector<std::pair<double, double>> open{{from, to}};
        while (!open.empty()) {
            const auto [a, b] = open.back();
            open.pop_back();
            ++verdict_.comparisons;
            const double by = holds(a, b);
            if (by <= 0) continue;
            const double middle = a + (b - a) / 2;
            if (b - a < 1e-14 || !(middle > a && middle < b)) reject(what, a, by);
            open.emplace_back(middle, b);
            open.emplace_back(a, middle);
        }
    }
    /// The same for one expansion that stays within the bound.
    template <class Value>
    void stays_zero(const char* what, double scale, const Value& value) {
        everywhere(what, leg().start, leg().end, [&](double a, double b) {
            const double wrong = size(range(value, a, b));
            if (wrong <= bound_ * scale) require(what, wrong, scale, a);
            return wrong - bound_ * scale;
        });
    }

    /// Acceleration that is neither gravity nor drag: what the surface does.
    [[nodiscard]] JetVec force_at(const I& t) const {
        const JetVec v = velocity_of(motion_of(leg(), t));
        return {v.x.derivative() - Jet(I(run_.gravity[0])) + I(run_.damping) * v.x,
                v.y.derivative() - Jet(I(run_.gravity[1])) + I(run_.damping) * v.y};
    }

    void check_motion() {
        const Leg& now = leg();
        if (now.held.empty()) {
            stays_zero("flies by the equation of motion", acceleration_,
                       [&](const I& t) { return force_at(t).x; });
            stays_zero("flies by the equation of motion", acceleration_,
                       [&](const I& t) { return force_at(t).y; });
            stays_zero("spin stays in flight", acceleration_ / ball_->radius,
                       [&](const I& t) { return motion_of(now, t).spin.derivative(); });
            return;
        }
        ++verdict_.held;
        std::vector<const Feature*> on;
        for (const std::size_t piece : now.held) on.push_back(&held_on(piece));
        for (std::size_t i = 0; i < on.size(); ++i)
            stays_zero("stays in contact", ball_->radius,
                       [&](const I& t) { return lie(now.held[i], *on[i], t).gap; });
        on.size() == 1 ? check_one_contact(*on[0]) : check_two_contacts(on);
    }
    [[nodiscard]] const Span* span_of(std::size_t piece) const {
        return span_at(run_.parts[run_.pieces[piece].part], std::nextafter(leg().start, INFINITY));
    }
    [[nodiscard]] Lie lie(std::size_t piece, const Feature& f, const I& t) const {
        return lie_of(f, run_.parts[run_.pieces[piece].part], span_of(piece), motion_of(leg(), t).place,
                      ball_->radius, t);
    }
    /// The feature of the piece that the ball touches in the middle of the segment.
    [[nodiscard]] const Feature& held_on(std::size_t piece) const {
        const I middle(leg().start + (leg().end - leg().start) / 2);
        return *std::ranges::min_element(features_[piece], {}, [&](const Feature& f) {
            const Lie at = lie(piece, f, middle);
            return at.facing ? size(at.gap.c[0]) : INFINITY;
        });
    }

    void check_one_contact(const Feature& f) {
        const std::size_t piece = leg().held[0];
        const Part& part = run_.parts[run_.pieces[piece].part];
        const double r = ball_->radius, a = acceleration_;
        const double mu =
            std::sqrt(run_.materials[ball_->material].friction * run_.materials[part.material].friction);
        const auto normal_force = [&](const I& t) {
            const JetVec force = force_at(t), n = lie(piece, f, t).normal;
            return force.x * n.x + force.y * n.y;
        };
        const auto friction = [&](const I& t) {
            const JetVec force = force_at(t), n = lie(piece, f, t).normal;
            return n.x * force.y - n.y * force.x;
        };
        const auto slip = [&](const I& t) {
            const Lie at = lie(piece, f, t);
            const Motion m = motion_of(leg(), t);
            const JetVec v = velocity_of(m), u{v.x - at.velocity.x, v.y - at.velocity.y};
            return at.normal.x * u.y - at.normal.y * u.x - I(r) * m.spin;
        };
        const auto not_below = [&](const char* what, double scale, const auto& value) {
            everywhere(what, leg().start, leg().end,
                       [&](double from, double to) { return -low(range(value, from, to)) - bound_ * scale; });
        };
        not_below("contact force is at least 0", a, normal_force);
        stays_zero("spin changes by friction", a, [&](const I& t) {
            return I(r / 2) * motion_of(leg(), t).spin.derivative() + friction(t);
        });
        const I begins = slip(I(leg().start)).c[0], ends = slip(I(leg().end)).c[0];
        if (std::max(size(begins), size(ends)) <= bound_ * speed_ && mu > 0) {
            stays_zero("rolls without slip", speed_, slip);
            not_below("friction within Coulomb's cone", a,
                      [&](const I& t) { return I(mu) * normal_force(t) - friction(t); });
            not_below("friction within Coulomb's cone", a,
                      [&](const I& t) { return I(mu) * normal_force(t) + friction(t); });
            return;
        }
        const I sign(low(begins) + low(ends) > 0 ? 1 : -1);
        if (mu > 0) not_below("slips one way", speed_, [&](const I& t) { return sign * slip(t); });
        stays_zero("friction against the slip", a,
                   [&](const I& t) { return friction(t) + sign * I(mu) * normal_force(t); });
    }

    /// At rest between two surfaces: its weight is borne by them, with the friction that its spin makes.
    void check_two_contacts(const std::vector<const Feature*>& on) {
        const double t = leg().start;
        if (on.size() != 2 || leg().form != "rest") reject("held by two only at rest", t, 0);
        const double start = size(I(leg().spin)), sign = start == 0 ? 0 : leg().spin > 0 ? 1 : -1;
        I x[2], y[2];
        double mu[2];
        for (std::size_t i = 0; i < 2; ++i) {
            const std::size_t piece = leg().held[i];
            const Part& part = run_.parts[run_.pieces[piece].part];
            mu[i] =
                std::sqrt(run_.materials[ball_->material].friction * run_.materials[part.material].friction);
            const JetVec n = lie(piece, *on[i], I(t)).normal;
            x[i] = n.x.c[0] - sign * mu[i] * n.y.c[0], y[i] = n.y.c[0] + sign * mu[i] * n.x.c[0];
            if (const Span* span = span_of(piece); span && span->rate != 0)
                reject("rests on what stands still", t, 0);
        }
        const I across = x[0] * y[1] - x[1] * y[0], gx = -I(run_.gravity[0]), gy = -I(run_.gravity[1]);
        const I first = (gx * y[1] - x[1] * gy) / across, second = (x[0] * gy - gx * y[0]) / across;
        require("both contact forces are at least 0", std::max(0.0, -std::min(low(first), low(second))),
                acceleration_, t);
        require_same("spin changes by friction", I(leg().spin_rate) * ball_->radius,
                     -2 * sign * (mu[0] * first + mu[1] * second), acceleration_, t);
        require("spin keeps its sense",
                std::max(0.0, -sign * (leg().spin + (leg().end - t) * leg().spin_rate)) * ball_->radius,
                speed_, leg().end);
    }

    [[nodiscard]] bool passes(std::size_t part, double from, double to) const {
        return std::ranges::any_of(run_.passages, [&](const Passage& p) {
            return p.ball == ball_->number && p.gate == part && p.from <= from && to <= p.until;
        });
    }

    /// Times at which something about a part changes, within the segment.
    [[nodiscard]] std::vector<double> changes_of(std::size_t part) const {
        std::vector<double> times{leg().start, leg().end};
        const auto add = [&](double t) {
            if (t > leg().start && t < leg().end) times.push_back(t);
        };
        for (const Span& span : run_.parts[part].turns) add(span.since);
        for (const Change& change : run_.parts[part].target) add(change.time);
        for (const Passage& p : run_.passages)
            if (p.gate == part && p.ball == ball_->number) add(p.from), add(p.until);
        std::ranges::sort(times);
        return times;
    }

    /// It is not nearer to any feature of the piece than touching.
    void check_clear_of(std::size_t piece) {
        const std::size_t index = run_.pieces[piece].part;
        const Part& part = run_.parts[index];
        if (part.sensor || !meets(*ball_, part)) return;
        const bool is_held = std::ranges::find(leg().held, piece) != leg().held.end();
        const Feature* held = is_held ? &held_on(piece) : nullptr;
        const double r = ball_->radius;
        const std::vector<double> times = changes_of(index);
        for (std::size_t i = 0; i + 1 < times.size(); ++i) {
            const double from = times[i], to = times[i + 1], middle = from + (to - from) / 2;
            bool down = false;
            for (const Change& change : part.target)
                if (change.time <= from) down = change.down;
            if (down || passes(index, from, to)) continue;
            const Span* span = span_at(part, middle);
            for (const Feature& f : features_[piece]) {
                if (&f == held) continue;
                const std::string what = "nothing comes earlier: gap to " + part.name + " is at least 0";
                everywhere(what.c_str(), from, to, [&](double a, double b) {
                    const I t = between(a, b);
                    const Lie wide = lie_of(f, part, span, motion_of(leg(), t).place, r, t);
                    if (wide.apart || low(wide.gap.c[0]) >= -bound_ * r) return 0.0;
                    const auto gap = [&](const I& at) {
                        return lie_of(f, part, span, motion_of(leg(), at).place, r, at).gap;
                    };
                    return std::max(0.0, -low(range(gap, a, b)) - bound_ * r);
                });
            }
        }
    }

    void check_clear_of(const Ball& other) {
        const double reach = ball_->radius + other.radius;
        const std::string what =
            "nothing comes earlier: gap to ball " + std::to_string(other.number) + " is at least 0";
        for (const Leg& theirs : other.legs) {
            const double from = std::max(leg().start, theirs.start), to = std::min(leg().end, theirs.end);
            if (!(from < to)) continue;
            const auto gap = [&](const I& t) {
                const Motion a = motion_of(leg(), t), b = motion_of(theirs, t);
                return length(a.place.x - b.place.x, a.place.y - b.place.y) - Jet(I(reach));
            };
            everywhere(what.c_str(), from, to, [&](double a, double b) {
                if (low(gap(between(a, b)).c[0]) >= -bound_ * reach) return 0.0;
                return std::max(0.0, -low(range(gap, a, b)) - bound_ * reach);
            });
        }
    }

    /// A ball that is lost is on the border of the table, or beyond.
    void check_gone() {
        leg_ = ball_->legs.size() - 1;
        const Motion m = motion_of(leg(), I(ball_->gone[0]));
        const double inside =
            std::min({low(m.place.x.c[0]) - run_.least[0], run_.most[0] - high(m.place.x.c[0]),
                      low(m.place.y.c[0]) - run_.least[1], run_.most[1] - high(m.place.y.c[0])});
        require("is at the border when it is lost", std::max(0.0, inside), ball_->radius, leg().end);
    }

    const Run& run_;
    double bound_;
    std::vector<std::vector<Feature>> features_;  ///< by piece
    const Ball* ball_ = nullptr;
    std::size_t leg_ = 0;
    double speed_ = 0, acceleration_ = 0;
    Verdict verdict_;
};

}  // namespace

Verdict check(const Run& run, double bound) {
    return Checker(run, bound).check();
}

}  // namespace certificate
