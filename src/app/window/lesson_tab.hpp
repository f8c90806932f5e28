#pragma once
/// The lessons: which there are, the open one's text, its question, and its claim, checked on demand.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/window/controls.hpp"
#include "app/window/markdown.hpp"
#include "app/window/stage.hpp"
#include "lab/lessons/claim.hpp"
#include "lab/lessons/lesson.hpp"

namespace flipside::app {

class Lessons {
  public:
    /// Puts the lesson on the stage. What it switches on there is switched off again by close(). Throws
    /// InputError.
    void open(const std::filesystem::path& file, Stage& stage, WindowControls& controls);
    /// The scene that is on the table stays.
    void close(WindowControls& controls);
    void answer(std::size_t answer) { answer_ = answer; }
    /// Makes the runs behind the claim.
    void check();

    [[nodiscard]] const std::optional<lab::Lesson>& lesson() const { return lesson_; }
    [[nodiscard]] const std::optional<std::size_t>& answered() const { return answer_; }
    [[nodiscard]] const std::optional<std::vector<lab::Verified>>& checked() const { return checked_; }
    /// The lessons there are, or what is wrong with them.
    [[nodiscard]] const std::vector<lab::Lesson>& all();
    /// The one so many places after the open one, or null.
    [[nodiscard]] const lab::Lesson* beside(std::ptrdiff_t places);

    void draw(Stage& stage, WindowControls& controls, ControlPlaces& places);

  private:
    void draw_offer(Stage& stage, WindowControls& controls, ControlPlaces& places);
    void draw_list(Stage& stage, WindowControls& controls, ControlPlaces& places);
    void draw_open(Stage& stage, WindowControls& controls, ControlPlaces& places);
    void draw_question(ControlPlaces& places);
    void draw_claim();
    void go_to(const lab::Lesson& lesson, Stage& stage, WindowControls& controls);

    std::vector<lab::Lesson> all_;
    bool looked_ = false;
    std::optional<lab::Lesson> lesson_;
    std::filesystem::path file_;
    std::vector<TextBlock> text_;
    std::optional<std::size_t> answer_;
    std::optional<std::vector<lab::Verified>> checked_;
    bool result_wanted_ = false;  ///< visible: the text is to be scrolled there
    std::string trouble_;
    Shows shows_before_;
    bool bar_before_ = false, paused_before_ = false;
    PlotChoice plots_before_{};
};

}  // namespace flipside::app
