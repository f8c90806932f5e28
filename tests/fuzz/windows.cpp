/// Window files of a sweep, without their last line (lab/files/data_file.hpp): read, written again and run.

#include "lab/sweep/windows.hpp"

#include "fuzz/drive.hpp"
#include "fuzz/oracle.hpp"
#include "fuzz/table_scene.hpp"
#include "fuzz/target.hpp"
#include "lab/sweep/measure.hpp"

namespace flipside::fuzz {

namespace {

constexpr double dt = 1.0 / 60;  ///< s

void run(const lab::sweep::Window& window, const Contender& contender) {
    Settings settings(contender.engine->settings);
    for (const auto& [name, value] : contender.settings) settings.set(name, value);
    set_subject(contender.name);
    const auto world = contender.engine->make(table_scene(), settings);
    const CpuLimit limit(2 * longest_answer);
    lab::History history;
    static_cast<void>(lab::sweep::run_window(*world, window, dt, history));
}

}  // namespace

void run_input(std::string_view input) {
    set_subject("reader");
    namespace sweep = lab::sweep;
    const Scene& scene = *table_scene();
    static const sweep::BlockPlan plan{.variant = {.name = "table", .scene = "table"}};
    sweep::Block block;
    const bool read = accepted([&] {
        const CpuLimit limit(longest_answer);
        block = sweep::parse_block(input, "input.json", plan, scene);
    });
    if (!read) return;
    const std::string text = sweep::to_json(block, scene);
    require(sweep::to_json(sweep::parse_block(text, "written", plan, scene), scene) == text,
            "windows are not read as they were written");
    if (block.windows.empty()) return;
    const sweep::Window& window = block.windows.front();
    if (is_small(window.start)) run(window, contenders()[variation_of(input) % contenders().size()]);
}

}  // namespace flipside::fuzz
