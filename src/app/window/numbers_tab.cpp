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

/// A column of figures for each run: beside the words, or with three runs and more below them, where that has
/// room for figures.
class Figures {
  public:
    explicit Figures(const Stage& stage)
        : stage_(stage),
          left_(ImGui::GetCursorPosX()),
          gap_(0.4F * ImGui::GetFontSize()),
          beside_(stage.runs().size() < 3) {
        const float room = ImGui::GetContentRegionAvail().x;
        of_words_ = beside_ ? 0.42F * room : 0;
        of_run_ = (room - of_words_) / static_cast<float>(stage.runs().size());
        cells([this](const Run& run) {
            ImGui::PushStyleColor(ImGuiCol_Text, imgui_color(colour_of(run)));
            for (const std::string& line : name_in_lines(run.name(), of_run_ - gap_)) flush_right(line);
            ImGui::PopStyleColor();
            return run.name();
        });
    }
    /// What it is, and its value for each run.
    void row(const char* words, const char* meaning, const Value& value) const {
        const float top = ImGui::GetCursorPosY();
        close_lines();
        const float room = beside_ ? of_words_ : ImGui::GetContentRegionAvail().x;
        ImGui::PushStyleColor(ImGuiCol_Text, imgui_color(beside_ ? colour::text : colour::quiet));
        ImGui::TextUnformatted(broken(words, room).c_str());
        ImGui::PopStyleColor();
        ImGui::PopStyleVar();
        tooltip(meaning);
        const float below = ImGui::GetCursorPosY();
        if (beside_) ImGui::SetCursorPosY(top);
        cells([&](const Run& run) {
            const std::string text = value(run), shown = shortened_words(text);
            for (const std::string& line : lines_of(shown, of_run_ - gap_)) flush_right(line);
            return shown == text ? std::string() : text;
        });
        ImGui::SetCursorPosY(std::max(below, ImGui::GetCursorPosY()));
    }

  private:
    /// What belongs together.
    static void close_lines() {
        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 1});
    }
    void flush_right(const std::string& line) const {
        ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::max(0.0F, of_run_ - width_of_text(line)));
        ImGui::TextUnformatted(line.c_str());
    }
    /// A word for which there is no room is cut.
    [[nodiscard]] std::string shortened_words(std::string_view text) const {
        std::string words;
        while (!text.empty()) {
            const std::string word(text.substr(0, end_of_word(text)));
            text.remove_prefix(std::min(text.size(), word.size() + 1));
            words += (words.empty() ? "" : " ") + cut(word, of_run_ - gap_);
        }
        return words;
    }
    /// `draw` returns what the tooltip says.
    template <class Draw>
    void cells(const Draw& draw) const {
        const float top = ImGui::GetCursorPosY();
        float x = left_ + of_words_, bottom = top;
        close_lines();
        for (const Run& run : stage_.runs()) {
            ImGui::SetCursorPos({x, top});
            ImGui::BeginGroup();
            const std::string told = draw(run);
            ImGui::EndGroup();
            tooltip(told);
            bottom = std::max(bottom, ImGui::GetCursorPosY());
            x += of_run_;
        }
        ImGui::PopStyleVar();
        ImGui::SetCursorPos({left_, bottom + 0.15F * ImGui::GetFontSize()});
    }

    const Stage& stage_;
    float left_, gap_;
    bool beside_;
    float of_words_, of_run_;  ///< px
};

std::string whole(double number) {
    return grouped(static_cast<std::uint64_t>(std::llround(number)));
}

std::string box_tests(const Run& run, double number) {
    return run.session().world().statistics().counts_pair_tests ? whole(number) : "not counted";
}

void balls_in_play(const Stage& stage) {
    const Figures figures(stage);
    figures.row("On the table", "Balls in the world now",
                [](const Run& run) { return grouped(run.session().world().balls().size()); });
    figures.row("Launched", "Balls that entered since the start",
                [](const Run& run) { return grouped(run.session().totals().launched); });
    figures.row("Overlaps", "Balls at the exact position of another",
                [](const Run& run) { return grouped(run.rates().overlaps); });
    figures.row("Strays", "Balls that left the table where there is no way out",
                [](const Run& run) { return grouped(run.session().totals().strays); });
    figures.row("Drained", "Balls that left it otherwise", [](const Run& run) {
        return grouped(run.session().totals().lost - run.session().totals().strays);
    });
}

void detection(const Stage& stage) {
    const Figures figures(stage);
    figures.row("AABB tests per step", "Tests of one bounding box against another, insertion included",
                [](const Run& run) { return box_tests(run, run.rates().pair_tests_per_step); });
    figures.row("AABB tests/s", "The same per second of your time",
                [](const Run& run) { return box_tests(run, run.rates().pair_tests); });
    figures.row("Full tests per step", "Tests of one shape against another, after their boxes overlap",
                [](const Run& run) { return whole(run.rates().narrow_tests_per_step); });
    figures.row("Full tests/s", "The same per second of your time",
                [](const Run& run) { return whole(run.rates().narrow_tests); });
    figures.row("Collisions/s", "Impacts per second of your time",
                [](const Run& run) { return whole(run.rates().impacts); });
    figures.row("Time per step",
                "CPU time that the engine takes for one step; a step looked into does not count",
                [](const Run& run) {
                    const double seconds = run.rates().step_seconds;
                    return seconds > 0 ? engineering(seconds, "s") : std::string("–");
                });
}

void broad_phase(const Stage& stage) {
    const Figures figures(stage);
    const auto fact = [](auto member) {
        return [member](const Run& run) {
            const BroadPhaseFacts& facts = run.session().world().statistics().broad_phase;
            return facts.*member > 0 ? whole(facts.*member) : std::string("–");
        };
    };
    figures.row("Kind", "How the engine finds what is near", [](const Run& run) {
        const std::string_view name = run.session().world().statistics().broad_phase.name;
        return name.empty() ? std::string("–") : std::string(name);
    });
    figures.row("Levels", "Depth of the tree", fact(&BroadPhaseFacts::levels));
    figures.row("Nodes", "Nodes of the tree", fact(&BroadPhaseFacts::nodes));
    figures.row("Leaves", "Leaves, or cells", fact(&BroadPhaseFacts::leaves));
    figures.row("Leaf size, mm", "Width and height of a leaf, mm", [](const Run& run) {
        const BroadPhaseFacts& facts = run.session().world().statistics().broad_phase;
        return facts.leaf_width > 0 ? whole(1000 * facts.leaf_width) + " × " + whole(1000 * facts.leaf_height)
                                    : std::string("–");
    });
    figures.row("Most in a leaf", "Shapes in the fullest leaf", fact(&BroadPhaseFacts::most_in_leaf));
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
