#include <algorithm>

#include "lab/cases/families.hpp"
#include "world/input_error.hpp"

namespace flipside::lab {

namespace {

constexpr Case all[] = {
    {1, "zeno-drop", "Zeno drop",
     "A dropped ball bounces ever lower and faster: infinitely often in a finite time, after which it lies.",
     "", zeno_drop},
    {2, "elastic-drop", "Elastic drop",
     "A ball bounces for ever; its energy shows whether the engine gains or loses some at every bounce.", "",
     elastic_drop},
    {5, "galperin", "Galperin's pi",
     "A heavy ball drives a light one against a wall; the number of collisions spells out pi.",
     "G. Galperin, Playing pool with pi, 2003", galperin},
};

bool answers_to(const Case& which, const std::string& name) {
    return which.name == name || std::to_string(which.number) == name;
}

}  // namespace

std::span<const Case> cases() {
    return all;
}

std::vector<const Case*> find_cases(std::span<const std::string> names) {
    std::string known;
    for (const Case& one : all) known += (known.empty() ? "" : ", ") + std::string(one.name);
    for (const std::string& name : names)
        if (std::ranges::none_of(all, [&](const Case& one) { return answers_to(one, name); }))
            throw InputError("unknown case '" + name + "'; known are " + known + ", or their numbers");
    std::vector<const Case*> found;
    for (const Case& one : all)
        if (names.empty() ||
            std::ranges::any_of(names, [&](const std::string& name) { return answers_to(one, name); }))
            found.push_back(&one);
    return found;
}

CaseResult run_case(const Case& which, const CaseInput& input) {
    Experiment experiment(input);
    experiment.attempt(std::string(which.title), [&] { which.run(experiment); });
    return experiment.finish();
}

}  // namespace flipside::lab
