/// States of a table, read, written again, and continued on every engine and solver.

#include "fuzz/drive.hpp"
#include "fuzz/oracle.hpp"
#include "fuzz/table_scene.hpp"
#include "fuzz/target.hpp"
#include "world/state_file.hpp"

namespace flipside::fuzz {

void run_input(std::string_view input) {
    set_subject("reader");
    const auto& scene = table_scene();
    State state;
    const bool read = accepted([&] {
        const CpuLimit limit(longest_answer);
        state = parse_state(input, "input.json", *scene);
    });
    if (!read) return;
    const std::string text = to_json(state, *scene);
    require(to_json(parse_state(text, "written", *scene), *scene) == text,
            "a state is not read as it was written");
    if (!is_small(state)) return;
    const Script nothing;
    for (const Contender& contender : contenders())
        drive(contender,
              {.scene = scene, .script = nothing, .start = &state, .variation = variation_of(input)});
}

}  // namespace flipside::fuzz
