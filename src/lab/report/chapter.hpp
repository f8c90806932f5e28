#pragma once
/// The chapters of a report: what each must measure, and what it makes of the files. A chapter shows what
/// stands in its files and nothing else, so the same files give the same figures.

#include <functional>
#include <string>
#include <vector>

#include "lab/report/effort.hpp"
#include "lab/report/measurement.hpp"
#include "lab/report/page.hpp"

namespace flipside::lab::report {

struct Chapter {
    std::string id, title, intro;
    std::vector<Measurement> measurements;
    std::function<Content(const Data& data)> show;  ///< throws InputError for files that are not whole
};

/// Speed against error on exact windows: measured, or where `from` names folders of `flipside sweep`, theirs.
[[nodiscard]] Chapter work_precision_chapter(const Effort& effort,
                                             const std::vector<std::filesystem::path>& from);
/// The engines of others at settings found by search.
[[nodiscard]] Chapter tuning_chapter(const Effort& effort);
/// Cost, error and overlap by what the balls do.
[[nodiscard]] Chapter regime_chapter(const Effort& effort);
/// Experiments with known answers, as tables.
[[nodiscard]] Chapter hard_case_chapter(const Effort& effort);
/// Speed against error in some of them.
[[nodiscard]] Chapter case_work_chapter(const Effort& effort);
/// Where engines break: mass ratio, stack, speed and step.
[[nodiscard]] Chapter border_chapter(const Effort& effort);
/// Energy where it must stay as it is.
[[nodiscard]] Chapter energy_chapter(const Effort& effort);
/// How fast the engines part on the pinball table.
[[nodiscard]] Chapter divergence_chapter(const Effort& effort);
/// How deep balls lie in what they touch.
[[nodiscard]] Chapter penetration_chapter(const Effort& effort);
/// A step's cost with the number of balls, ours and Box2D's, in rain.
[[nodiscard]] Chapter growth_chapter(const Effort& effort);
/// Box tests of every broad phase, in the toy's experiment and up to 100,000 balls.
[[nodiscard]] Chapter broad_phase_chapter(const Effort& effort);

/// All, in the order of the page.
[[nodiscard]] std::vector<Chapter> chapters(const Effort& effort,
                                            const std::vector<std::filesystem::path>& from);

}  // namespace flipside::lab::report
