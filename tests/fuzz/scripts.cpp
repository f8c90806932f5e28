/// Scripts of a table, read, written again, and played on every engine and solver.

#include "fuzz/drive.hpp"
#include "fuzz/oracle.hpp"
#include "fuzz/table_scene.hpp"
#include "fuzz/target.hpp"
#include "world/script_file.hpp"

namespace flipside::fuzz {

void run_input(std::string_view input) {
    set_subject("reader");
    const auto& scene = table_scene();
    Script script;
    const bool read = accepted([&] {
        const CpuLimit limit(longest_answer);
        script = parse_script(input, "input.json", *scene);
    });
    if (!read) return;
    const std::string text = to_json(script, *scene);
    require(to_json(parse_script(text, "written", *scene), *scene) == text,
            "a script is not read as it was written");
    for (const Contender& contender : contenders())
        drive(contender, {.scene = scene, .script = script, .variation = variation_of(input)});
}

}  // namespace flipside::fuzz
