#pragma once
/// The options that run, compare and trace have in common.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "app/cli/distinct_files.hpp"
#include "lab/contenders/contender.hpp"
#include "lab/contenders/engines.hpp"
#include "lab/session/session.hpp"

namespace flipside::app {

struct RunOptions {
    std::string scene;
    int balls = 0;  ///< of a generated field; 0: as the scene says
    double seconds = 10;
    std::string dt;  ///< as on the command line; "" for the scene's own
    std::vector<std::string> settings;
    std::string script;  ///< a file, "none", or "" for the one beside the scene

    void add_to(CLI::App& command, const std::string& setting_form);
    void add_seconds(CLI::App& command);
    [[nodiscard]] std::shared_ptr<const Scene> load() const;
    [[nodiscard]] double step(const Scene& loaded) const;
    [[nodiscard]] std::optional<std::filesystem::path> script_path() const;
    /// What is read: the scene and its controls.
    [[nodiscard]] std::vector<NamedFile> inputs() const;
    /// Says on stderr when it takes the one beside the scene.
    [[nodiscard]] Script load_script(const Scene& loaded) const;
};

/// Of the engine on that scene, with what --set changes. Says on stderr which changes have no effect.
[[nodiscard]] Settings settings_with(const std::vector<std::string>& texts, const Engine& engine,
                                     const Scene& scene);
/// Says on stderr which of them have no effect with the other settings of the contender.
void note_idle(const lab::Contender& contender, std::span<const lab::SettingChange> changes);
/// The same of each of them on the scene, for the changes and its own settings.
void note_idle(std::span<const lab::ContenderRequest> requests, const Scene& scene,
               std::span<const lab::SettingChange> changes);

/// Puts the session into the state of that file; "" is none.
void restore_from(const std::string& file, lab::Session& session);

/// --contender, repeated; where several run together.
CLI::Option* add_contenders(CLI::App& command, std::vector<std::string>& contenders);

/// --engine, repeated; where all engines take part and libraries may join them.
void add_libraries(CLI::App& command, std::vector<std::string>& libraries);

/// CLI11 checks: a finite number from `min` to `max`, and a whole one, written in digits.
[[nodiscard]] CLI::Validator number_from(double min, double max);
[[nodiscard]] CLI::Validator whole_number_from(std::int64_t min, std::int64_t max);

}  // namespace flipside::app
