#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "app/window/contender_colour.hpp"
#include "app/window/panel_tabs.hpp"
#include "app/window/words.hpp"

namespace flipside::app {

namespace {

using Value = std::function<std::string(const Run&)>;

void flush_right(const std::string& line) {
    const float slack = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(line.c_str()).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0F, slack));
    ImGui::TextUnformatted(line.c_str());
}

/// Broken between words; a word for which there is no room is cut, and the tooltip has all of it.
void value_in_cell(const std::string& text) {
    const float room = ImGui::GetContentRegionAvail().x;
    const auto fits = [room](const std::string& line) { return ImGui::CalcTextSize(line.c_str()).x <= room; };
    std::string words;
    for (std::string_view rest = text; !rest.empty();) {
        const std::string word(rest.substr(0, end_of_word(rest)));
        rest.remove_prefix(std::min(rest.size(), word.size() + 1));
        words += (words.empty() ? "" : " ") + cut(word, room);
    }
    ImGui::BeginGroup();
    for (const std::string& line : in_lines(words, fits)) flush_right(line);
    ImGui::EndGroup();
    if (words != text) tooltip(text);
}

/// One line: what it is, and its value for each run.
void row(const Stage& stage, const char* words, const char* meaning, const Value& value) {
    ImGui::TableNextColumn();
    wrapped(words);
    tooltip(meaning);
    for (const Run& run : stage.runs()) {
        ImGui::TableNextColumn();
        value_in_cell(value(run));
    }
}

/// A name for which there is no room is broken behind its hyphens: "box2d-cold" and "box2d-warm" differ at
/// their ends.
std::vector<std::string> name_in_lines(const std::string& name, float room) {
    std::vector<std::string> lines{name};
    while (ImGui::CalcTextSize(lines.back().c_str()).x > room) {
        const std::size_t at = lines.back().find('-');
        if (at == std::string::npos || at + 1 == lines.back().size()) break;
        std::string rest = lines.back().substr(at + 1);
        lines.back().resize(at + 1);
        lines.push_back(std::move(rest));
    }
    for (std::string& line : lines) line = cut(line, room);
    return lines;
}

bool begin_table(const Stage& stage, const char* id) {
    const int columns = 1 + static_cast<int>(stage.runs().size());
    // With four contenders a column has room for little more than "12.4 µs".
    ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, {1, ImGui::GetStyle().CellPadding.y});
    const bool open = ImGui::BeginTable(id, columns, ImGuiTableFlags_SizingStretchProp);
    ImGui::PopStyleVar();
    if (!open) return false;
    ImGui::TableSetupColumn("", 0, 1.45F);
    for (std::size_t i = 0; i < stage.runs().size(); ++i) ImGui::TableSetupColumn("", 0, 1);
    ImGui::TableNextColumn();
    for (const Run& run : stage.runs()) {
        ImGui::TableNextColumn();
        ImGui::PushStyleColor(ImGuiCol_Text, imgui_color(colour_of(run)));
        for (const std::string& line : name_in_lines(run.name(), ImGui::GetContentRegionAvail().x)) {
            flush_right(line);
        }
        ImGui::PopStyleColor();
        tooltip(run.name());
    }
    return true;
}

std::string whole(double number) {
    return grouped(static_cast<std::uint64_t>(std::llround(number)));
}

std::string box_tests(const Run& run, double number) {
    return run.session().world().statistics().counts_pair_tests ? whole(number) : "not counted";
}

void balls_in_play(const Stage& stage) {
    if (!begin_table(stage, "balls")) return;
    row(stage, "On the table", "Balls in the world now",
        [](const Run& run) { return grouped(run.session().world().balls().size()); });
    row(stage, "Launched", "Balls that entered since the start",
        [](const Run& run) { return grouped(run.session().totals().launched); });
    row(stage, "Overlaps", "Balls at the exact position of another",
        [](const Run& run) { return grouped(run.rates().overlaps); });
    row(stage, "Strays", "Balls that left the table where there is no way out",
        [](const Run& run) { return grouped(run.session().totals().strays); });
    row(stage, "Drained", "Balls that left it otherwise",
        [](const Run& run) { return grouped(run.session().totals().lost - run.session().totals().strays); });
    ImGui::EndTable();
}

void detection(const Stage& stage) {
    if (!begin_table(stage, "tests")) return;
    row(stage, "AABB tests per step", "Tests of one bounding box against another, insertion included",
        [](const Run& run) { return box_tests(run, run.rates().pair_tests_per_step); });
    row(stage, "AABB tests/s", "The same per second of your time",
        [](const Run& run) { return box_tests(run, run.rates().pair_tests); });
    row(stage, "Full tests per step", "Tests of one shape against another, after their boxes overlap",
        [](const Run& run) { return whole(run.rates().narrow_tests_per_step); });
    row(stage, "Full tests/s", "The same per second of your time",
        [](const Run& run) { return whole(run.rates().narrow_tests); });
    row(stage, "Collisions/s", "Impacts per second of your time",
        [](const Run& run) { return whole(run.rates().impacts); });
    row(stage, "Time per step",
        "CPU time that the engine takes for one step; a step looked into does not count", [](const Run& run) {
            const double seconds = run.rates().step_seconds;
            return seconds > 0 ? engineering(seconds, "s") : std::string("–");
        });
    ImGui::EndTable();
}

void broad_phase(const Stage& stage) {
    if (!begin_table(stage, "broad")) return;
    const auto fact = [](auto member) {
        return [member](const Run& run) {
            const BroadPhaseFacts& facts = run.session().world().statistics().broad_phase;
            return facts.*member > 0 ? whole(facts.*member) : std::string("–");
        };
    };
    row(stage, "Kind", "How the engine finds what is near", [](const Run& run) {
        const std::string_view name = run.session().world().statistics().broad_phase.name;
        return name.empty() ? std::string("–") : std::string(name);
    });
    row(stage, "Levels", "Depth of the tree", fact(&BroadPhaseFacts::levels));
    row(stage, "Nodes", "Nodes of the tree", fact(&BroadPhaseFacts::nodes));
    row(stage, "Leaves", "Leaves, or cells", fact(&BroadPhaseFacts::leaves));
    row(stage, "Leaf size, mm", "Width and height of a leaf, mm", [](const Run& run) {
        const BroadPhaseFacts& facts = run.session().world().statistics().broad_phase;
        return facts.leaf_width > 0 ? whole(1000 * facts.leaf_width) + " × " + whole(1000 * facts.leaf_height)
                                    : std::string("–");
    });
    row(stage, "Most in a leaf", "Shapes in the fullest leaf", fact(&BroadPhaseFacts::most_in_leaf));
    ImGui::EndTable();
}

void draw_load(const Load& load) {
    label("Frames", "Pictures drawn per second, over the last second");
    ImGui::Text("%.0f per second", load.frames_per_second);
    label("Busy", "Share of each frame's time that the program works; the engines' part of it");
    ImGui::TextUnformatted(
        (with_unit(100 * load.busy, 0, "%") + ", engines " + with_unit(100 * load.physics, 1, "%")).c_str());
}

}  // namespace

void draw_numbers_tab(const Panel& panel, const Load& load) {
    if (region("Balls in play")) balls_in_play(panel.stage);
    if (region("Detection and response")) detection(panel.stage);
    if (region("Broad phase")) broad_phase(panel.stage);
    if (region("Load")) draw_load(load);
}

}  // namespace flipside::app
