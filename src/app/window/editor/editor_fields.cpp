#include "app/window/editor/editor_fields.hpp"

#include <algorithm>

#include "app/window/editor/field_set.hpp"
#include "app/window/editor/material_fields.hpp"
#include "app/window/panel_parts.hpp"

namespace flipside::app {

namespace {

constexpr double mm = 1000, g = 1000;  ///< in a metre, in a kilogram

FieldSpec place_spec(const char* label, const char* meaning) {
    return {label, meaning, "mm", mm};
}

FieldSpec length_spec(const char* label, const char* meaning) {
    return {label, meaning, "mm", mm, 1e-6, 1e9};
}

FieldSpec degrees_spec(const char* label, const char* meaning) {
    return {label, meaning, "°", 1, -36000, 36000};
}

FieldSpec rate_spec(const char* label, const char* meaning, double least) {
    return {label, meaning, "rad/s", 1, least, 1e6};
}

/// Of a polygon or polyline.
void corner_fields(const FieldSet& fields, const lab::Path& points) {
    constexpr std::size_t most = 32;  // more are a drawing's, not a hand's
    const std::size_t count = fields.find(points)->size();
    for (std::size_t i = 0; i < std::min(count, most); ++i) {
        const std::string name = "Corner " + std::to_string(i + 1);
        fields.pair(points / std::to_string(i), place_spec(name.c_str(), "x and y of this corner, mm"));
    }
}

void shape_fields(const FieldSet& fields, const lab::Path& shape) {
    const std::string type = *fields.find(shape / "type");
    if (type == "compound") {
        ImGui::TextDisabled("Several shapes as one; pull at their ends.");
        return;
    }
    if (type == "point") fields.pair(shape / "at", place_spec("At", "x and y, mm"));
    if (type == "segment" || type == "capsule" || type == "gate") {
        fields.pair(shape / "a", place_spec("From", "x and y of one end, mm"));
        fields.pair(shape / "b", place_spec("To", "x and y of the other end, mm"));
    }
    if (type == "circle" || type == "arc") fields.pair(shape / "center", place_spec("Centre", "x and y, mm"));
    if (type == "circle" || type == "arc" || type == "capsule")
        fields.number(shape / "radius", length_spec("Radius", "mm"));
    if (type == "arc") {
        fields.number(shape / "from_deg", degrees_spec("Begins at", "Degrees, anticlockwise from the right"));
        fields.number(shape / "to_deg",
                      degrees_spec("Ends at", "Degrees, anticlockwise; above its beginning, by at most 360"));
    }
    if (type == "polygon" || type == "polyline") corner_fields(fields, shape / "points");
    if (type == "polyline")
        fields.toggle(shape / "closed", "Closed", "The last corner is joined to the first");
    if (type == "flipper") {
        fields.pair(shape / "pivot", place_spec("Pivot", "x and y, mm"));
        fields.number(shape / "length", length_spec("Length", "From pivot to the middle of the tip, mm"));
        fields.number(shape / "base_radius", length_spec("Base radius", "About the pivot, mm"));
        fields.number(shape / "tip_radius", length_spec("Tip radius", "mm"));
        fields.number(shape / "rest_deg", degrees_spec("Rests at", "Direction from pivot to tip, degrees"));
    }
}

/// What moves the part: nothing, a turn, or, of a flipper, its button.
void motion_chooser(Editor& editor, const FieldSet& fields, ControlPlaces& places, const lab::Path& part) {
    const lab::OrderedJson* motion = fields.find(part / "motion");
    const bool flipper = *fields.find(part / "shape" / "type") == "flipper";
    const std::string now = motion == nullptr ? "still" : motion->at("type") == "turn" ? "turns" : "flips";
    label("Motion", "Still, turning about a pivot, or, of a flipper, raised by its button");
    if (!ImGui::BeginCombo("##motion", now.c_str())) return note(places, "Motion");
    const auto choose = [&](const char* words, const auto& set) {
        if (ImGui::Selectable(words, now == words) && now != words) {
            set();
            editor.draft().end_step();
        }
        note(places, std::string("motion ") + words);
    };
    choose("still", [&] {
        lab::OrderedJson still = *fields.find(part);
        still.erase("motion");
        editor.draft().set(part, still);
    });
    choose("turns", [&] {
        const Vec2 about = lab::middle_of(*fields.find(part));
        editor.draft().set(part / "motion", {{"type", "turn"}, {"pivot", lab::to_pair(about)}, {"rate", 2}});
    });
    if (flipper)
        choose("flips", [&] {
            const double rest = *fields.find(part / "shape" / "rest_deg");
            editor.draft().set(part / "motion",
                               {{"type", "flip"},
                                {"side", std::abs(rest) <= 90 ? "left" : "right"},
                                {"raised_deg", lab::number(rest + (std::abs(rest) <= 90 ? 50 : -50))},
                                {"up_rate", 40},
                                {"down_rate", 20}});
        });
    ImGui::EndCombo();
}

void motion_fields(Editor& editor, const FieldSet& fields, ControlPlaces& places, const lab::Path& part) {
    motion_chooser(editor, fields, places, part);
    const lab::Path path = part / "motion";
    const lab::OrderedJson* motion = fields.find(path);
    if (motion == nullptr) return;
    if (motion->at("type") == "turn") {
        fields.pair(path / "pivot", place_spec("Turns about", "x and y, mm"));
        fields.number(path / "rate", rate_spec("Rate", "Anticlockwise, rad/s", -1e6));
        fields.toggle(path / "always", "Always", "From the start, and not only while Rotate is on");
        return;
    }
    label("Button", "Which flipper button raises it");
    bool left = motion->at("side") == "left";
    const auto side = [&](const char* words, bool is) {
        if (ImGui::RadioButton(words, left == is) && left != is) {
            editor.draft().set(path / "side", words);
            editor.draft().end_step();
        }
        note(places, words);
    };
    side("left", true);
    ImGui::SameLine();
    side("right", false);
    fields.number(path / "raised_deg", degrees_spec("Raised to", "Direction from pivot to tip, degrees"));
    fields.number(path / "up_rate", rate_spec("Up rate", "rad/s", 1e-6));
    fields.number(path / "down_rate", rate_spec("Down rate", "rad/s", 1e-6));
}

void part_fields(Editor& editor, const FieldSet& fields, ControlPlaces& places) {
    const lab::Path part = path_of(editor.selected());
    std::string name = *fields.find(part / "name");
    if (fields.typed_text("Name", "Unique; no commas or quotes. Rules that name it follow", name, 100) &&
        !name.empty())
        editor.draft().rename(editor.selected().index, name);
    material_fields(editor, fields, places, part);
    const bool gate = *fields.find(part / "shape" / "type") == "gate";
    if (region("Shape")) {
        shape_fields(fields, part / "shape");
        if (gate && ImGui::Button("Turn the way round")) {
            const Vec2 normal = lab::vector_of(*fields.find(part / "shape" / "normal"));
            editor.draft().set(part / "shape" / "normal", lab::to_pair(-normal));
            editor.draft().end_step();
        }
    }
    if (!gate && region("Kind and motion")) {
        fields.toggle(part / "sensor", "Sensor", "Balls pass over it; it reports them");
        ImGui::SameLine();
        fields.toggle(part / "target", "Drop target", "Gone after a hit until it is raised again");
        motion_fields(editor, fields, places, part);
    }
    if (region("Layers", false)) layer_fields(editor, fields, places, part);
}

void ball_fields(Editor& editor, const FieldSet& fields, ControlPlaces& places) {
    const lab::Path ball = path_of(editor.selected());
    material_fields(editor, fields, places, ball);
    if (!region("Place and size")) return;
    fields.pair(ball / "position", place_spec("Position", "x and y at the start, mm"));
    fields.pair(ball / "velocity", {"Velocity", "x and y at the start, m/s", "m/s"});
    fields.number(ball / "spin", rate_spec("Spin", "Anticlockwise, rad/s", -1e6));
    fields.number(ball / "radius", length_spec("Radius", "mm"));
    fields.number(ball / "mass", {"Mass", "g", "g", g, 1e-9, 1e9});
    if (region("Layers", false)) layer_fields(editor, fields, places, ball);
}

void launcher_fields(Editor& editor, const FieldSet& fields, ControlPlaces& places) {
    const lab::Path launcher{"launcher"};
    fields.pair(launcher / "position", place_spec("Position", "x and y, mm"));
    fields.number(launcher / "direction_deg", degrees_spec("Direction", "Of the launch; 90 is up"));
    fields.pair(launcher / "speed", {"Speed", "Slowest and fastest, m/s", "m/s", 1, 0, 1e6});
    fields.toggle(launcher / "plunger", "Plunger",
                  "A ball that lies here already is fired instead of a new one added");
    const lab::Path ball = launcher / "ball";
    fields.number(ball / "radius", length_spec("Ball radius", "mm"));
    fields.number(ball / "mass", {"Ball mass", "g", "g", g, 1e-9, 1e9});
    material_fields(editor, fields, places, ball);
}

/// Of the table itself, while nothing is picked.
void table_fields(const FieldSet& fields) {
    fields.text({"name"}, "Name", "Of the scene", 100, true);
    fields.text({"about"}, "About", "What it shows, in a sentence", 2000);
    if (fields.find({"bounds"}) != nullptr) {
        fields.pair({"bounds", "min"},
                    place_spec("Lower left", "Of the bounds: a ball that leaves them is lost"));
        fields.pair({"bounds", "max"},
                    place_spec("Upper right", "Of the bounds: a ball that leaves them is lost"));
    }
    fields.pair({"gravity"},
                {"Gravity", "x and y, m/s²; a slope of 6.5° gives 1.11 along the table", "m/s²"});
    fields.number({"damping"}, {"Damping", "Drag on moving balls, 1/s", "1/s", 1, 0, 1e9});
    fields.number({"rest_speed"},
                  {"Rest speed", "A slower approach does not bounce, mm/s", "mm/s", mm, 0, 1e9, 0.01});
}

/// What "generate" in the file makes is not listed there one by one.
void generated_note(const lab::Draft& draft, ControlPlaces& places) {
    const std::size_t balls = draft.scene()->balls.size() - draft.sketch().balls.size();
    const std::size_t parts = draft.scene()->parts.size() - draft.sketch().parts.size();
    if (draft.problem() || balls + parts == 0) return;
    wrapped(std::to_string(balls) + " balls and " + std::to_string(parts) +
            " parts, drawn pale, are generated. They cannot be picked: their number and size are under "
            "\"generate\" in the file.");
    note(places, "generated");
}

/// Of several things there are no fields.
void several_things(const Editor& editor, ControlPlaces& places) {
    ImGui::Spacing();
    ImGui::PushFont(ImGui::GetIO().Fonts->Fonts[1]);
    ImGui::Text("%zu things", editor.selection().size());
    ImGui::PopFont();
    wrapped("They are moved, copied and deleted together. Shift and a click picks one more, or one less.");
    note(places, "several things");
}

}  // namespace

void draw_properties(Editor& editor, ControlPlaces& places) {
    if (editor.selection().size() > 1) return several_things(editor, places);
    // The fields of one thing are not those of another, which would get what was typed for the first.
    const lab::Item picked = editor.selected();
    ImGui::PushID(static_cast<int>(picked.index) * 4 + static_cast<int>(picked.kind));
    const FieldSet fields(editor, places);
    ImGui::Spacing();
    ImGui::PushFont(ImGui::GetIO().Fonts->Fonts[1]);
    const char* titles[] = {"Part", "Ball", "Launcher", "Table"};
    ImGui::TextUnformatted(titles[static_cast<int>(picked.kind)]);
    ImGui::PopFont();
    if (picked.kind == lab::Item::Kind::bounds) {
        table_fields(fields);
        generated_note(editor.draft(), places);
    } else if (picked.kind == lab::Item::Kind::ball)
        ball_fields(editor, fields, places);
    else if (picked.kind == lab::Item::Kind::launcher)
        launcher_fields(editor, fields, places);
    else
        part_fields(editor, fields, places);
    ImGui::PopID();
}

}  // namespace flipside::app
