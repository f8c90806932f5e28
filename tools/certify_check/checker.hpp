#pragma once
/// One run being checked, segment by segment: where each begins (impact.cpp), how it moves (contact.cpp), and
/// that nothing came earlier (clear.cpp).

#include <algorithm>
#include <cmath>

#include "check.hpp"

namespace certificate {

class Checker {
  public:
    Checker(const Run& run, double bound);
    Verdict check();

  private:
    // check.cpp
    [[noreturn]] void reject(const std::string& what, double time, double by) const;
    void require(const char* what, double value, double scale, double time);
    void require_same(const char* what, const I& a, const I& b, double scale, double time);
    void set_scales();
    void check_turning(const Part& part) const;
    void check_targets() const;
    void check_gone();
    static const Span* span_at(const Part& part, double time);
    [[nodiscard]] const Leg& leg() const { return ball_->legs[leg_]; }
    [[nodiscard]] const Part& part_of(std::size_t primitive) const {
        return run_.parts[run_.primitives[primitive].part];
    }
    [[nodiscard]] double friction_with(const Part& part) const;

    // impact.cpp
    /// Where the ball is by what came before, with the velocity that the law gives it.
    struct After {
        I vx, vy, spin;
    };
    struct Push {
        I along, across;  ///< changes of relative velocity
    };
    void check_beginning();
    void check_given(const Motion* was);
    void hit_part(const Leg& before, After& after);
    void hit_ball(const Leg& before, const Motion& was, After& after);
    template <class Gap>
    void check_touch(const Gap& gap, const I& closing);
    void check_normal(const I& nx, const I& ny);
    [[nodiscard]] Push push(const Material& other, const I& closing, const I& slip, const I& parting) const;

    // contact.cpp
    void check_motion();
    void check_one_contact(const Feature& feature);
    void check_two_contacts(const std::vector<const Feature*>& on);
    [[nodiscard]] JetVec force_at(const I& time) const;
    [[nodiscard]] const Span* span_of(std::size_t primitive) const;
    [[nodiscard]] Lie lie(std::size_t primitive, const Feature& feature, const I& time) const;
    [[nodiscard]] const Feature& held_on(std::size_t primitive) const;

    // clear.cpp
    void check_clear_of(std::size_t primitive);
    void check_clear_of(const Ball& other);
    void check_passage(const Passage& passage);
    [[nodiscard]] bool passes(std::size_t part, double from, double to) const;
    [[nodiscard]] std::vector<double> changes_of(std::size_t part) const;

    /// `above(from, to)` is by how much a condition may be missed at most, ≤ 0 where it holds for certain: on
    /// ever smaller parts of an interval of time.
    template <class Above>
    void everywhere(const std::string& what, double from, double to, const Above& above) {
        constexpr std::size_t most = 1'000'000;  // a few hundred, in practice
        std::vector<std::pair<double, double>> open{{from, to}};
        const std::size_t last = verdict_.enclosures + most;
        while (!open.empty()) {
            const auto [a, b] = open.back();
            open.pop_back();
            ++verdict_.enclosures;
            const double by = above(a, b);
            if (by <= 0) continue;
            const double middle = a + (b - a) / 2;
            if (b - a < 1e-14 || !(middle > a && middle < b) || verdict_.enclosures > last)
                reject(what, a, by);
            open.emplace_back(middle, b);
            open.emplace_back(a, middle);
        }
    }
    /// An expansion that stays zero, or above, over the whole segment.
    template <class Value>
    void stays_zero(const char* what, double scale, const Value& value) {
        everywhere(what, leg().start, leg().end, [&](double a, double b) {
            const double wrong = size(range(value, a, b));
            if (wrong <= bound_ * scale) require(what, wrong, scale, a);
            return wrong - bound_ * scale;
        });
    }
    template <class Value>
    void stays_above(const char* what, double scale, const Value& value) {
        everywhere(what, leg().start, leg().end,
                   [&](double a, double b) { return -low(range(value, a, b)) - bound_ * scale; });
    }

    const Run& run_;
    double bound_;
    std::vector<std::vector<Feature>> features_;  ///< by primitive
    const Ball* ball_ = nullptr;
    std::size_t leg_ = 0;
    double speed_ = 0, acceleration_ = 0;  ///< scales of the segment
    Verdict verdict_;
};

[[nodiscard]] inline JetVec velocity_of(const Motion& m) {
    return {m.place.x.derivative(), m.place.y.derivative()};
}

}  // namespace certificate
