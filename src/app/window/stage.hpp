#pragma once
/// What is on show: a scene, one or more runs of it under the same script and controls and the same step,
/// each on another engine, and how far these are apart. Knows no screen.

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "app/play.hpp"
#include "app/window/divergence.hpp"
#include "lab/engines.hpp"
#include "lab/lessons/lesson.hpp"

namespace flipside::app {

class Stage {
  public:
    /// `settings` as in PlayOptions. Throws InputError.
    Stage(const std::string& scene, const std::string& engine, View view,
          const std::vector<std::string>& settings, const std::optional<std::filesystem::path>& script);

    /// Another scene from its start. The script belongs to the first scene and is dropped.
    void open(const std::string& scene);
    /// A lesson's scene on its engines, with its settings.
    void open(const lab::Lesson& lesson);
    void restart();
    void set_view(View view);
    /// Every run goes on with the next engine.
    void switch_engine();
    /// Whether the exact engine takes part. In the single view it takes over the running balls, or hands them
    /// on; in the others its run joins, from the state of the first, or leaves.
    void show_reference(bool on);
    /// The reference, and any run that has halted, goes on from the state of the guide.
    void take_up();
    /// Where take_up goes on from: the first run that has not halted and is not the reference, if any.
    [[nodiscard]] const Run* guide() const;
    void step() { static_cast<void>(step_within(dt_, std::numeric_limits<double>::infinity())); }
    /// A step in portions: works for about `seconds` of wall time, and is true once all runs have taken it.
    /// Until then all of them show what was before.
    [[nodiscard]] bool step_within(double seconds) { return step_within(dt_, seconds); }
    [[nodiscard]] bool under_way() const;
    /// In steps of dt and one shorter one, so that it ends there exactly.
    void run_until(double end, double dt);
    /// What the player does, as far as each run's rules permit it; after the step that is under way.
    void press(const Control& control);
    void clear();
    void set_gravity(bool on);
    /// Rebuilds the run's world from its state at once. Throws InputError, and changes nothing, where the
    /// engine refuses it.
    void change_setting(std::size_t run, std::string_view name, double value);

    [[nodiscard]] View view() const { return view_; }
    [[nodiscard]] std::vector<Run>& runs() { return runs_; }
    [[nodiscard]] const std::vector<Run>& runs() const { return runs_; }
    [[nodiscard]] const Scene& scene() const { return *scene_; }
    [[nodiscard]] const std::string& scene_name() const { return name_; }
    [[nodiscard]] double dt() const { return dt_; }
    [[nodiscard]] double time() const { return lead().session().world().time(); }
    /// The first run that has not halted, or the first of all.
    [[nodiscard]] const Run& lead() const;
    [[nodiscard]] bool reference() const { return reference_; }
    [[nodiscard]] bool gravity() const { return gravity_; }
    [[nodiscard]] bool has_gravity() const { return !(original_->gravity == Vec2{}); }
    /// Of every two runs, since they last began in one state.
    [[nodiscard]] const std::vector<Divergence>& divergences() const { return divergences_; }

  private:
    void load(const std::string& scene);
    void start();
    /// The engines that take part, in the order of the list, round from `first`.
    [[nodiscard]] std::vector<const Engine*> line_up(const Engine& first) const;
    /// Brings in the runs that the view and the reference's switch ask for, and takes out the others.
    void arrange();
    [[nodiscard]] Run* run_on(const Engine& engine);
    /// A run that goes on from the state of another, score and all.
    [[nodiscard]] Run taken_up(const Run& from, const Engine& engine, const Settings& settings) const;
    /// The run goes on so; from the state of the lead if it has halted.
    void change(Run& run, const Engine& engine, const Settings& settings);
    /// Forgets how runs on this engine came apart from others.
    void compare_anew(const Engine& engine);
    /// Every two of the runs on show are compared, and no others.
    void pair_up();
    [[nodiscard]] const Settings& settings_of(const Engine& engine);
    [[nodiscard]] bool step_within(double dt, double seconds);

    std::string name_;
    std::shared_ptr<const Scene> original_;                     ///< as in the file
    std::shared_ptr<const Scene> scene_;                        ///< as it is run: gravity may be off
    std::vector<lab::SettingChange> asked_;                     ///< for all scenes
    std::vector<lab::SettingChange> changes_;                   ///< for this one
    std::vector<std::pair<const Engine*, Settings>> settings_;  ///< of every engine used so far
    Script script_;
    const Engine* engine_;  ///< of the first run
    View view_;
    std::vector<Run> runs_;
    double dt_ = 1.0 / 60;
    bool gravity_ = true;
    bool reference_ = false;
    std::vector<Divergence> divergences_;
    std::vector<Control> pressed_;  ///< during the step that is under way
};

[[nodiscard]] bool is_reference(const Engine& engine);

}  // namespace flipside::app
