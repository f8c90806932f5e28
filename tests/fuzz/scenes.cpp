/// Scene files, read and run on every engine and solver.

#include "fuzz/closed_box.hpp"
#include "fuzz/drive.hpp"
#include "fuzz/oracle.hpp"
#include "fuzz/target.hpp"
#include "world/scene_file.hpp"

namespace flipside::fuzz {

void run_input(std::string_view input) {
    set_subject("reader");
    std::shared_ptr<const Scene> scene;
    const bool read = accepted([&] {
        const CpuLimit limit(longest_answer);
        scene = std::make_shared<const Scene>(parse_scene(input, "input.json"));
    });
    if (!read || !is_small(*scene)) return;
    const Script nothing;
    const unsigned variation = variation_of(input);
    for (const Contender& contender : contenders())
        drive(contender, {.scene = scene, .script = nothing, .variation = variation});
    const auto closed = closed_box(*scene);
    if (closed == nullptr) return;
    for (const Contender& contender : contenders())
        if (contender.keeps_balls)
            drive(contender, {.scene = closed, .script = nothing, .variation = variation, .closed = true});
}

}  // namespace flipside::fuzz
