#include "check.hpp"

#include <cmath>
#include <cstdio>
#include <limits>

namespace certificate {

namespace {

constexpr double far = std::numeric_limits<double>::infinity();
constexpr int order = 10, gap_order = 3;  ///< of expansions; what is far off needs no high one
constexpr double gate_clearance = 1e-9;   ///< radii; how far off a gate lets go of a ball: the scenes' rules
constexpr double rest_gap = 1e-4;      ///< radii; balls that press on each other at rest may be so far apart,
constexpr double rest_overlap = 1e-2;  ///< or so deep in each other

/// Whether the layers of two are in each other's masks.
bool meets(const auto& a, const auto& b) {
    return (a.layer & b.collides_with) != 0 && (b.layer & a.collides_with) != 0;
}
bool is_still(const Leg& leg) {
    return leg.velocity == Vec{} && leg.acceleration == Vec{} && leg.displacements.empty() && leg.held < 0;
}
V velocity_of(const Motion& m) {
    return derivative(m.place);
}

class Checker {
  public:
    Checker(const Run& run, double bound) : run_(run), bound_(bound) {
        for (const Primitive& primitive : run.primitives) features_.push_back(features_of(primitive, run));
    }
    Verdict check();

  private:
    /// Of a ball to what it meets.
    struct Meeting {
        Jet gap;
        V normal, velocity;
        Jet rim = 0.0;  ///< the speed at which a ball that it meets turns its surface
    };

    [[noreturn]] void reject(const std::string& what, double time, double by) const;
    void require(const char* what, double value, double scale, double time);
    void require_same(const char* what, const V& a, const V& b, double scale);
    void set_scales();
    void check_parts() const;
    void check_beginning();
    void check_given(const V& was, const V& is);
    void hit(const Leg& before, V& velocity, Jet& spin);
    void check_touch(const auto& meeting_at, const I& closing);
    void check_motion();
    void check_contact(std::size_t primitive);
    void check_rest(const Rest& rest);
    Meeting resting_on(std::int64_t other, std::size_t primitive, std::size_t& material) const;
    void check_clear_of(std::size_t primitive);
    void check_clear_of(const Ball& other);
    void check_passage(const Passage& passage);

    const Leg& leg() const { return ball_->legs[leg_]; }
    const Part& part_of(std::size_t primitive) const {
        return run_.parts.at(run_.primitives.at(primitive).part);
    }
    double friction(std::size_t a, std::size_t b) const {
        return std::sqrt(run_.materials.at(a).friction * run_.materials.at(b).friction);
    }
    /// How the part turns at a time; of two spans that meet there the earlier.
    static Span span_at(const Part& part, double time) {
        Span found = part.turns.empty() ? Span{0, 0, 0} : part.turns[0];
        for (const Span& span : part.turns)
            if (span.since < time) found = span;
        return found;
    }
    Lie lie(const Leg& on, std::size_t primitive, const Feature* f, const Span& span, const Jet& t) const {
        return lie_of(*f, part_of(primitive), span, motion_of(on, t).place, ball_->radius, t);
    }
    /// The feature of the primitive that the ball faces and touches best, with that normal if one is given.
    const Feature* touched(const Leg& on, std::size_t primitive, const Span& span, double t,
                           const Vec* normal = nullptr) const;
    const Rest* rest_of(const Ball& ball, const Leg& leg) const;
    /// How far balls may overlap what they rest on, in radii: in a heap, or on two parts.
    double slack_of(const Rest& rest) const {
        return std::ranges::any_of(rest.forces, [](const Force& f) { return f.other >= 0; }) ? rest_overlap
                                                                                             : bound_;
    }
    double overlap_of(auto is_it) const;
    bool passes(std::size_t part, double from, double to) const;

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
    /// A quantity stays zero, or above, over the whole segment.
    void stays_zero(const char* what, double scale, const auto& value) {
        everywhere(what, leg().start, leg().end, [&](double a, double b) {
            const double wrong = size(range(value, a, b, order));
            if (wrong <= bound_ * scale) require(what, wrong, scale, a);
            return wrong - bound_ * scale;
        });
    }
    void stays_above(const char* what, double scale, const auto& value) {
        everywhere(what, leg().start, leg().end,
                   [&](double a, double b) { return -low(range(value, a, b, order)) - bound_ * scale; });
    }
    /// A gap, at least 0 but for `slack`; gap(t, true) is of all of an interval.
    void stays_clear(const std::string& of, double from, double to, double slack, int to_order,
                     const auto& gap) {
        everywhere(
            "nothing comes earlier: gap to " + of + " is at least 0", from, to, [&](double a, double b) {
                if (low(gap(Jet(between(a, b), 0), true)[0]) >= -slack) return 0.0;
                return -low(range([&](const Jet& t) { return gap(t, false); }, a, b, to_order)) - slack;
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

Verdict Checker::check() {
    check_parts();
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
        if (ball.gone.empty()) continue;
        --leg_;
        const V at = motion_of(leg(), Jet(ball.gone[0])).place;
        const double inside = std::min({low(at.x[0]) - run_.least[0], run_.most[0] - high(at.x[0]),
                                        low(at.y[0]) - run_.least[1], run_.most[1] - high(at.y[0])});
        require("is at the border when it is lost", std::max(0.0, inside), ball.radius, leg().end);
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
/// When the segment begins.
void Checker::require_same(const char* what, const V& a, const V& b, double scale) {
    require(what, std::max(size(a.x[0] - b.x[0]), size(a.y[0] - b.y[0])), scale, leg().start);
}

void Checker::set_scales() {
    const double g = std::hypot(run_.gravity[0], run_.gravity[1]), r = ball_->radius;
    speed_ = std::sqrt(r * g) + std::hypot(leg().velocity_before[0], leg().velocity_before[1]) +
             r * std::abs(leg().spin_before);
    for (const double time : {leg().start, leg().end}) {
        const Motion m = motion_of(leg(), Jet(I(time), 2));
        speed_ += std::hypot(size(m.place.x[1]), size(m.place.y[1])) + r * size(m.spin[0]);
    }
    acceleration_ = g + speed_ * speed_ / r;
}

/// A part's angle does not jump, and a target goes down by a hit only.
void Checker::check_parts() const {
    for (std::size_t part = 0; part < run_.parts.size(); ++part) {
        const auto& turns = run_.parts[part].turns;
        for (std::size_t i = 1; i < turns.size(); ++i) {
            const double past = turns[i].since - turns[i - 1].since;
            const double jump = std::abs(turns[i - 1].angle + turns[i - 1].rate * past - turns[i].angle);
            if (!(jump <= bound_ * (1 + std::abs(turns[i].angle)) && past >= 0))
                throw Rejected("part " + run_.parts[part].name + ": its angle jumps at " +
                               std::to_string(turns[i].since) + " s by " + std::to_string(jump));
        }
        for (const Change& change : run_.parts[part].target) {
            bool hit = !change.down || change.time == 0;
            for (const Ball& ball : run_.balls)
                for (const Leg& one : ball.legs)
                    hit = hit || (one.why == "part" && one.start == change.time &&
                                  run_.primitives.at(one.met).part == part);
            if (!hit)
                throw Rejected("part " + run_.parts[part].name + ": goes down without a hit at " +
                               std::to_string(change.time) + " s");
        }
    }
}

// How a segment begins.

void Checker::check_beginning() {
    const Leg& now = leg();
    const Jet t(I(now.start), 2);
    const Motion is = motion_of(now, t);
    if (leg_ == 0 && now.start == 0) return void(++verdict_.given);
    if (leg_ == 0) return check_given(V{0.0, 0.0}, velocity_of(is));
    const Leg& before = ball_->legs[leg_ - 1];
    const Motion was = motion_of(before, t);
    require_same("position is continuous", was.place, is.place, ball_->radius);
    V velocity = velocity_of(was);
    Jet spin = was.spin;
    if (now.why == "given") return check_given(velocity, velocity_of(is));
    if (now.why != "goes on") {
        require_same("velocity before as stated", velocity, vec(now.velocity_before), speed_);
        require_same("spin before as stated", {spin, 0.0}, {now.spin_before, 0.0}, speed_ / ball_->radius);
        hit(before, velocity, spin);
    }
    require_same("velocity follows the law", velocity, velocity_of(is), speed_);
    require_same("spin follows the law", {spin, 0.0}, {is.spin, 0.0}, speed_ / ball_->radius);
}

/// By an input: a velocity is set, or added to that of all.
void Checker::check_given(const V& was, const V& is) {
    ++verdict_.given;
    double wrong = far;
    for (const Input& input : run_.inputs) {
        if (input.time != leg().start || (input.ball >= 0 && input.ball != std::int64_t(ball_->number)))
            continue;
        const V off = vec(input.velocity) + (input.ball < 0 ? was : vec({})) - is;
        wrong = std::min(wrong, std::max(size(off.x[0]), size(off.y[0])));
    }
    require("velocity is that of an input", wrong, speed_, leg().start);
}

/// What the law makes of the velocity before: restitution and kick, unless the approach is slower than the
/// rest speed (so near to it that either may be, what was done decides); friction by Coulomb, at most as much
/// as stops the slip. A disc resists a push at its rim with a third of its mass.
void Checker::hit(const Leg& before, V& velocity, Jet& spin) {
    const Leg& now = leg();
    const double r = ball_->radius;
    std::function<Meeting(const Jet&)> meeting_at;
    std::size_t other_material = 0;
    Jet share = 1.0;  // of the change of relative velocity
    V after;          // velocity of what it meets
    if (now.why == "part") {
        const Part& part = part_of(now.met);
        const Span span = span_at(part, now.start);
        const Feature* feature = touched(before, now.met, span, now.start, &now.normal);
        meeting_at = [this, &before, &now, feature, span](const Jet& t) {
            const Lie at = lie(before, now.met, feature, span, t);
            return Meeting{at.gap, at.normal, at.velocity};
        };
        after = meeting_at(now.start).velocity;
        other_material = part.material;
    } else if (now.why == "ball") {
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
        const Leg& partner = other->legs[theirs[n - 1] - 1];
        meeting_at = [this, &before, &partner, other](const Jet& t) {
            const Motion theirs_now = motion_of(partner, t);
            const V apart = motion_of(before, t).place - theirs_now.place;
            const Jet far_apart = length(apart);
            return Meeting{far_apart - ball_->radius - other->radius,
                           {apart.x / far_apart, apart.y / far_apart},
                           velocity_of(theirs_now),
                           other->radius * theirs_now.spin};
        };
        after = vec(other->legs[theirs[n - 1]].velocity);
        other_material = other->material;
        share = other->mass / (Jet(ball_->mass) + other->mass);
    } else {
        throw std::runtime_error("a segment begins by '" + now.why + "'");
    }
    const Meeting at = meeting_at(Jet(I(now.start), 2));
    const V relative = velocity - at.velocity;
    const I closing = (Jet(0.0) - dot(relative, at.normal))[0];
    require_same("normal as stated", at.normal, vec(now.normal), 1);
    check_touch(meeting_at, closing);

    const Material &own = run_.materials.at(ball_->material), &theirs = run_.materials.at(other_material);
    const I slip = (cross(at.normal, relative) - r * spin - at.rim)[0];
    const double near = bound_ * speed_, over = low(closing) - run_.rest_speed;
    const bool rests =
        over < -near || (over <= near && high(dot(vec(now.velocity) - after, at.normal)[0]) <= 2 * near);
    const I back = own.restitution * theirs.restitution * closing, kick(std::max(own.kick, theirs.kick));
    const I along = closing + (rests ? I(0) : low(back) >= low(kick) ? back : kick);
    const I most = friction(ball_->material, other_material) * along, stop = -slip / 3;
    const Jet across = low(stop) > high(most) ? most : high(stop) < low(-most) ? I(-most) : stop;
    velocity = velocity + share * (along * at.normal + across * perp(at.normal));
    spin = spin - 2.0 / r * share * across;
}

/// The gap is zero, changes its sign within the interval stated, and falls all over it. Without an interval
/// it is a touch without approach, which changes nothing, or a graze.
void Checker::check_touch(const auto& meeting_at, const I& closing) {
    const Leg& now = leg();
    const auto gap = [&](const Jet& t) { return meeting_at(t).gap; };
    require("gap at an impact is 0", size(gap(now.start)[0]), ball_->radius, now.start);
    if (now.within < 0) {
        ++(size(closing) <= bound_ * speed_ ? verdict_.touches : verdict_.not_isolated);
        return;
    }
    ++verdict_.impacts;
    const double from = now.start - now.within, to = now.start + now.within;
    if (!(low(gap(from)[0]) > 0)) reject("gap before the isolating interval is above 0", from, now.within);
    if (!(high(gap(to)[0]) < 0)) reject("gap after the isolating interval is below 0", to, now.within);
    const I slope = range([&](const Jet& t) { return gap(t).derivative(); }, from, to, order);
    if (!(high(slope) < 0)) reject("gap falls all over the isolating interval", from, high(slope));
}

const Feature* Checker::touched(const Leg& on, std::size_t primitive, const Span& span, double t,
                                const Vec* normal) const {
    const Feature* best = nullptr;
    double least = far;
    for (const Feature& f : features_.at(primitive)) {
        const Lie at = lie(on, primitive, &f, span, t);
        double wrong = size(at.gap[0]) / ball_->radius;
        if (normal != nullptr)
            wrong += size(at.normal.x[0] - (*normal)[0]) + size(at.normal.y[0] - (*normal)[1]);
        if (at.facing && wrong < least) least = wrong, best = &f;
    }
    if (best == nullptr) reject("the primitive that it touches faces it", t, 0);
    return best;
}

// How a ball moves.

const Rest* Checker::rest_of(const Ball& ball, const Leg& leg) const {
    for (const Rest& rest : run_.rests)
        if ((rest.from < leg.end && leg.start < rest.until) ||
            (is_still(leg) && rest.from <= leg.start && leg.end <= rest.until))
            for (const Force& force : rest.forces)
                if (force.ball == ball.number || force.other == std::int64_t(ball.number)) return &rest;
    return nullptr;
}

void Checker::check_motion() {
    const Leg& now = leg();
    if (const Rest* rest = rest_of(*ball_, now)) return check_rest(*rest);
    if (now.held >= 0) return check_contact(static_cast<std::size_t>(now.held));
    const V g = vec(run_.gravity);
    const auto force = [&](const Jet& t) {
        const V v = velocity_of(motion_of(now, t));
        return derivative(v) - g + run_.damping * v;
    };
    stays_zero("flies by the equation of motion", acceleration_, [&](const Jet& t) { return force(t).x; });
    stays_zero("flies by the equation of motion", acceleration_, [&](const Jet& t) { return force(t).y; });
    stays_zero("spin stays in flight", acceleration_ / ball_->radius,
               [&](const Jet& t) { return motion_of(now, t).spin.derivative(); });
}

/// Slides, with friction against the slip, or rolls within Coulomb's cone; the surface only pushes.
void Checker::check_contact(std::size_t primitive) {
    ++verdict_.held;
    const Leg& now = leg();
    const double r = ball_->radius, scale = acceleration_;
    const Span span = span_at(part_of(primitive), std::nextafter(now.start, far));
    const Feature* f = touched(now, primitive, span, now.start + (now.end - now.start) / 2);
    const I mu(friction(ball_->material, part_of(primitive).material));
    struct Contact {
        Jet gap, normal_force, friction, slip, spin;
    };
    const auto at = [&](const Jet& t) {
        const Motion m = motion_of(now, t);
        const Lie on = lie(now, primitive, f, span, t);
        const V v = velocity_of(m), force = derivative(v) - vec(run_.gravity) + run_.damping * v;
        return Contact{on.gap, dot(force, on.normal), cross(on.normal, force),
                       cross(on.normal, v - on.velocity) - r * m.spin, m.spin};
    };
    stays_zero("stays in contact", r, [&](const Jet& t) { return at(t).gap; });
    stays_above("contact force is at least 0", scale, [&](const Jet& t) { return at(t).normal_force; });
    stays_zero("spin changes by friction", scale,
               [&](const Jet& t) { return r / 2 * at(t).spin.derivative() + at(t).friction; });
    const I begins = at(Jet(I(now.start), 2)).slip[0], ends = at(Jet(I(now.end), 2)).slip[0];
    if (std::max(size(begins), size(ends)) <= bound_ * speed_ && low(mu) > 0) {
        stays_zero("rolls without slip", speed_, [&](const Jet& t) { return at(t).slip; });
        for (const double side : {1.0, -1.0})
            stays_above("friction within Coulomb's cone", scale,
                        [&](const Jet& t) { return mu * at(t).normal_force - side * at(t).friction; });
        return;
    }
    const double sign = low(begins) + low(ends) > 0 ? 1 : -1;
    if (low(mu) > 0) stays_above("slips one way", speed_, [&](const Jet& t) { return sign * at(t).slip; });
    stays_zero("friction against the slip", scale,
               [&](const Jet& t) { return at(t).friction + sign * mu * at(t).normal_force; });
}

/// The ball and what it rests on: another ball at rest, or a primitive of a still part.
Checker::Meeting Checker::resting_on(std::int64_t other, std::size_t primitive, std::size_t& material) const {
    const V place = vec(leg().position);
    if (other >= 0) {
        const auto ball = std::ranges::find(run_.balls, std::size_t(other), &Ball::number);
        const Leg* on = nullptr;
        if (ball != run_.balls.end())
            for (const Leg& one : ball->legs)
                if (one.start <= leg().start) on = &one;
        if (on == nullptr) reject("the ball that it rests on is there", leg().start, 0);
        material = ball->material;
        const V off = place - vec(on->position);
        const Jet apart = length(off);
        return {apart - ball_->radius - ball->radius, {off.x / apart, off.y / apart}, {}};
    }
    const Part& part = part_of(primitive);
    const Span span = span_at(part, std::nextafter(leg().start, far));
    if (span.rate != 0) reject("rests on what stands still", leg().start, std::abs(span.rate));
    material = part.material;
    const Lie at = lie(leg(), primitive, touched(leg(), primitive, span, leg().start), span, leg().start);
    return {at.gap, at.normal, {}};
}

/// Rests, though it may spin: the forces that are stated push, stay within Coulomb's cone (where it spins
/// they are on its edge, against the slip), act where it touches, and balance its weight.
void Checker::check_rest(const Rest& rest) {
    ++verdict_.resting;
    const Leg& now = leg();
    const double r = ball_->radius, m = ball_->mass, scale = m * acceleration_, slack = slack_of(rest);
    const double sense = now.spin > 0   ? 1
                         : now.spin < 0 ? -1
                                        : 0,
                 slows = now.spins.empty() ? 0 : now.spins[0];
    if (!is_still(now) || now.spins.size() > 1 || !(rest.from <= now.start && now.end <= rest.until))
        reject("rests as long as forces hold it", now.start, 0);
    V force = m * vec(run_.gravity);
    Jet rub = 0.0;
    for (const Force& one : rest.forces) {
        const bool reacts = one.other == std::int64_t(ball_->number);
        if (one.ball != ball_->number && !reacts) continue;
        std::size_t material = 0;
        const Meeting at = resting_on(reacts ? std::int64_t(one.ball) : one.other, one.primitive, material);
        const I most = friction(ball_->material, material) * I(one.normal);
        if (!(low(at.gap[0]) >= -slack * r && high(at.gap[0]) <= std::min(slack, rest_gap) * r))
            reject("touches what it rests on", now.start, size(at.gap[0]));
        verdict_.loosest = std::max(verdict_.loosest, size(at.gap[0]) / r);
        require("contact force is at least 0", -one.normal, scale, now.start);
        require("friction within Coulomb's cone", high(std::abs(one.friction) - most), scale, now.start);
        if (sense != 0)
            require("friction against the slip", size(one.friction - sense * most), scale, now.start);
        force = force + one.normal * at.normal + one.friction * perp(at.normal);
        rub = rub + one.friction;
    }
    require("forces balance its weight", std::max(size(force.x[0]), size(force.y[0])), scale, now.start);
    require("spin changes by friction", size(m * r / 2 * I(slows) + rub[0]), scale, now.start);
    require("spin keeps its sense", -sense * (now.spin + (now.end - now.start) * slows) * r, speed_, now.end);
}

// Nothing came earlier.

bool Checker::passes(std::size_t part, double from, double to) const {
    return std::ranges::any_of(run_.passages, [&](const Passage& p) {
        return p.ball == ball_->number && p.gate == part && p.from <= from && to <= p.until;
    });
}

/// By how much, in radii, the ball may overlap what it rests on (`is_it` of a force); else the bound.
double Checker::overlap_of(auto is_it) const {
    const Rest* rest = rest_of(*ball_, leg());
    return rest != nullptr && std::ranges::any_of(rest->forces, is_it) ? slack_of(*rest) : bound_;
}

/// The ball is not nearer than touching to any feature of the primitive.
void Checker::check_clear_of(std::size_t primitive) {
    const std::size_t index = run_.primitives[primitive].part;
    const Part& part = run_.parts[index];
    if (part.sensor || !meets(*ball_, part)) return;
    std::vector<double> times{leg().start, leg().end};  // at which something about the part changes
    const auto add = [&](double t) {
        if (t > leg().start && t < leg().end) times.push_back(t);
    };
    for (const Span& span : part.turns) add(span.since);
    for (const Change& change : part.target) add(change.time);
    for (const Passage& p : run_.passages)
        if (p.gate == index && p.ball == ball_->number) add(p.from), add(p.until);
    std::ranges::sort(times);
    const bool held = leg().held == std::int64_t(primitive);
    const double slack = ball_->radius * overlap_of([&](const Force& f) {
                             return f.ball == ball_->number && f.other < 0 && f.primitive == primitive;
                         });
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
        const double from = times[i], to = times[i + 1];
        bool down = false;
        for (const Change& change : part.target)
            if (change.time <= from) down = change.down;
        if (down || passes(index, from, to)) continue;
        const Span span = span_at(part, from + (to - from) / 2);
        for (const Feature& f : features_[primitive])
            stays_clear(part.name, from, to, slack, held ? order : gap_order, [&](const Jet& t, bool all) {
                const Lie at = lie(leg(), primitive, &f, span, t);
                return all && at.apart ? Jet(far) : at.gap;
            });
    }
}

void Checker::check_clear_of(const Ball& other) {
    const double reach = ball_->radius + other.radius, least = std::min(ball_->radius, other.radius);
    const double overlap = overlap_of([&](const Force& f) {
        return (f.ball == ball_->number && f.other == std::int64_t(other.number)) ||
               (f.ball == other.number && f.other == std::int64_t(ball_->number));
    });
    for (const Leg& theirs : other.legs) {
        const double from = std::max(leg().start, theirs.start), to = std::min(leg().end, theirs.end);
        if (!(from < to)) continue;
        stays_clear("ball " + std::to_string(other.number), from, to,
                    overlap > bound_ ? overlap * least : bound_ * reach, gap_order, [&](const Jet& t, bool) {
                        return length(motion_of(leg(), t).place - motion_of(theirs, t).place) - reach;
                    });
    }
}

/// A ball passes a gate that it came to from behind, or that was open; and only as long as it is at the gate.
void Checker::check_passage(const Passage& passage) {
    const Leg& now = leg();
    const Part& gate = run_.parts.at(passage.gate);
    const double from = std::max(now.start, passage.from), to = std::min(now.end, passage.until);
    const Span span = span_at(gate, from);
    const auto any_feature = [&](auto holds) {
        bool any = false;
        for (std::size_t primitive = 0; primitive < features_.size(); ++primitive)
            for (const Feature& f : features_[primitive])
                any = any || (run_.primitives[primitive].part == passage.gate && holds(primitive, f));
        return any;
    };
    if (passage.from > 0 && now.start <= passage.from && passage.from < now.end) {
        const bool open = std::ranges::any_of(run_.passages, [&](const Passage& other) {
            return &other != &passage && other.gate == passage.gate && other.from <= passage.from &&
                   passage.from <= other.until;
        });
        const bool behind = any_feature([&](std::size_t primitive, const Feature& f) {
            const V n = lie(now, primitive, &f, span, passage.from).normal;
            return f.kind == Feature::Kind::line && low(dot(n, vec(gate.gate))[0]) < 0;
        });
        if (!open && !behind) reject("passes " + gate.name + " from behind", passage.from, 0);
    }
    if (!(from < to)) return;
    everywhere("is at " + gate.name + " as long as it passes", from, to, [&](double a, double b) {
        const bool near = any_feature([&](std::size_t primitive, const Feature& f) {
            const auto gap = [&](const Jet& t) { return lie(now, primitive, &f, span, t).gap; };
            return lie(now, primitive, &f, span, between(a, b)).facing &&
                   high(range(gap, a, b, gap_order)) <= (gate_clearance + bound_) * ball_->radius;
        });
        return near ? 0.0 : 1.0;
    });
}

}  // namespace

Verdict check(Run& run, double bound) {
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
