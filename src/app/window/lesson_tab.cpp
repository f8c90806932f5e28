#include "app/window/lesson_tab.hpp"

#include <algorithm>
#include <utility>

#include "app/window/claim_words.hpp"
#include "app/window/panel_parts.hpp"
#include "lab/process/failure.hpp"
#include "world/input_error.hpp"
#include "world/printable.hpp"
#include "world/refusal.hpp"

namespace flipside::app {

namespace {

void write(std::string_view words, sf::Color color) {
    wrapped(printable(words), color);
}

/// A button as wide as the column that wraps its words.
bool wide_button(const std::string& words, ControlPlaces& places) {
    const ImVec2 padding = ImGui::GetStyle().FramePadding, corner = ImGui::GetCursorScreenPos();
    const float width = ImGui::GetContentRegionAvail().x;
    const std::string shown = broken(words, width - 2 * padding.x);
    const float height = ImGui::CalcTextSize(shown.c_str()).y + 2 * padding.y;
    const bool pressed = ImGui::Button(("##" + words).c_str(), {width, height});
    note(places, words);
    ImGui::GetWindowDrawList()->AddText({corner.x + padding.x, corner.y + padding.y},
                                        ImGui::GetColorU32(ImGuiCol_Text), shown.c_str());
    return pressed;
}

}  // namespace

void Lessons::open(const std::filesystem::path& file, Stage& stage, WindowControls& controls) {
    lab::Lesson lesson = lab::load_lesson(file);
    stage.open(lesson);
    if (!lesson_) {
        shows_before_ = controls.look.shows;
        bar_before_ = controls.bar_open;
        paused_before_ = controls.paused;
        plots_before_ = controls.plots;
    }
    controls.look.shows = shows_before_;
    for (const std::string& name : lesson.show)
        controls.look.shows.set(static_cast<std::size_t>(
            std::ranges::find(show_specs, name, &ShowSpec::name) - std::begin(show_specs)));
    controls.plots = lesson.plots.empty() ? plots_before_ : plots_named(lesson.plots);
    controls.bar_open = lesson.inside;
    controls.paused = lesson.paused;
    controls.speed = lesson.speed;
    controls.notice.clear();
    text_ = parse_markdown(lesson.text);
    lesson_ = std::move(lesson);
    file_ = file;
    answer_.reset();
    checked_.reset();
    trouble_.clear();
}

void Lessons::close(WindowControls& controls) {
    if (!lesson_) return;
    controls.look.shows = shows_before_;
    controls.bar_open = bar_before_;
    controls.plots = plots_before_;
    controls.paused = paused_before_;
    controls.speed = 1;
    lesson_.reset();
}

void Lessons::check() {
    try {
        checked_ = lab::verify(lesson_->claim, lab::measure(lesson_->claim), file_.string());
        result_wanted_ = true;
    } catch (const Refusal& refusal) {
        trouble_ = refusal.what();
    } catch (const std::runtime_error& error) {
        trouble_ = error.what();
    }
}

const std::vector<lab::Lesson>& Lessons::all() {
    if (looked_) return all_;
    looked_ = true;
    try {
        for (const auto& file : lab::lesson_files()) all_.push_back(lab::load_lesson(file));
    } catch (const InputError& error) {
        trouble_ = error.what();
    }
    return all_;
}

const lab::Lesson* Lessons::beside(std::ptrdiff_t places) {
    const auto at = std::ranges::find(all(), lesson_->name, &lab::Lesson::name);
    const std::ptrdiff_t other = at - all_.begin() + places;
    const bool there = at != all_.end() && other >= 0 && other < std::ssize(all_);
    return there ? &all_[static_cast<std::size_t>(other)] : nullptr;
}

void Lessons::go_to(const lab::Lesson& lesson, Stage& stage, WindowControls& controls) {
    try {
        open(lab::lesson_file(lesson.name), stage, controls);
    } catch (const std::runtime_error& error) {
        trouble_ = error.what();
    }
}

void Lessons::draw(Stage& stage, WindowControls& controls, ControlPlaces& places) {
    if (!trouble_.empty()) write(trouble_, colour::warning);
    if (lesson_)
        draw_open(stage, controls, places);
    else if (controls.newcomer)
        draw_offer(stage, controls, places);
    else
        draw_list(stage, controls, places);
}

void Lessons::draw_offer(Stage& stage, WindowControls& controls, ControlPlaces& places) {
    write("New here?", colour::lit);
    write(
        "One pinball table, and engines that compute it in different ways. Lesson 1 opens up a single step "
        "of one of them: five minutes, with something to do.",
        colour::text);
    const auto choice = [&](const std::string& words) {
        const bool chosen = wide_button(words, places);
        if (chosen) controls.newcomer = false;
        return chosen;
    };
    if (choice("Start lesson 1") && !all().empty()) return go_to(lab::Lesson(all().front()), stage, controls);
    if (choice("Just play")) controls.table_wanted = true;
    choice("All lessons");
}

void Lessons::draw_list(Stage& stage, WindowControls& controls, ControlPlaces& places) {
    write(
        "A course in what happens inside an engine. Each lesson is one idea, with something to do and a "
        "question.",
        colour::quiet);
    // Opening one may not change the list that is gone through.
    const lab::Lesson* chosen = nullptr;
    for (const lab::Lesson& lesson : all()) {
        if (wide_button(printable(lesson.name.substr(0, 2) + "  " + lesson.title), places)) chosen = &lesson;
        write(lesson.idea, colour::quiet);
    }
    if (chosen) go_to(*chosen, stage, controls);
}

/// The buttons stay visible; the text between them is scrolled.
void Lessons::draw_open(Stage& stage, WindowControls& controls, ControlPlaces& places) {
    const auto pressed = [&](const char* words) {
        const bool now = ImGui::Button(words);
        note(places, words);
        return now;
    };
    const bool leaves = pressed("All lessons");
    ImGui::SameLine();
    const bool again = pressed("Begin again");
    const lab::Lesson* chosen = nullptr;
    for (const auto& [words, way] : {std::pair("Back", -1), std::pair("Next", 1)})
        if (const lab::Lesson* other = beside(way)) {
            ImGui::SameLine();
            if (pressed(words)) chosen = other;
            tooltip(other->title);
        }
    const float least = 6 * ImGui::GetTextLineHeightWithSpacing(),
                room = ImGui::GetContentRegionAvail().y - ImGui::GetFrameHeightWithSpacing();
    ImGui::BeginChild(lesson_->name.c_str(), {0, std::max(least, room)}, false,
                      ImGuiWindowFlags_NavFlattened);
    draw_markdown(text_);
    if (!lesson_->task.empty()) {
        write("Do", colour::quiet);
        write(lesson_->task, colour::lit);
        ImGui::Dummy({0, 4});
    }
    if (lesson_->question) draw_question(places);
    draw_claim();
    ImGui::EndChild();
    if (pressed("Check it")) check();
    tooltip("Makes the runs behind what the lesson claims, now and here");
    if (leaves) return close(controls);
    if (chosen) return go_to(lab::Lesson(*chosen), stage, controls);
    if (again) go_to(lab::Lesson(*lesson_), stage, controls);
}

void Lessons::draw_question(ControlPlaces& places) {
    const lab::Question& question = *lesson_->question;
    write("Question", colour::quiet);
    write(question.asks, colour::text);
    for (std::size_t i = 0; i < question.answers.size(); ++i) {
        const bool chosen = answer_ == i, right = i == question.right;
        const sf::Color color = !answer_ ? colour::rule
                                : right  ? blend(colour::rule, colour::text, 0.25)
                                : chosen ? blend(colour::rule, colour::warning, 0.7)
                                         : colour::rule;
        ImGui::PushStyleColor(ImGuiCol_Button, imgui_color(color));
        if (wide_button(printable(question.answers[i]), places)) answer(i);
        if (answer_ && (right || chosen)) {
            const float size = ImGui::GetFontSize();
            const ImVec2 end = ImGui::GetItemRectMax();
            draw_verdict(imgui_vector(end.x - 1.3F * size, end.y - 1.2F * size), right);
        }
        ImGui::PopStyleColor();
    }
    if (answer_) write((*answer_ == question.right ? "Right. " : "No. ") + question.because, colour::text);
    ImGui::Dummy({0, 4});
}

void Lessons::draw_claim() {
    write("What this lesson claims", colour::quiet);
    write(lesson_->claim.says, colour::text);
    if (!checked_) return;
    const bool one_run = lesson_->claim.runs.size() == 1;
    ImGui::Dummy({0, 4});
    write(std::ranges::all_of(*checked_, &lab::Verified::holds) ? "Checked now: it holds"
                                                                : "Checked now: it does not hold",
          colour::lit);
    for (const lab::Verified& one : *checked_) {
        verdict_mark(one.holds);
        ImGui::SameLine();
        ImGui::BeginGroup();
        write((one.holds ? "" : "not so: ") + claim_in_words(one.statement, one_run),
              one.holds ? colour::text : colour::warning);
        for (const std::string& figure : measured_in_words(one, one_run)) write(figure, colour::quiet);
        ImGui::EndGroup();
    }
    if (std::exchange(result_wanted_, false)) ImGui::SetScrollHereY(1);
}

}  // namespace flipside::app
