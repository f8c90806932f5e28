#pragma once
/// What is on show: a scene, one or two runs of it under the same script and controls and the same step,
/// and how far these are apart. Knows no screen.

#include <optional>
#include <string>
#include <vector>

#include "app/play.hpp"
#include "app/window/run.hpp"
#include "lab/engines.hpp"

namespace flipside::app {

/// The first time the two runs had a ball more than a radius apart.
struct Parting {
    double time = 0;  ///< s
    BallNumber ball = 0;
    std::string on;  ///< what that ball had hit last; empty if nothing
};

class Stage {
  public:
    /// `settings` as in PlayOptions. Throws InputError.
    Stage(const std::string& scene, const std::string& engine, View view,
          const std::vector<std::string>& settings, const std::optional<std::filesystem::path>& script);

    /// Another scene from its start. The script belongs to the first scene and is dropped.
    void open(const std::string& scene);
    void restart();
    void set_view(View view);
    /// The next engine takes over the running balls; with two runs, they exchange engines.
    void switch_engine();
    void step() { step(dt_); }
    /// In steps of dt and one shorter one, so that it ends there exactly.
    void run_until(double end, double dt);
    /// What the player does, as far as each run's rules permit it. True if any did.
    bool press(const Control& control);
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
    [[nodiscard]] double time() const { return runs_.front().session().world().time(); }
    [[nodiscard]] bool gravity() const { return gravity_; }
    [[nodiscard]] bool has_gravity() const { return !(original_->gravity == Vec2{}); }
    [[nodiscard]] const std::optional<Parting>& parting() const { return parting_; }
    /// Largest distance between the same ball in both runs over time, m; nothing while they share none.
    [[nodiscard]] const std::deque<Sample>& distance_history() const { return distance_; }

  private:
    void load(const std::string& scene);
    void start();
    /// The engine to compare `engine` with: the next in the list.
    [[nodiscard]] static const Engine& partner_of(const Engine& engine);
    [[nodiscard]] const Settings& settings_of(const Engine& engine);
    void step(double dt);
    void compare();

    std::string name_;
    std::shared_ptr<const Scene> original_;  ///< as in the file
    std::shared_ptr<const Scene> scene_;     ///< as it is run: gravity may be off
    std::vector<lab::SettingChange> changes_;
    std::vector<std::pair<const Engine*, Settings>> settings_;  ///< of every engine used so far
    Script script_;
    const Engine* engine_;  ///< of the first run
    View view_;
    std::vector<Run> runs_;
    double dt_ = 1.0 / 60;
    bool gravity_ = true;
    std::deque<Sample> distance_;
    std::optional<Parting> parting_;
};

}  // namespace flipside::app
