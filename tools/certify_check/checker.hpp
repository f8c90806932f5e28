#pragma once
/// What has to hold of a run, segment by segment: how it begins, how it moves, and that nothing came earlier.

#include <cstdio>

#include "surface.hpp"

namespace certificate {

constexpr std::size_t terms = 11, few_terms = 4;        // of expansions; what is far off needs few
constexpr double gate_clearance = 1e-9;                 // radii; how far off a gate lets go of a ball
constexpr double heap_gap = 2e-3, heap_overlap = 1e-2;  // radii; how far balls of a heap may be off

/// `bound` is relative: lengths to the ball's radius r, speeds to √(r|g|) + |v| + r|spin|, accelerations to
/// |g| + that speed squared over r.
class Checker {
  public:
    Checker(const Run& run, double bound) : run_(run), bound_(bound), others_(others_of(run)) {}
    Verdict check() {
        for (const Ball& ball : run_.balls)
            for (index_ = 0, ball_ = &ball; index_ < ball.legs.size(); ++index_) check_segment();
        check_parts();
        return verdict_;
    }

  private:
    // What is given: a part's angle does not jump, a target goes down by a hit only.

    void check_parts() const {
        for (const Part& part : run_.parts)
            for (std::size_t i = 1; i < part.turns.size(); ++i) {
                const Span &a = part.turns[i - 1], &b = part.turns[i];
                const double jump = std::abs(a.angle + a.rate * (b.since - a.since) - b.angle);
                if (!(jump <= bound_ * (1 + std::abs(b.angle)) && a.since <= b.since))
                    throw Rejected("part " + part.name + ": its angle does not jump");
            }
        for (const Absence& absence : run_.absences) {
            bool hit = absence.ball >= 0 || absence.from == 0;
            for (const Ball& ball : run_.balls)
                for (const Leg& one : ball.legs)
                    hit |= one.why == "part" && one.start == absence.from &&
                           run_.features.at(one.met).part == absence.part;
            if (!hit) throw Rejected("part " + run_.parts.at(absence.part).name + ": goes down by a hit");
        }
    }

    // What all checks are made of.

    [[noreturn]] void reject(const std::string& what, double time, double by = 0) const {
        char figures[96];
        std::snprintf(figures, sizeof figures, ", not so at %.12g s by %.3g", time, by);
        throw Rejected("ball " + std::to_string(ball_->number) + ", segment " + std::to_string(index_) +
                       ": " + what + figures);
    }
    void require(const char* what, double value, double most) const {
        if (!(value <= most)) reject(what, leg().start, value);
    }
    /// Halves an interval until `missed` is 0 in each part of it: by how much a condition may fail there.
    void everywhere(const std::string& what, double a, double b, const auto& missed) {
        constexpr std::size_t most = 1'000'000;  // for each segment; a few hundred, in practice
        const double by = missed(a, b), middle = std::midpoint(a, b);
        if (by == 0) return;
        if (b - a < 1e-14 || !(a < middle && middle < b) || ++verdict_.enclosures > most * verdict_.legs)
            reject(what, a, by);
        everywhere(what, a, middle, missed);
        everywhere(what, middle, b, missed);
    }
    /// A quantity stays from `least` to `most` over the whole segment.
    void stays(const char* what, double least, double most, const auto& value) {
        everywhere(what, leg().start, leg().end, [&](double a, double b) {
            const I all = range(value, a, b, terms);
            return low(all) >= least && high(all) <= most ? 0 : size_of(all);
        });
    }
    void stays_zero(const char* what, double scale, const auto& value) {
        stays(what, -bound_ * scale, bound_ * scale, value);
    }
    void stays_above(const char* what, double scale, const auto& value) {
        stays(what, -bound_ * scale, HUGE_VAL, value);
    }

    const Leg& leg() const { return ball_->legs[index_]; }
    const Leg& before() const { return ball_->legs[index_ > 0 ? index_ - 1 : 0]; }
    Lie lie(const Leg& mine, const Other& other, const Jet& t) const {
        return {other, Motion(mine, t).place, ball_->radius, t};
    }
    /// Of this ball and another thing.
    Material mixed(const Other& other) const {
        const Material &a = run_.materials.at(ball_->material),
                       &b = run_.materials.at(other.ball != nullptr ? other.ball->material
                                                                    : other.part->material);
        return {a.restitution * b.restitution, std::sqrt(a.friction * b.friction), std::max(a.kick, b.kick)};
    }
    bool is_absent(const Other& other, int ball) const {
        return std::ranges::any_of(run_.absences, [&](const Absence& one) {
            return other.part == &run_.parts.at(one.part) && (one.ball < 0 || one.ball == ball) &&
                   one.from <= other.from && other.until <= one.until;
        });
    }
    /// What it touches on one of its segments, at a time: as it is just after that, or just before.
    const Other& touched(const Leg& mine, double time, bool after, const auto& is_it) const {
        const Other* found = nullptr;
        for (const Other& one : others_)
            if (is_it(one) && (found == nullptr || one.from < time || (after && one.from == time)))
                found = &one;
        if (found == nullptr || !can_touch(*ball_, *found)) reject("what it touches can be touched", time);
        if (!lie(mine, *found, {I(time), 2}).facing) reject("what it touches faces it", time);
        return *found;
    }
    const Other& touched_feature(std::size_t index, const Leg& mine, double time, bool after) const {
        const Feature* feature = &run_.features.at(index);
        return touched(mine, time, after, [&](const Other& one) { return one.feature == feature; });
    }

    void check_segment() {
        const double r = ball_->radius, g = size(vec(run_.gravity));
        ++verdict_.legs;
        speed_ = std::sqrt(r * g);
        for (const auto& [one, time] :
             {std::pair{&before(), leg().start}, {&leg(), leg().start}, {&leg(), leg().end}}) {
            const Motion motion(*one, {I(time), 2});
            speed_ += size(motion.velocity) + r * size_of(motion.spin[0]);
        }
        acceleration_ = g + speed_ * speed_ / r;
        check_beginning();
        find_contacts();
        if (leg().start < leg().end) check_motion(), check_clear();
        for (const Absence& one : run_.absences)
            if (one.ball == ball_->number) check_passage(one);
        if (ball_->gone.empty() || index_ + 1 < ball_->legs.size()) return;
        const V at = Motion(leg(), I(leg().end)).place;
        const double inside = std::min({low(at.x[0]) - run_.least[0], run_.most[0] - high(at.x[0]),
                                        low(at.y[0]) - run_.least[1], run_.most[1] - high(at.y[0])});
        require("is at the border when it is lost", inside, bound_ * r);
    }

    // How a segment begins.

    void check_beginning() {
        const Jet start(I(leg().start), 3);
        const Motion is(leg(), start), was(before(), start);
        V velocity = was.velocity;
        Jet spin = was.spin;
        if (leg().why != "given" || !is_moved_by_target(run_, others_, *ball_, before(), leg(), bound_))
            require("position is continuous", size(was.place - is.place), bound_ * ball_->radius);
        if (index_ == 0 || leg().why == "given") return check_given(was.velocity, is.velocity);
        if (leg().why != "goes on") hit(velocity, spin);
        require("velocity follows the law", size(velocity - is.velocity), bound_ * speed_);
        require("spin follows the law", ball_->radius * size_of((spin - is.spin)[0]), bound_ * speed_);
    }
    /// By the start, or by an input: a velocity is set, or added to that of all.
    void check_given(const V& was, const V& is) {
        ++verdict_.given;
        double wrong = leg().start == 0 && index_ == 0 ? 0 : HUGE_VAL;
        for (const Input& input : run_.inputs)
            if (input.time == leg().start && (input.ball < 0 || input.ball == ball_->number))
                wrong = std::min(wrong, size(vec(input.velocity) + (input.ball < 0 ? was : V{}) - is));
        require("velocity is that of an input", wrong, bound_ * speed_);
    }
    const Other& met() const {
        if (leg().why == "part") return touched_feature(leg().met, before(), leg().start, false);
        return touched(before(), leg().end, true, [this](const Other& one) {
            const std::size_t i = leg().met_leg;
            if (one.ball == nullptr || i == 0 || i >= one.ball->legs.size() ||
                one.leg != &one.ball->legs[i - 1])
                return false;
            const Leg& next = one.ball->legs[i];
            return one.ball->number == static_cast<int>(leg().met) && next.why == "ball" &&
                   next.met_leg == index_ && static_cast<int>(next.met) == ball_->number &&
                   next.start == leg().start;
        });
    }
    /// What the law makes of the velocity before: restitution and kick, unless the approach is slower than
    /// the rest speed (so near to it that either may be, what was done decides); friction by Coulomb, at most
    /// as much as stops the slip. A disc resists a push at its rim with a third of its mass.
    void hit(V& velocity, Jet& spin) {
        const double r = ball_->radius, near = bound_ * speed_;
        require("velocity before as stated", size(velocity - vec(leg().velocity_before)), near);
        require("spin before as stated", r * size_of((spin - leg().spin_before)[0]), near);
        const Other& other = met();
        const Lie at = lie(before(), other, {I(leg().start), 3});
        const V relative = velocity - at.velocity;
        const I closing = -dot(relative, at.normal)[0];
        const I slip = (cross(at.normal, relative) - r * spin - at.rim)[0];
        require("normal as stated", size(at.normal - vec(leg().normal)), bound_);
        check_touch(other, closing);

        const Material material = mixed(other);
        const V after = other.ball != nullptr ? vec((other.leg + 1)->velocity) : at.velocity;
        const double over = low(closing) - run_.rest_speed;
        const double parting = high(dot(vec(leg().velocity) - after, at.normal)[0]);
        const bool rests = over < -near || (over <= near && parting <= 2 * near);
        const I back = material.restitution * closing;
        const I along = closing + (rests ? I(0) : low(back) >= material.kick ? back : I(material.kick));
        const I most = material.friction * along, stop = -slip / 3;
        const I across = low(stop) > high(most) ? most : high(stop) < low(-most) ? I(-most) : stop;
        const Jet share =
            other.ball == nullptr ? I(1) : I(other.ball->mass) / (I(ball_->mass) + other.ball->mass);
        velocity = velocity + share * (along * at.normal + across * perp(at.normal));
        spin = spin - share * across * 2.0 / r;
    }
    /// The gap is zero, changes its sign within the interval stated, and falls all over it. Without an
    /// interval it is a touch without approach, which changes nothing, or a graze.
    void check_touch(const Other& other, const I& closing) {
        const double t = leg().start, from = t - leg().within, to = t + leg().within;
        const auto gap = [&](const Jet& time) { return lie(before(), other, time).gap; };
        require("gap at an impact is 0", size_of(gap({I(t), 3})[0]), bound_ * ball_->radius);
        if (leg().within < 0)
            return void(++(size_of(closing) <= bound_ * speed_ ? verdict_.touches : verdict_.not_isolated));
        ++verdict_.impacts;
        const I slope = range([&](const Jet& time) { return derivative(gap(time)); }, from, to, terms);
        if (!(low(gap({I(from), 3})[0]) > 0 && high(gap({I(to), 3})[0]) < 0 && high(slope) < 0))
            reject("gap falls from above 0 to below it in the isolating interval", t, leg().within);
    }

    // How a ball moves.

    void find_contacts() {
        const double start = leg().start, end = leg().end;
        const auto on = [&](std::size_t feature) -> const Other& {
            return touched_feature(feature, leg(), start, true);
        };
        contacts_.clear();
        for (const Rest& rest : run_.rests) {
            const bool heap =
                std::ranges::any_of(rest.forces, [](const Force& one) { return one.other >= 0; });
            for (const Force& one : rest.forces) {
                if ((one.ball != ball_->number && one.other != ball_->number) || end <= rest.from ||
                    rest.until <= start)
                    continue;
                require("rests as long as forces hold it", std::max(rest.from - start, end - rest.until), 0);
                const int other = one.ball == ball_->number ? one.other : one.ball;
                const auto is_it = [&](const Other& ball) {
                    return ball.ball != nullptr && ball.ball->number == other;
                };
                contacts_.push_back({other < 0 ? on(one.feature) : touched(leg(), start, true, is_it), &one,
                                     heap ? heap_gap : bound_, heap ? heap_overlap : bound_});
            }
        }
        verdict_.resting += !contacts_.empty();
        verdict_.held += leg().held >= 0;
        if (leg().held >= 0)
            contacts_.push_back({on(static_cast<std::size_t>(leg().held)), nullptr, bound_, bound_});
        for (const Contact& one : contacts_)
            for (const Other& span : others_)
                if (span.part != nullptr && span.feature == one.on.feature && span.from < end &&
                    start < span.until &&
                    (span.turn.rate != one.on.turn.rate || is_absent(span, ball_->number)))
                    reject("nothing changes about what it rests on", span.from);
    }
    /// What is neither gravity nor drag are the forces of contacts, which only push: friction is against the
    /// slip, or within Coulomb's cone where there is none. A heap may be in equilibrium in more than one way.
    void check_motion() {
        const auto force = [&](const Jet& t) {
            const V v = Motion(leg(), t).velocity;
            return derivative(v) - vec(run_.gravity) + run_.damping * v;
        };
        const auto push = [&](const Contact& one, const Jet& t) {
            return one.force ? one.force->normal / I(ball_->mass)
                             : dot(force(t), lie(leg(), one.on, t).normal);
        };
        const auto rub = [&](const Contact& one, const Jet& t) {
            return one.force ? one.force->friction / I(ball_->mass)
                             : cross(lie(leg(), one.on, t).normal, force(t));
        };
        const auto unexplained = [&](const Jet& t) {
            V sum = force(t);
            for (const Contact& one : contacts_) {
                const V normal = lie(leg(), one.on, t).normal;
                sum = sum - push(one, t) * normal - rub(one, t) * perp(normal);
            }
            return sum;
        };
        const auto torque = [&](const Jet& t) {
            Jet sum = ball_->radius / 2 * derivative(Motion(leg(), t).spin);
            for (const Contact& one : contacts_) sum = sum + rub(one, t);
            return sum;
        };
        for (const Contact& one : contacts_)
            check_contact(
                one, [&](const Jet& t) { return push(one, t); }, [&](const Jet& t) { return rub(one, t); });
        stays_zero("spin changes by friction", acceleration_, torque);
        if (contacts_.size() == 1 && contacts_[0].force == nullptr) return;  // it explains any
        const char* law = contacts_.empty() ? "flies by the equation of motion" : "forces balance its weight";
        for (const auto axis : {&V::x, &V::y})
            stays_zero(law, acceleration_, [&](const Jet& t) { return unexplained(t).*axis; });
    }
    void check_contact(const Contact& contact, const auto& push, const auto& rub) {
        const double r = ball_->radius, mu = mixed(contact.on).friction;
        const auto at = [&](const Jet& t) { return lie(leg(), contact.on, t); };
        const auto slip = [&](const Jet& t) {
            const Motion motion(leg(), t);
            const Lie touch = at(t);
            return cross(touch.normal, motion.velocity - touch.velocity) - r * motion.spin - touch.rim;
        };
        verdict_.loosest = std::max(verdict_.loosest, size_of(at(I(leg().start)).gap[0]) / r);
        everywhere("what it touches faces it", leg().start, leg().end, [&](double a, double b) {
            return at({I(a, b), 1}).facing ? 0.0 : 1.0;
        });
        stays_zero("stays in contact", speed_, [&](const Jet& t) { return derivative(at(t).gap); });
        stays("touches what it rests on", -contact.overlap * r, contact.gap * r,
              [&](const Jet& t) { return at(t).gap; });
        stays_above("contact force is at least 0", acceleration_, push);
        const I begins = slip({I(leg().start), 2})[0], ends = slip({I(leg().end), 2})[0];
        const bool slips = mu > 0 && std::max(size_of(begins), size_of(ends)) > bound_ * speed_;
        const double sign = low(begins) + low(ends) > 0 ? 1 : -1;
        const auto spare = [&](double s) {
            return [&, s](const Jet& t) { return mu * push(t) + s * rub(t); };
        };
        if (slips) {
            stays_above("slips one way", speed_, [&](const Jet& t) { return sign * slip(t); });
            stays_zero("friction against the slip", acceleration_, spare(sign));
        } else {
            if (mu > 0) stays_zero("rolls without slip", speed_, slip);
            for (const double s : {1.0, -1.0})
                stays_above("friction within Coulomb's cone", acceleration_, spare(s));
        }
    }

    // Nothing came earlier.

    /// The ball is not nearer than touching to anything, but for the overlap that a heap may have.
    void check_clear() {
        for (const Other& other : others_) {
            const double from = std::max(leg().start, other.from), to = std::min(leg().end, other.until);
            if (from >= to || !can_touch(*ball_, other) || is_absent(other, ball_->number) ||
                (other.ball != nullptr && other.ball->number <= ball_->number))
                continue;
            double slack = bound_;
            for (const Contact& one : contacts_)
                if (one.on.part == other.part && one.on.ball == other.ball)
                    slack = std::max(slack, one.overlap);
            slack *= ball_->radius;
            const std::size_t order = contacts_.empty() ? few_terms : terms;
            const std::string name =
                other.part ? other.part->name : "ball " + std::to_string(other.ball->number);
            everywhere("nothing comes earlier: gap to " + name + " is at least 0", from, to,
                       [&](double a, double b) {
                           const Lie all = lie(leg(), other, {I(a, b), 1});
                           if (all.apart || low(all.gap[0]) >= -slack) return 0.0;
                           const auto gap = [&](const Jet& t) { return lie(leg(), other, t).gap; };
                           const double least = low(range(gap, a, b, order));
                           return least >= -slack ? 0 : -least;
                       });
        }
    }
    /// A ball passes a gate that it came to from behind, or that was open; and only as long as it is there.
    void check_passage(const Absence& passage) {
        const double from = std::max(leg().start, passage.from), to = std::min(leg().end, passage.until);
        const Part& gate = run_.parts.at(passage.part);
        const auto any = [&](double a, double b, const auto& holds) {
            return std::ranges::any_of(others_, [&](const Other& one) {
                return one.part == &gate && one.from <= a && b <= one.until && holds(one);
            });
        };
        const auto comes_from_behind = [&](const Leg& at) {
            return at.start <= from && from <= at.end && any(from, from, [&](const Other& one) {
                       return is_behind(one, Motion(at, I(from)).place, I(from));
                   });
        };
        const auto opens = [&](const Absence& one) {
            if (one.part != passage.part || one.from > from || one.until < from) return false;
            return one.from < from || std::ranges::any_of(run_.balls, [&](const Ball& ball) {
                       return ball.number == one.ball && std::ranges::any_of(ball.legs, comes_from_behind);
                   });
        };
        if (from > 0 && from == passage.from && from < leg().end &&
            std::ranges::none_of(run_.absences, opens))
            reject("passes " + gate.name + " from behind", from);
        const auto is_near = [&](const Other& one, double a, double b) {
            const auto gap = [&](const Jet& t) { return lie(leg(), one, t).gap; };
            return lie(leg(), one, {I(a, b), 1}).facing &&
                   high(range(gap, a, b, few_terms)) <= (gate_clearance + bound_) * ball_->radius;
        };
        for (const Other& span : others_) {  // one ends whenever any ball begins or ends to pass the gate
            const double since = std::max(from, span.from), until = std::min(to, span.until);
            if (span.part != &gate || since >= until) continue;
            everywhere("is at " + gate.name + " as long as it passes", since, until, [&](double a, double b) {
                return any(a, b, [&](const Other& one) { return is_near(one, a, b); }) ? 0.0 : 1.0;
            });
        }
    }

    const Run& run_;
    const double bound_;
    const std::vector<Other> others_;
    const Ball* ball_ = nullptr;
    std::size_t index_ = 0;                // of the segment
    double speed_ = 0, acceleration_ = 0;  // scales of the segment
    std::vector<Contact> contacts_;        // of the segment
    Verdict verdict_{};
};

}  // namespace certificate
