#include "app/window/step_bar.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "app/window/contender_colour.hpp"
#include "app/window/panel_parts.hpp"
#include "app/window/words.hpp"
#include "world/printable.hpp"
#include "world/trace_units.hpp"

namespace flipside::app {

namespace {

/// What stands before a value; some say themselves what they are: "free flight", "impact".
std::string titled(std::string_view name) {
    if (name == "way" || name == "answer") return "";
    return name == "turn" ? "pair " : with_spaces(name) + " ";  // pairs are looked at in turn
}

/// Lengths and impulses with the prefix that suits, as everywhere else in the window.
std::string measured(std::string_view name, const TraceValue& value) {
    const std::string unit(unit_of(name, value));
    const auto* number = std::get_if<double>(&value);
    if (number != nullptr && (unit == "m" || unit == "N·s")) return engineering(*number, unit);
    const bool of_words = std::holds_alternative<std::string>(value);
    return of_words ? in_brief(value) : with_minus_signs(with_its_unit(name, value));
}

struct StepBar {
    Stage& stage;
    Microscope& microscope;
    ControlPlaces& places;

    bool chip(const std::string& words, bool current, sf::Color color) const {
        ImGui::PushStyleColor(ImGuiCol_Button,
                              imgui_color(current ? blend(colour::rule, color, 0.45) : colour::rule));
        const bool pressed = ImGui::Button(words.c_str());
        ImGui::PopStyleColor();
        return pressed;
    }
    [[nodiscard]] static double width_of(const std::string& words) {
        return width_of_text(words) + 2 * ImGui::GetStyle().FramePadding.x + ImGui::GetStyle().ItemSpacing.x;
    }
    void engines() const {
        for (std::size_t i = 0; i < stage.runs().size(); ++i) {
            const std::string& name = stage.runs()[i].name();
            const sf::Color color = colour_of(stage.runs()[i]);
            const bool current = i == microscope.run();
            ImGui::PushStyleColor(ImGuiCol_Text, imgui_color(current ? colour::text : color));
            if (chip(name + "##inside", current, color)) microscope.look_at(i);
            ImGui::PopStyleColor();
            tooltip("Look into this engine's step (C for the next one)");
            note(places, "inside " + name);
            ImGui::SameLine();
        }
        const std::string where = "stage " + std::to_string(microscope.at() + 1) + " of " +
                                  std::to_string(microscope.stages().size());
        if (ImGui::GetContentRegionAvail().x < width_of(where)) ImGui::NewLine();
        wrapped(where, colour::quiet);
        // As many of the keys as have room, the first ones first.
        constexpr std::pair<const char*, const char*> keys[] = {
            {".", "next"}, {",", "back"}, {"[ ]", "items"}, {"Shift .", "whole step"}, {"I", "close"}};
        for (const auto& [key, words] : keys) {
            ImGui::SameLine(0, 2 * ImGui::GetStyle().ItemSpacing.x);
            if (ImGui::GetContentRegionAvail().x < width_of(key) + width_of(words)) {
                ImGui::NewLine();
                break;
            }
            wrapped(key, colour::text);
            ImGui::SameLine();
            wrapped(words, colour::quiet);
        }
    }
    /// All of them in a line: as many as have room with their names, those around the current one first, and
    /// the others with their numbers. Where not even numbers have room, those around it.
    void stages() const {
        const auto& all = microscope.stages();
        const sf::Color color = colour_of(stage.runs()[microscope.run()]);
        const std::size_t at = microscope.at();
        const auto words = [&](std::size_t i, bool named) {
            return std::to_string(i + 1) + (named ? "  " + all[i].name : "");
        };
        const auto width = [&](std::size_t i, bool named) { return width_of(words(i, named)); };
        double room = ImGui::GetContentRegionAvail().x - width(at, true);
        const auto takes = [&room](double more) {
            const bool fits = more <= room;
            if (fits) room -= more;
            return fits;
        };
        std::size_t first = at, end = at + 1;
        for (bool after = true, before = true; after || before;) {
            after = end < all.size() && takes(width(end, false));
            end += after ? 1 : 0;
            before = first > 0 && takes(width(first - 1, false));
            first -= before ? 1 : 0;
        }
        std::vector<bool> named(all.size(), false);
        named[at] = true;
        const auto has_name = [&](std::size_t i) {
            const bool fits = takes(width(i, true) - width(i, false));
            named[i] = fits;
            return fits;
        };
        for (std::size_t away = 1; away < all.size(); ++away) {
            if (at + away < end && !has_name(at + away)) break;
            if (at >= first + away && !has_name(at - away)) break;
        }
        for (std::size_t i = first; i < end; ++i) {
            if (i > first) ImGui::SameLine();
            ImGui::PushID(static_cast<int>(i));
            if (chip(words(i, named[i]), i == at, color)) microscope.to_stage(i);
            ImGui::PopID();
            tooltip(all[i].name + ": " + all[i].says);
            note(places, "stage " + std::to_string(i + 1));
        }
    }
    /// Of the rest of the bar, as whole lines: none is seen cut in half.
    [[nodiscard]] static double height_of_lines() {
        const double line = ImGui::GetTextLineHeightWithSpacing();
        return line * std::max(1.0, std::floor(ImGui::GetContentRegionAvail().y / line));
    }
    void items(double width) const {
        const TraceStage& now = microscope.stage();
        ImGui::BeginChild("items", imgui_vector(width, height_of_lines()));
        const float row = ImGui::GetTextLineHeightWithSpacing();
        if (microscope.to_be_shown())
            ImGui::SetScrollY(row * static_cast<float>(microscope.item()) - 0.4F * ImGui::GetWindowHeight());
        ImGuiListClipper clipper;
        clipper.Begin(static_cast<int>(now.items.size()));
        while (clipper.Step())
            for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
                const auto place = static_cast<std::size_t>(i);
                ImGui::PushID(i);
                const std::string line = in_one_line(now.items[place]);
                const std::string shown = cut(line, ImGui::GetContentRegionAvail().x);
                if (ImGui::Selectable(shown.c_str(), place == microscope.item())) microscope.pick(place);
                if (shown != line) tooltip(line);
                note(places, "item " + std::to_string(i + 1));
                ImGui::PopID();
            }
        ImGui::EndChild();
    }
    void picked() const {
        ImGui::BeginChild("picked", imgui_vector(0, height_of_lines()));
        const TraceStage& now = microscope.stage();
        if (microscope.item() < now.items.size()) {
            const TraceItem& item = now.items[microscope.item()];
            for (const char* name : {"formula", "filled"})
                if (const TraceValue* value = item.find(name))
                    wrapped(with_minus_signs(in_brief(*value)), colour::lit);
            for (const auto& [name, value] : item.fields)
                if (name != "formula" && name != "filled")
                    wrapped(titled(name) + measured(name, value), colour::text);
        }
        wrapped(now.where, colour::quiet);
        ImGui::EndChild();
    }
};

}  // namespace

std::string in_one_line(const TraceItem& item) {
    std::string line = item.kind;
    bool first = true;
    for (const auto& [name, value] : item.fields) {
        constexpr std::string_view told[] = {
            "ball",   "other_ball", "part",  "of",      "time",      "event",  "separation", "overlap",
            "depth",  "answer",     "way",   "next",    "next_time", "level",  "cell",       "parent",
            "listed", "decides",    "speed", "impulse", "residual",  "levels", "leaves"};
        if (std::ranges::find(told, name) != std::end(told))
            // Of a ball "ball 0" says all that "ball  ball 0" does.
            line += (first && name == item.kind ? " " : "  " + titled(name)) + measured(name, value);
        first = false;
    }
    return line;
}

void draw_step_bar(const Rect& place, Stage& stage, Microscope& microscope, ControlPlaces& places) {
    ImGui::SetNextWindowPos(imgui_vector(place.x, place.y));
    ImGui::SetNextWindowSize(imgui_vector(place.width, place.height));
    ImGui::Begin("step bar", nullptr, docked);
    const StepBar bar{stage, microscope, places};
    if (!microscope.shows(stage)) {
        wrapped(
            "Inside a step: the full stop (.) takes the next one and stops at its first stage; I closes "
            "this.",
            colour::text);
        ImGui::End();
        return;
    }
    bar.engines();
    bar.stages();
    wrapped(printable(microscope.stage().says), colour::text);
    const double room = ImGui::GetContentRegionAvail().x;
    bar.items(std::floor(0.55 * room));
    ImGui::SameLine();
    bar.picked();
    ImGui::End();
}

}  // namespace flipside::app
