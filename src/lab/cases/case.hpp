#pragma once
/// The hard cases: experiments whose right answer is known, to be run on any engine at any setting.
///
/// A case compares quantities with their exact answers. An event-ordered solver (the custom engine's
/// continuous one, the reference) is held to the tolerance of each; a time-stepping one is measured, never
/// passed or failed by decree, but for what must hold on any engine (nothing lost, no NaN). The numbers are
/// those of docs/accuracy.md; a case is added in a family's file, families.hpp and cases.cpp.
///
/// As JSON ("flipside-cases/1", to_json; null stands for what is not there and for what is no finite number):
///
///     {"format": "flipside-cases/1", "engine": "custom", "settings": {...}, "dt": 0.0166,
///      "quick": false, "verdicts": {"pass": 27, "fail": 0, "measured": 2, "not reached": 0, "refused": 0},
///      "cases": [{"number": 1, "name": "zeno-drop", "title": "Zeno drop", "about": "...", "source": "...",
///                 "recommended": {}, "verdict": "pass", "reason": "",
///                 "rows": [{"quantity": "time of rest, e = 0.5", "unit": "s", "expected": 1.35, "measured":
///                           1.35, "error": 1e-9, "tolerance": 2e-8, "interval": null, "needed": null,
///                           "verdict": "pass"}],
///                 "steps": 812, "impacts": 160, "handed_over": 0, "cpu_seconds": 0.002}]}

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "lab/comparison/compare.hpp"
#include "lab/session/run_settings.hpp"

namespace flipside::lab {

enum class Verdict {
    pass,
    fail,
    measured,     ///< an error is given, and no judgement
    not_reached,  ///< what the row is about did not happen, within the work that a case may cost
    refused       ///< the engine says that it cannot do this exactly
};
inline constexpr std::string_view verdict_names[] = {"pass", "fail", "measured", "not reached", "refused"};
[[nodiscard]] constexpr std::string_view name_of(Verdict verdict) {
    return verdict_names[static_cast<std::size_t>(verdict)];
}

struct CaseRow {
    std::string quantity;
    std::string unit{};                 ///< "" where it has none
    std::optional<double> expected{};   ///< empty where nothing exact is known
    double measured = 0;                ///< NaN where it was not reached
    double error = 0;                   ///< |measured − expected|; NaN where there is none
    std::optional<double> tolerance{};  ///< of the error; empty for what is only measured
    std::optional<double> interval{};   ///< half width of the 99.9 % confidence interval of a statistic
    std::optional<double> needed{};     ///< the widest interval with which a statistic may pass
    Verdict verdict = Verdict::measured;
};

struct CaseResult {
    std::vector<CaseRow> rows;
    Verdict verdict = Verdict::measured;  ///< of the whole, see run_case
    std::string reason;       ///< of refusals, of states that are no numbers and of an early end; else ""
    std::uint64_t steps = 0;  ///< of all worlds of the case together
    std::uint64_t impacts = 0;
    std::uint64_t handed_over = 0;  ///< Statistics::handed_over, summed over the steps
    double cpu_seconds = 0;         ///< in World::step alone
};

struct CaseInput {
    Contender contender;
    double dt = 1.0 / 60;         ///< s
    bool quick = false;           ///< fewer hits, shorter runs; the rows name the numbers
    std::function<void()> watch;  ///< called after each step where it is given; may throw to stop
};

class Experiment;

struct Case {
    int number;
    std::string_view name, title;
    std::string_view about;   ///< what it shows, in a sentence or two
    std::string_view source;  ///< of the answer; "" where it is school physics
    void (*run)(Experiment&);
    /// Settings to run it with where nothing else is said: "ENGINE.NAME=VALUE", separated by spaces.
    std::string_view recommend{};
};

/// By number.
[[nodiscard]] std::span<const Case> cases();
/// By names or numbers, all where none is given, in the order of cases(). Throws InputError that lists the
/// known ones.
[[nodiscard]] std::vector<const Case*> find_cases(std::span<const std::string> names);

/// Never throws for what an engine does: a Refusal, a Failure and a state that is no number are results.
/// What `watch` throws goes through. Verdict: the worst of its rows, fail before refused before not_reached
/// before measured before pass; rows without a tolerance say nothing.
[[nodiscard]] CaseResult run_case(const Case& which, const CaseInput& input);

struct CaseRun {
    const Case* which = nullptr;
    CaseResult result;
    std::vector<SettingChange> recommended{};  ///< settings that are not those of the input
};

/// The same with what the case recommends for the engine, unless `changes` say otherwise. The settings of
/// `input` are the engine's defaults with `changes`.
[[nodiscard]] CaseRun run_recommended(const Case& which, const CaseInput& input,
                                      std::span<const SettingChange> changes);

[[nodiscard]] std::string to_json(std::span<const CaseRun> runs, const CaseInput& input);

}  // namespace flipside::lab
