#pragma once
/// The best games played in the window, kept between starts in one JSON file of the form of
/// assets/scores.schema.json.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace flipside::app {

struct HighScore {
    std::string scene, engine;  ///< a scene's name, or the absolute path of its file
    long score = 0;             ///< above 0
    std::string date;           ///< as 2026-11-24, UTC

    friend bool operator==(const HighScore&, const HighScore&) = default;
};

/// Beside window.json (kept.hpp).
[[nodiscard]] std::optional<std::filesystem::path> high_scores_file();
/// Throws InputError where it cannot be read or is of another form.
[[nodiscard]] std::vector<HighScore> load_high_scores(const std::filesystem::path& file);
[[nodiscard]] std::string today();

class HighScores {
  public:
    static constexpr std::size_t most = 5;  ///< of each scene

    /// Without a file they last until the end of the program. A file that is no good is left alone.
    explicit HighScores(std::optional<std::filesystem::path> file);

    /// Enters it where it is good enough, and keeps it. Its place from 1, or 0. What another window wrote
    /// meanwhile stays.
    std::size_t enter(const HighScore& score);
    /// Of a scene, best first.
    [[nodiscard]] std::vector<HighScore> of(const std::string& scene) const;
    /// What went wrong with the file; "" if nothing.
    [[nodiscard]] const std::string& trouble() const { return trouble_; }

  private:
    void read();
    void write();

    std::optional<std::filesystem::path> file_;  ///< nothing where it is left alone
    std::vector<HighScore> scores_;              ///< best first
    std::string trouble_;
};

}  // namespace flipside::app
