#include "check.hpp"

#include <cmath>
#include <cstdio>
#include <limits>

namespace certificate {

namespace {

constexpr double far = std::numeric_limits<double>::infinity();
constexpr int order = 10, gap_order = 3;  // of expansions; what is far off needs no high one
constexpr double gate_clearance = 1e-9;   // radii; how far off a gate lets go of a ball: the scenes' rules
/// So far, in radii, balls of a heap may be off what they press on, or in it.
constexpr double heap_gap = 2e-3, heap_overlap = 1e-2;

/// Whether the layers of two are in each other's masks.
bool meets(const auto& a, const auto& b) {
    return (a.layer & b.collides_with) != 0 && (b.layer & a.collides_with) != 0;
}
bool is(std::int64_t other, std::size_t number) {
    return other >= 0 && static_cast<std::size_t>(other) == number;
}
bool is_still(const Leg& leg) {
    return leg.velocity == Vec{} && leg.acceleration == Vec{} && leg.displacements.empty() && leg.held < 0;
}
/// How the part turns at a time; of two spans that meet there the earlier.
Span span_at(const Part& part, double time) {
    Span found = part.turns.empty() ? Span{0, 0, 0} : part.turns[0];
    for (const Span& span : part.turns)
        if (span.since < time) found = span;
    return found;
}

/// What a ball may touch: a feature of a part, or a ball on one of its paths, which is a round that moves.
struct Other {
    std::size_t material = 0;
    const Part* part = nullptr;
    const Feature* feature = nullptr;
    Span span{};
    const Ball* ball = nullptr;
    const Leg* leg = nullptr;
};

class Checker {
  public:
    Checker(const Run& run, double bound) : run_(run), bound_(bound) {
        for (const Primitive& primitive : run.primitives) features_.push_back(features_of(primitive, run));
    }
    Verdict check() {
        check_parts();
        for (const Ball& ball : run_.balls) {
            ++verdict_.balls;
            ball_ = &ball;
            for (leg_ = 0; leg_ < ball.legs.size(); ++leg_) {
                ++verdict_.legs;
                set_scales();
                check_beginning();
                check_motion();
                check_clear();
                for (const Passage& passage : run_.passages)
                    if (passage.ball == ball.number) check_passage(passage);
            }
            --leg_;
            if (!ball.gone.empty()) check_gone();
        }
        return verdict_;
    }

  private:
    // What all checks are made of.

    [[noreturn]] void reject(const std::string& what, double time, double by) const {
        char figures[96];
        std::snprintf(figures, sizeof figures, ", not so at %.12g s by %.3g", time, by);
        throw Rejected("ball " + std::to_string(ball_->number) + ", segment " + std::to_string(leg_) + ": " +
                       what + figures);
    }
    void require(const char* what, double value, double scale, double time) {
        if (!(value <= bound_ * scale)) reject(what, time, value);
        double& largest = verdict_.largest[what];
        largest = std::max(largest, value / (bound_ * scale));
    }
    void require_same(const char* what, const V& a, const V& b, double scale) {
        require(what, size(a - b), scale, leg().start);
    }
    /// `above(from, to)` is by how much a condition may be missed at most, ≤ 0 where it holds for certain: on
    /// ever smaller parts of an interval of time.
    void everywhere(const std::string& what, double from, double to, const auto& above) {
        constexpr std::size_t most = 1'000'000;  // a few hundred, in practice
        std::vector<std::pair<double, double>> open{{from, to}};
        const std::size_t last = verdict_.enclosures + most;
        while (!open.empty()) {
            const auto [a, b] = open.back();
            open.pop_back();
            ++verdict_.enclosures;
            const double by = above(a, b), middle = a + (b - a) / 2;
            if (by <= 0) continue;
            if (b - a < 1e-14 || !(middle > a && middle < b) || verdict_.enclosures > last)
                reject(what, a, by);
            open.emplace_back(middle, b);
            open.emplace_back(a, middle);
        }
    }
    /// A quantity stays zero, or at least that, over the whole segment.
    void stays(bool zero, const char* what, double scale, const auto& value) {
        everywhere(what, leg().start, leg().end, [&](double a, double b) {
            const I all = range(value, a, b, order);
            const double wrong = zero ? size(all) : -low(all);
            if (wrong <= bound_ * scale) require(what, wrong, scale, a);
            return wrong - bound_ * scale;
        });
    }
    void stays_zero(auto... condition) { stays(true, condition...); }
    void stays_above(auto... condition) { stays(false, condition...); }

    const Leg& leg() const { return ball_->legs[leg_]; }
    Jet start() const { return {I(leg().start), 2}; }
    double friction_with(const Other& other) const {
        return std::sqrt(run_.materials.at(ball_->material).friction *
                         run_.materials.at(other.material).friction);
    }
    Other feature_of(std::size_t primitive, const Feature& feature, double t) const {
        const Part& part = run_.parts.at(run_.primitives.at(primitive).part);
        return {part.material, &part, &feature, span_at(part, t)};
    }
    const Ball& ball_named(std::size_t number) const {
        const auto found = std::ranges::find(run_.balls, number, &Ball::number);
        if (found == run_.balls.end() || !meets(*ball_, *found))
            reject("the ball that it touches can be touched", leg().start, 0);
        return *found;
    }
    Lie lie(const Leg& mine, const Other& other, const Jet& t) const {
        const V place = motion_of(mine, t).place;
        if (other.ball == nullptr)
            return lie_of(*other.feature, other.part->pivot, other.span, place, ball_->radius, t);
        const Motion theirs = motion_of(*other.leg, t);
        Lie found = lie_of(round(theirs.place, other.ball->radius), {}, {}, place, ball_->radius, t);
        found.velocity = derivative(theirs.place);
        found.rim = other.ball->radius * theirs.spin;
        return found;
    }
    /// The feature of the primitive that the ball faces and touches best, with that normal if one is given;
    /// as its part moves just before `turns`.
    Other touched(const Leg& mine, std::size_t primitive, double t, double turns,
                  const Vec* normal = {}) const {
        Other best;
        double least = far;
        const Part& part = run_.parts.at(run_.primitives.at(primitive).part);
        if (part.sensor || !meets(*ball_, part)) reject("the part that it touches can be touched", t, 0);
        for (const Feature& feature : features_.at(primitive)) {
            const Other one = feature_of(primitive, feature, turns);
            const Lie at = lie(mine, one, t);
            double wrong = size(at.gap[0]) / ball_->radius;
            if (normal != nullptr) wrong += size(at.normal - vec(*normal));
            if (at.facing && wrong < least) least = wrong, best = one;
        }
        if (best.feature == nullptr) reject("the primitive that it touches faces it", t, 0);
        return best;
    }

    void set_scales() {
        const double g = std::hypot(run_.gravity[0], run_.gravity[1]), r = ball_->radius;
        const auto& [vx, vy] = leg().velocity_before;
        speed_ = std::sqrt(r * g) + std::hypot(vx, vy) + r * std::abs(leg().spin_before);
        for (const double time : {leg().start, leg().end}) {
            const Motion m = motion_of(leg(), Jet(I(time), 2));
            speed_ += std::hypot(size(m.place.x[1]), size(m.place.y[1])) + r * size(m.spin[0]);
        }
        acceleration_ = g + speed_ * speed_ / r;
    }

    /// A part's angle does not jump, and a target goes down by a hit only.
    void check_parts() const {
        const auto must = [](bool holds, const Part& part, const char* what, double t) {
            if (!holds)
                throw Rejected("part " + part.name + ": " + what + ", not so at " + std::to_string(t) + " s");
        };
        for (const Part& part : run_.parts) {
            for (std::size_t i = 1; i < part.turns.size(); ++i) {
                const Span &a = part.turns[i - 1], &b = part.turns[i];
                const double jump = std::abs(a.angle + a.rate * (b.since - a.since) - b.angle);
                must(jump <= bound_ * (1 + std::abs(b.angle)) && a.since <= b.since, part,
                     "its angle does not jump", b.since);
            }
            for (const Change& change : part.target) {
                bool hit = !change.down || change.time == 0;
                for (const Ball& ball : run_.balls)
                    for (const Leg& one : ball.legs)
                        hit |= one.why == "part" && one.start == change.time &&
                               &run_.parts.at(run_.primitives.at(one.met).part) == &part;
                must(hit, part, "goes down by a hit", change.time);
            }
        }
    }
    void check_gone() {
        const V at = motion_of(leg(), ball_->gone[0]).place;
        const double inside = std::min({low(at.x[0]) - run_.least[0], run_.most[0] - high(at.x[0]),
                                        low(at.y[0]) - run_.least[1], run_.most[1] - high(at.y[0])});
        require("is at the border when it is lost", inside, ball_->radius, leg().end);
    }

    // How a segment begins.

    void check_beginning() {
        const Leg& now = leg();
        const Motion is = motion_of(now, start());
        const bool first = leg_ == 0;
        const Leg& before = first ? now : ball_->legs[leg_ - 1];
        const Motion was = motion_of(before, start());
        V velocity = derivative(was.place);
        Jet spin = was.spin;
        require_same("position is continuous", was.place, is.place, ball_->radius);
        if (first || now.why == "given") return check_given(first ? vec({}) : velocity, derivative(is.place));
        if (now.why != "goes on") {
            require_same("velocity before as stated", velocity, vec(now.velocity_before), speed_);
            require_same("spin before as stated", {spin, 0.0}, {now.spin_before, 0.0},
                         speed_ / ball_->radius);
            hit(before, met_by(before), velocity, spin);
        }
        require_same("velocity follows the law", velocity, derivative(is.place), speed_);
        require_same("spin follows the law", {spin, 0.0}, {is.spin, 0.0}, speed_ / ball_->radius);
    }
    /// By the start, or by an input: a velocity is set, or added to that of all.
    void check_given(const V& was, const V& is) {
        ++verdict_.given;
        double wrong = leg().start == 0 && leg_ == 0 ? 0 : far;
        for (const Input& input : run_.inputs)
            if (input.time == leg().start && (input.ball < 0 || certificate::is(input.ball, ball_->number)))
                wrong = std::min(wrong, size(vec(input.velocity) + (input.ball < 0 ? was : vec({})) - is));
        require("velocity is that of an input", wrong, speed_, leg().start);
    }
    Other met_by(const Leg& before) const {
        const Leg& now = leg();
        if (now.why == "part") return touched(before, now.met, now.start, now.start, &now.normal);
        if (now.why != "ball") throw std::runtime_error("a segment begins by '" + now.why + "'");
        // Two balls may meet more than once at an instant: the n-th of the one is the n-th of the other.
        const Ball& other = ball_named(now.met);
        const auto is_meeting = [&](const Ball& ball, std::size_t i, std::size_t met) {
            return ball.legs[i].why == "ball" && ball.legs[i].met == met && ball.legs[i].start == now.start;
        };
        std::size_t n = 0, k = 1;
        for (std::size_t i = 1; i <= leg_; ++i) n += is_meeting(*ball_, i, now.met);
        for (; k < other.legs.size(); ++k)
            if (is_meeting(other, k, ball_->number) && --n == 0) break;
        if (k >= other.legs.size()) reject("the ball that it meets meets it", now.start, 0);
        return {other.material, {}, {}, {}, &other, &other.legs[k - 1]};
    }
    /// What the law makes of the velocity before: restitution and kick, unless the approach is slower than
    /// the rest speed (so near to it that either may be, what was done decides); friction by Coulomb, at most
    /// as much as stops the slip. A disc resists a push at its rim with a third of its mass.
    void hit(const Leg& before, const Other& other, V& velocity, Jet& spin) {
        const Leg& now = leg();
        const double r = ball_->radius;
        const Lie at = lie(before, other, start());
        const V relative = velocity - at.velocity;
        const V after = other.ball != nullptr ? vec((other.leg + 1)->velocity) : at.velocity;
        const I closing = -dot(relative, at.normal)[0],
                slip = (cross(at.normal, relative) - r * spin - at.rim)[0];
        require_same("normal as stated", at.normal, vec(now.normal), 1);
        check_touch(before, other, closing);

        const Material &own = run_.materials.at(ball_->material), &theirs = run_.materials.at(other.material);
        const double near = bound_ * speed_, over = low(closing) - run_.rest_speed;
        const I parting = dot(vec(now.velocity) - after, at.normal)[0];
        const bool rests = over < -near || (over <= near && high(parting) <= 2 * near);
        const I back = own.restitution * theirs.restitution * closing, kick(std::max(own.kick, theirs.kick));
        const I along = closing + (rests ? I(0) : low(back) >= low(kick) ? back : kick);
        const I most = friction_with(other) * along, stop = -slip / 3;
        const I across = low(stop) > high(most) ? most : high(stop) < low(-most) ? I(-most) : stop;
        const Jet share =
            other.ball != nullptr ? I(other.ball->mass) / (I(ball_->mass) + other.ball->mass) : I(1);
        velocity = velocity + share * (along * at.normal + across * perp(at.normal));
        spin = spin - share * across * 2.0 / r;
    }
    /// The gap is zero, changes its sign within the interval stated, and falls all over it. Without an
    /// interval it is a touch without approach, which changes nothing, or a graze.
    void check_touch(const Leg& before, const Other& other, const I& closing) {
        const double t = leg().start, from = t - leg().within, to = t + leg().within;
        const auto gap = [&](const Jet& time) { return lie(before, other, time).gap; };
        require("gap at an impact is 0", size(gap(t)[0]), ball_->radius, t);
        if (leg().within < 0) {
            ++(size(closing) <= bound_ * speed_ ? verdict_.touches : verdict_.not_isolated);
            return;
        }
        ++verdict_.impacts;
        if (!(low(gap(from)[0]) > 0))
            reject("gap before the isolating interval is above 0", from, leg().within);
        if (!(high(gap(to)[0]) < 0)) reject("gap after the isolating interval is below 0", to, leg().within);
        const I slope = range([&](const Jet& time) { return gap(time).derivative(); }, from, to, order);
        if (!(high(slope) < 0)) reject("gap falls all over the isolating interval", from, high(slope));
    }

    // How a ball moves.

    /// Acceleration that is neither gravity nor drag: what a surface does.
    V force_at(const Jet& t) const {
        const V v = derivative(motion_of(leg(), t).place);
        return derivative(v) - vec(run_.gravity) + run_.damping * v;
    }
    Jet spinning_up(const Jet& t) const { return ball_->radius / 2 * motion_of(leg(), t).spin.derivative(); }
    void check_motion() {
        if (const Rest* rest = rest_of(leg())) return check_rest(*rest);
        if (leg().held >= 0) return check_contact(static_cast<std::size_t>(leg().held));
        const char* flies = "flies by the equation of motion";
        stays_zero(flies, acceleration_, [this](const Jet& t) { return force_at(t).x; });
        stays_zero(flies, acceleration_, [this](const Jet& t) { return force_at(t).y; });
        stays_zero("spin stays in flight", acceleration_, [this](const Jet& t) { return spinning_up(t); });
    }
    /// Slides, with friction against the slip, or rolls within Coulomb's cone; the surface only pushes.
    void check_contact(std::size_t primitive) {
        ++verdict_.held;
        const double from = leg().start, to = leg().end, scale = acceleration_;
        const Other on = touched(leg(), primitive, from + (to - from) / 2, std::nextafter(from, far));
        const double mu = friction_with(on);
        const auto at = [&](const Jet& t) { return lie(leg(), on, t); };
        const auto push = [&](const Jet& t) { return dot(force_at(t), at(t).normal); };
        const auto rub = [&](const Jet& t) { return cross(at(t).normal, force_at(t)); };
        const auto slip = [&](const Jet& t) {
            const Motion m = motion_of(leg(), t);
            const Lie touch = at(t);
            return cross(touch.normal, derivative(m.place) - touch.velocity) - ball_->radius * m.spin;
        };
        stays_zero("stays in contact", ball_->radius, [&](const Jet& t) { return at(t).gap; });
        stays_above("contact force is at least 0", scale, push);
        stays_zero("spin changes by friction", scale, [&](const Jet& t) { return spinning_up(t) + rub(t); });
        const I begins = slip({I(from), 2})[0], ends = slip({I(to), 2})[0];
        const double sign = low(begins) + low(ends) > 0 ? 1 : -1;
        const auto spare = [&](double s) {
            return [&, s](const Jet& t) { return mu * push(t) + s * rub(t); };
        };
        if (mu > 0 && std::max(size(begins), size(ends)) <= bound_ * speed_) {
            stays_zero("rolls without slip", speed_, slip);
            for (const double s : {1.0, -1.0}) stays_above("friction within Coulomb's cone", scale, spare(s));
            return;
        }
        if (mu > 0) stays_above("slips one way", speed_, [&](const Jet& t) { return sign * slip(t); });
        stays_zero("friction against the slip", scale, spare(sign));
    }
    /// The one rest that names the ball at the time of the segment.
    const Rest* rest_of(const Leg& at) const {
        const Rest* found = nullptr;
        for (const Rest& rest : run_.rests) {
            const bool overlaps = rest.from < at.end && at.start < rest.until;
            const bool covers = is_still(at) && rest.from <= at.start && at.end <= rest.until;
            const bool names = std::ranges::any_of(rest.forces, [this](const Force& force) {
                return force.ball == ball_->number || is(force.other, ball_->number);
            });
            if (!names || !(overlaps || covers)) continue;
            if (found != nullptr && overlaps) reject("rests by one set of forces", at.start, 0);
            if (found == nullptr) found = &rest;
        }
        return found;
    }
    static bool is_heap(const Rest& rest) {
        return std::ranges::any_of(rest.forces, [](const Force& force) { return force.other >= 0; });
    }
    /// Rests, though it may spin: the forces that are stated push, stay within Coulomb's cone (where it spins
    /// they are on its edge, against the slip), act where it touches what is at rest, and balance its weight.
    void check_rest(const Rest& rest) {
        ++verdict_.resting;
        const Leg& now = leg();
        const double t = now.start, r = ball_->radius, m = ball_->mass, scale = m * acceleration_;
        const double sense = (now.spin > 0) - (now.spin < 0), slows = now.spins.empty() ? 0 : now.spins[0];
        if (!is_still(now) || now.spins.size() > 1 || !(rest.from <= t && now.end <= rest.until))
            reject("rests as long as forces hold it", t, 0);
        V left = m * vec(run_.gravity);
        Jet rub = 0.0;
        for (const Force& one : rest.forces) {
            const bool reacts = is(one.other, ball_->number);
            if (one.ball != ball_->number && !reacts) continue;
            const Other on = rests_on(one, reacts);
            const Lie at = lie(now, on, t);
            if (on.part != nullptr && !stands_still(*on.part, on.span))
                reject("rests on what stands still", t, 0);
            const I most = friction_with(on) * I(one.normal);
            const auto [apart, deep] =
                is_heap(rest) ? std::pair(heap_gap, heap_overlap) : std::pair(bound_, bound_);
            if (!(low(at.gap[0]) >= -deep * r && high(at.gap[0]) <= apart * r))
                reject("touches what it rests on", t, size(at.gap[0]));
            verdict_.loosest = std::max(verdict_.loosest, size(at.gap[0]) / r);
            require("contact force is at least 0", -one.normal, scale, t);
            require("friction within Coulomb's cone", high(std::abs(one.friction) - most), scale, t);
            if (sense != 0) require("friction against the slip", size(one.friction - sense * most), scale, t);
            left = left + one.normal * at.normal + one.friction * perp(at.normal);
            rub = rub + one.friction;
        }
        require("forces balance its weight", size(left), scale, t);
        require("spin changes by friction", size(m * r / 2 * I(slows) + rub[0]), scale, t);
        require("spin keeps its sense", -sense * (now.spin + (now.end - t) * slows) * r, speed_, now.end);
    }
    /// Throughout the segment.
    bool stands_still(const Part& part, const Span& first) const {
        return first.rate == 0 && std::ranges::none_of(part.turns, [this](const Span& span) {
                   return span.rate != 0 && span.since > leg().start && span.since < leg().end;
               });
    }
    Other rests_on(const Force& force, bool reacts) const {
        if (force.other < 0)
            return touched(leg(), force.primitive, leg().start, std::nextafter(leg().start, far));
        const Ball& ball = ball_named(reacts ? force.ball : static_cast<std::size_t>(force.other));
        std::size_t last = 0;
        while (last + 1 < ball.legs.size() && ball.legs[last + 1].start <= leg().start) ++last;
        return {ball.material, {}, {}, {}, &ball, &ball.legs[last]};
    }

    // Nothing came earlier.

    /// The ball is not nearer than touching to anything, but for the overlap that a heap may have.
    void check_clear() {
        const Rest* rest = rest_of(leg());
        const auto slack = [&](double radius, const auto& rests_on) {
            const bool heap =
                rest != nullptr && is_heap(*rest) && std::ranges::any_of(rest->forces, rests_on);
            return heap ? heap_overlap * radius : bound_ * ball_->radius;
        };
        for (std::size_t primitive = 0; primitive < run_.primitives.size(); ++primitive)
            if (const Part& part = run_.parts.at(run_.primitives[primitive].part);
                !part.sensor && meets(*ball_, part))
                check_clear_of(primitive, slack(ball_->radius, [&](const Force& force) {
                                   return force.other < 0 && force.primitive == primitive &&
                                          force.ball == ball_->number;
                               }));
        for (const Ball& other : run_.balls) {
            if (other.number <= ball_->number || !meets(*ball_, other)) continue;
            const double deep = slack(std::min(ball_->radius, other.radius), [&](const Force& force) {
                return (force.ball == other.number && is(force.other, ball_->number)) ||
                       (force.ball == ball_->number && is(force.other, other.number));
            });
            for (const Leg& theirs : other.legs)
                stays_clear({other.material, {}, {}, {}, &other, &theirs},
                            "ball " + std::to_string(other.number), std::max(leg().start, theirs.start),
                            std::min(leg().end, theirs.end), deep, gap_order);
        }
    }
    void check_clear_of(std::size_t primitive, double slack) {
        const std::size_t index = run_.primitives[primitive].part;
        const Part& part = run_.parts[index];
        std::vector<double> times{leg().start, leg().end};  // at which something about the part changes
        for (const Span& span : part.turns) times.push_back(span.since);
        for (const Change& change : part.target) times.push_back(change.time);
        for (const Passage& passage : run_.passages)
            times.push_back(passage.from), times.push_back(passage.until);
        for (double& time : times) time = std::clamp(time, leg().start, leg().end);
        std::ranges::sort(times);
        for (std::size_t i = 0; i + 1 < times.size(); ++i) {
            const double from = times[i], to = times[i + 1];
            bool absent = false;
            for (const Change& change : part.target)
                if (change.time <= from) absent = change.down;
            for (const Passage& p : run_.passages)
                absent |= p.ball == ball_->number && p.gate == index && p.from <= from && to <= p.until;
            for (const Feature& feature : features_[primitive])
                if (!absent)
                    stays_clear(feature_of(primitive, feature, from + (to - from) / 2), part.name, from, to,
                                slack, is(leg().held, primitive) ? order : gap_order);
        }
    }
    void stays_clear(const Other& other, const std::string& name, double from, double to, double slack,
                     int terms) {
        if (!(from < to)) return;
        everywhere(
            "nothing comes earlier: gap to " + name + " is at least 0", from, to, [&](double a, double b) {
                const Lie all = lie(leg(), other, Jet(between(a, b), 0));
                if (all.apart || low(all.gap[0]) >= -slack) return 0.0;
                return -low(range([&](const Jet& t) { return lie(leg(), other, t).gap; }, a, b, terms)) -
                       slack;
            });
    }
    /// A ball passes a gate that it came to from behind, or that was open; and only as long as it is at the
    /// gate.
    void check_passage(const Passage& passage) {
        const Leg& now = leg();
        const Part& gate = run_.parts.at(passage.gate);
        const double from = std::max(now.start, passage.from), to = std::min(now.end, passage.until);
        const auto any_feature = [&](const auto& holds) {
            bool any = false;
            for (std::size_t primitive = 0; primitive < features_.size(); ++primitive)
                for (const Feature& feature : features_[primitive])
                    any |= run_.primitives[primitive].part == passage.gate &&
                           holds(feature_of(primitive, feature, from));
            return any;
        };
        if (passage.from > 0 && now.start <= passage.from && passage.from < now.end) {
            bool may = any_feature([&](const Other& one) {
                return one.feature->is_line &&
                       low(dot(lie(now, one, passage.from).normal, vec(gate.gate))[0]) < 0;
            });
            for (const Passage& other : run_.passages)
                may |= &other != &passage && other.gate == passage.gate && other.from <= passage.from &&
                       passage.from <= other.until;
            if (!may) reject("passes " + gate.name + " from behind", passage.from, 0);
        }
        if (!(from < to)) return;
        everywhere("is at " + gate.name + " as long as it passes", from, to, [&](double a, double b) {
            const bool near = any_feature([&](const Other& one) {
                const auto gap = [&](const Jet& t) { return lie(now, one, t).gap; };
                return lie(now, one, between(a, b)).facing &&
                       high(range(gap, a, b, gap_order)) <= (gate_clearance + bound_) * ball_->radius;
            });
            return near ? 0.0 : 1.0;
        });
    }

    const Run& run_;
    double bound_;
    std::vector<std::vector<Feature>> features_;  ///< by primitive
    const Ball* ball_ = nullptr;
    std::size_t leg_ = 0;
    double speed_ = 0, acceleration_ = 0;  ///< scales of the segment
    Verdict verdict_;
};

}  // namespace

Verdict check(Run& run, double bound) {
    if (run.format != "flipside-certificate/2") throw std::runtime_error("it is no flipside-certificate/2");
    for (Ball& ball : run.balls) {
        if (!(ball.radius > 0 && ball.mass > 0 && !ball.legs.empty()))
            throw std::runtime_error("a ball has no size, mass or segment");
        for (std::size_t i = 0; i < ball.legs.size(); ++i) {
            Leg& leg = ball.legs[i];
            const double last = ball.gone.empty() ? run.seconds : ball.gone[0];
            leg.end = i + 1 < ball.legs.size() ? ball.legs[i + 1].start : last;
            if (!(leg.start <= leg.end)) throw std::runtime_error("a segment ends before it starts");
        }
    }
    return Checker(run, bound).check();
}

}  // namespace certificate
