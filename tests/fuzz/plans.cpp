/// Plans of a sweep, without their last line (lab/files/data_file.hpp): read, and asked for what they plan.

#include <cmath>

#include "fuzz/oracle.hpp"
#include "fuzz/target.hpp"
#include "lab/sweep/plan.hpp"

namespace flipside::fuzz {

void run_input(std::string_view input) {
    set_subject("reader");
    namespace sweep = lab::sweep;
    static_cast<void>(accepted([&] {
        const CpuLimit limit(longest_answer);
        const sweep::Plan plan = sweep::parse_plan(input, "input.json");
        for (const sweep::Contender* contender : plan.contenders)
            for (const double dt : sweep::steps_of(*contender, plan)) {
                require(std::isfinite(dt) && dt > 0, "a step size is no time");
                require(sweep::thinning(plan, 10, 1, dt) > 0, "every none-th window is run");
            }
        const auto units = sweep::units_of(plan);
        require(units.size() == plan.variants.size() * plan.blocks, "a plan has other units than it says");
    }));
}

}  // namespace flipside::fuzz
