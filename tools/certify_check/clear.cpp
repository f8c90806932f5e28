#include "checker.hpp"

namespace certificate {

namespace {

/// A gate lets go of a ball when its surface is so far away, in radii: what the scenes' rules say.
constexpr double gate_clearance = 1e-9;
/// What is far off needs no high one.
constexpr int gap_order = 3;

}  // namespace

bool Checker::passes(std::size_t part, double from, double to) const {
    return std::ranges::any_of(run_.passages, [&](const Passage& p) {
        return p.ball == ball_->number && p.gate == part && p.from <= from && to <= p.until;
    });
}

/// Times within the segment at which something about a part changes, its ends among them.
std::vector<double> Checker::changes_of(std::size_t part) const {
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

/// The ball is not nearer than touching to any feature of the primitive, but the one that holds it.
void Checker::check_clear_of(std::size_t primitive) {
    const std::size_t index = run_.primitives[primitive].part;
    const Part& part = run_.parts[index];
    if (part.sensor || !meets(*ball_, part)) return;
    const bool is_held = std::ranges::find(leg().held, primitive) != leg().held.end();
    const Feature* held = is_held ? &held_on(primitive) : nullptr;
    const double r = ball_->radius;
    const std::vector<double> times = changes_of(index);
    for (std::size_t i = 0; i + 1 < times.size(); ++i) {
        const double from = times[i], to = times[i + 1];
        bool down = false;
        for (const Change& change : part.target)
            if (change.time <= from) down = change.down;
        if (down || passes(index, from, to)) continue;
        const Span* span = span_at(part, from + (to - from) / 2);
        for (const Feature& f : features_[primitive]) {
            if (&f == held) continue;
            const auto at = [&](const I& t, int order) {
                return lie_of(f, part, span, motion_of(leg(), t, order).place, r, t);
            };
            everywhere("nothing comes earlier: gap to " + part.name + " is at least 0", from, to,
                       [&](double a, double b) {
                           const Lie all = at(between(a, b), 0);
                           if (all.apart || low(all.gap.c[0]) >= -bound_ * r) return 0.0;
                           return -low(range([&](const I& t) { return at(t, gap_order).gap; }, a, b)) -
                                  bound_ * r;
                       });
        }
    }
}

void Checker::check_clear_of(const Ball& other) {
    const double reach = ball_->radius + other.radius;
    for (const Leg& theirs : other.legs) {
        const double from = std::max(leg().start, theirs.start), to = std::min(leg().end, theirs.end);
        if (!(from < to)) continue;
        const auto gap = [&](const I& t, int order) {
            const Motion a = motion_of(leg(), t, order), b = motion_of(theirs, t, order);
            return length(a.place.x - b.place.x, a.place.y - b.place.y) - I(reach);
        };
        everywhere("nothing comes earlier: gap to ball " + std::to_string(other.number) + " is at least 0",
                   from, to, [&](double a, double b) {
                       if (low(gap(between(a, b), 0).c[0]) >= -bound_ * reach) return 0.0;
                       return -low(range([&](const I& t) { return gap(t, gap_order); }, a, b)) -
                              bound_ * reach;
                   });
    }
}

/// A ball passes a gate that it came to from behind, or that was open; and only as long as it is at the gate.
void Checker::check_passage(const Passage& passage) {
    const Part& gate = run_.parts.at(passage.gate);
    const double r = ball_->radius, from = std::max(leg().start, passage.from),
                 to = std::min(leg().end, passage.until);
    const Leg& now = leg();
    const Span* span = span_at(gate, from);
    const auto at = [&](const Feature& f, const I& t) {
        return lie_of(f, gate, span, motion_of(now, t, gap_order).place, r, t);
    };
    if (passage.from > 0 && now.start <= passage.from && passage.from < now.end) {
        bool behind = std::ranges::any_of(run_.passages, [&](const Passage& other) {
            return &other != &passage && other.gate == passage.gate && other.from <= passage.from &&
                   passage.from <= other.until;
        });
        for (std::size_t primitive = 0; primitive < run_.primitives.size(); ++primitive)
            for (const Feature& f : features_[primitive])
                if (run_.primitives[primitive].part == passage.gate && f.kind == Feature::Kind::line) {
                    const JetVec n = at(f, I(passage.from)).normal;
                    behind = behind || low(n.x.c[0] * gate.gate[0] + n.y.c[0] * gate.gate[1]) < 0;
                }
        if (!behind) reject("passes " + gate.name + " from behind", passage.from, 0);
    }
    if (!(from < to)) return;
    everywhere("is at " + gate.name + " as long as it passes", from, to, [&](double a, double b) {
        double least = 1;
        for (std::size_t primitive = 0; primitive < run_.primitives.size(); ++primitive)
            for (const Feature& f : features_[primitive])
                if (run_.primitives[primitive].part == passage.gate && at(f, between(a, b)).facing)
                    least = std::min(least, high(range([&](const I& t) { return at(f, t).gap; }, a, b)));
        return least - (gate_clearance + bound_) * r;
    });
}

}  // namespace certificate
