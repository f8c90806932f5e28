#pragma once
/// What is on show: a scene, and one to four contenders' runs of it under the same script and controls, and
/// how far these are apart. Knows no screen.

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/play.hpp"
#include "app/window/divergence.hpp"
#include "lab/contenders/engines.hpp"
#include "lab/lessons/lesson.hpp"
#include "lab/replay/replay.hpp"

namespace flipside::app {

class Stage {
  public:
    static constexpr std::size_t most_contenders = 4;

    /// `settings` and `contenders` as in PlayOptions; without contenders, every engine but the reference
    /// takes part as it is, `engine` first. `dt`, s, for those that have none of their own; nothing: the
    /// scene's. Throws InputError.
    Stage(const std::string& scene, const std::string& engine, View view,
          const std::vector<std::string>& settings, const std::optional<std::filesystem::path>& script,
          const std::vector<std::string>& contenders = {}, std::optional<double> dt = {});

    /// Of contenders that are there already.
    Stage(std::shared_ptr<const Scene> scene, std::vector<lab::Contender> contenders, View view);

    /// Another scene from its start, with the contenders of before any lesson. The script belongs to the
    /// first scene and is dropped.
    void open(const std::string& scene);
    /// A lesson's scene with its contenders.
    void open(const lab::Lesson& lesson);
    /// A scene that was drawn, from its start, with the contenders as they are, or, of another name than the
    /// one on show, as it recommends them. Throws InputError, and changes nothing, where an engine refuses
    /// it.
    void take(const std::string& name, std::shared_ptr<const Scene> scene);
    /// The scene's file once more, from its start, with the contenders as they are. Throws InputError, and
    /// changes nothing, where it is no good.
    void reload();
    void restart();
    /// The single view shows the first contender, with the reference around its balls if that takes part.
    void set_view(View view);
    /// The contenders change places, the reference stays; all go on from the state of the first.
    void switch_engine();
    /// Whether the exact engine takes part; its run joins from the state of the lead. False where there is no
    /// room for it.
    bool show_reference(bool on);
    /// The reference, and any run that has halted, goes on from the state of the guide.
    void take_up();
    /// Whether there is such a run, and a guide.
    [[nodiscard]] bool can_take_up() const;
    /// Where take_up goes on from: the first run that has not halted and is not the reference, if any.
    [[nodiscard]] const Run* guide() const;
    void step() { static_cast<void>(step_within(dt_, std::numeric_limits<double>::infinity())); }
    /// A step in portions: works for about `seconds` of wall time, and is true once all runs have taken it.
    /// Until then all of them show what was before.
    [[nodiscard]] bool step_within(double seconds) { return step_within(dt_, seconds); }
    [[nodiscard]] bool under_way() const;
    /// In steps and one shorter one, so that it ends there exactly.
    void run_until(double end);
    /// What the player does, as far as each run's rules permit it; after the step that is under way.
    void press(const Control& control);
    void clear();
    /// What a hand does to the balls of all runs; after the step that is under way. A new ball has one number
    /// in all of them. False, and nothing, where a new ball has no room in one of them, or none has that
    /// ball.
    bool edit(const lab::BallEdit& edit);
    void set_gravity(bool on);

    /// What follows changes the contender of a run. Each throws InputError, and changes nothing, where that
    /// cannot be.
    /// Rebuilds the run's world from its state at once.
    void change_setting(std::size_t run, std::string_view name, double value);
    /// Its own step, s; see lab::common_step.
    void change_step(std::size_t run, double dt);
    /// The run goes on with that engine as the scene recommends it.
    void change_engine(std::size_t run, const Engine& engine);
    /// One more, like the last one, from its state.
    void add_contender();
    /// The last one stays.
    void remove_contender(std::size_t run);
    /// The run that all wait for, or that costs most per simulated second.
    [[nodiscard]] std::size_t slowest() const;

    /// The times that can be gone back to, of all runs on show, s.
    [[nodiscard]] double record_begin() const;
    [[nodiscard]] double record_end() const;
    /// All runs show the last recorded moment at or before `time`, as it was. Nothing happens in the middle
    /// of a step. Whatever is done next forgets what came after it.
    void go_to(double time);
    /// To the recorded moment before the one on show, or after it; false where there is none.
    bool step_back();
    bool step_forward();
    /// Whether the moment on show is not the last recorded one.
    [[nodiscard]] bool in_past() const { return in_past_; }

    [[nodiscard]] View view() const { return view_; }
    [[nodiscard]] std::vector<Run>& runs() { return runs_; }
    [[nodiscard]] const std::vector<Run>& runs() const { return runs_; }
    /// Of that name, which is on show.
    [[nodiscard]] const Run& run_named(std::string_view name) const;
    /// All that take part; in the single view not all of them are on show.
    [[nodiscard]] const std::vector<lab::Contender>& contenders() const { return contenders_; }
    [[nodiscard]] const Scene& scene() const { return *scene_; }
    [[nodiscard]] const std::string& scene_name() const { return name_; }
    /// Neither a lesson's scene nor one that was drawn and never saved, whose name is "".
    [[nodiscard]] bool is_from_file() const { return !is_lesson() && !name_.empty(); }
    /// Whether what is on show is a lesson's scene.
    [[nodiscard]] bool is_lesson() const { return before_lesson_.has_value(); }
    /// The longest of the contenders' steps, after which all of them meet, s.
    [[nodiscard]] double dt() const { return dt_; }
    /// Whether the runs on show make steps of different lengths: what a step costs cannot be compared then.
    [[nodiscard]] bool steps_differ() const;
    [[nodiscard]] double time() const { return lead().session().world().time(); }
    /// The first run that has not halted, or the first of all.
    [[nodiscard]] const Run& lead() const;
    [[nodiscard]] bool reference() const;
    /// The run of the reference that is on show, or null.
    [[nodiscard]] const Run* exact() const;
    [[nodiscard]] bool gravity() const { return gravity_; }
    [[nodiscard]] bool has_gravity() const { return !(original_->gravity == Vec2{}); }
    /// How often a scene was begun: another number, another game.
    [[nodiscard]] int games() const { return games_; }
    /// What was played on all runs on show, to be played again. Not in the middle of a step. Throws
    /// lab::Failure that says why where that cannot be.
    [[nodiscard]] lab::Replay game() const;
    /// All runs have come to one moment by other means than the above.
    void compare_runs();
    /// Of every two runs, since they last began in one state.
    [[nodiscard]] const std::vector<Divergence>& divergences() const { return divergences_; }

  private:
    /// Throws InputError, and changes nothing, where the scene does not suit the line-up.
    void show_scene(std::string name, std::shared_ptr<const Scene> scene,
                    std::vector<lab::ContenderRequest> line_up);
    void start();
    /// `original_`, with or without gravity.
    void set_scene();
    /// Brings in the runs that the view asks for, and takes out the others.
    void arrange();
    [[nodiscard]] std::vector<const lab::Contender*> on_show() const;
    [[nodiscard]] Run* find_run(std::string_view name);
    [[nodiscard]] std::size_t place_of(const Run& run) const;
    /// A run that goes on from the state of another, score and all.
    [[nodiscard]] Run taken_up(const Run& from, const lab::Contender& contender) const;
    /// The run goes on so; from the state of the lead if it has halted.
    void change(Run& run, const lab::Contender& contender);
    /// The contender at that place is another one from now on, and its run goes on so.
    void replace(std::size_t place, const lab::Contender& contender);
    /// What was under way in steps of another length is taken back.
    void set_step(double dt);
    /// Forgets how this run came apart from others.
    void compare_anew(std::string_view name);
    /// Whatever is done to the runs begins with this: the future of a moment of the past is forgotten.
    void go_on_from_here();
    /// Every two of the runs on show are compared, and no others.
    void pair_up();
    [[nodiscard]] bool step_within(double span, double seconds);

    std::string name_;
    std::shared_ptr<const Scene> original_;    ///< as in the file
    std::shared_ptr<const Scene> scene_;       ///< as it is run: gravity may be off
    std::vector<lab::SettingChange> changes_;  ///< for all scenes and contenders
    std::vector<lab::ContenderRequest> line_up_;
    struct Before {
        std::vector<lab::ContenderRequest> line_up;
        View view;
    };
    std::optional<Before> before_lesson_;
    std::vector<lab::Contender> contenders_;  ///< one for each of the line-up
    std::optional<double> asked_dt_;          ///< s
    std::optional<std::filesystem::path> script_file_;
    Script script_;
    View view_;
    std::vector<Run> runs_;
    double dt_ = lab::default_step;
    bool gravity_ = true;
    bool in_past_ = false;
    int games_ = 0;
    std::vector<Divergence> divergences_;
    std::vector<Control> pressed_;      ///< during the step that is under way
    std::vector<lab::BallEdit> edits_;  ///< likewise
};

[[nodiscard]] bool is_reference(const Engine& engine);

}  // namespace flipside::app
