#include "app/window/high_scores.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>

#include <nlohmann/json.hpp>

#include "app/window/kept.hpp"
#include "lab/files/whole_file.hpp"
#include "lab/process/failure.hpp"
#include "world/input_error.hpp"
#include "world/json_file.hpp"
#include "world/schema.hpp"

namespace flipside::app {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view scores_format = "flipside-scores/1";
constexpr std::uintmax_t largest_scores_file = 1U << 20U;

std::string text_of_scores(const std::vector<HighScore>& scores) {
    nlohmann::ordered_json j{{"format", scores_format}, {"scores", nlohmann::ordered_json::array()}};
    for (const HighScore& score : scores)
        j["scores"].push_back(
            {{"scene", score.scene}, {"engine", score.engine}, {"score", score.score}, {"date", score.date}});
    return json_text(j, 2) + '\n';
}

}  // namespace

std::optional<fs::path> high_scores_file() {
    auto file = kept_file();
    if (file) file->replace_filename("scores.json");
    return file;
}

std::vector<HighScore> load_high_scores(const fs::path& file) {
    const std::string name = file.string();
    const Json document = parse_json(read_file(file, largest_scores_file), name);
    check_form(document, scores_schema, name);
    std::vector<HighScore> scores;
    for (const Node& node : Node(document, name).each("scores"))
        scores.push_back({node.text("scene"), node.text("engine"), static_cast<long>(node.integer("score")),
                          node.text("date")});
    std::ranges::stable_sort(scores, std::ranges::greater{}, &HighScore::score);
    return scores;
}

std::string today() {
    const std::time_t now = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
    std::tm day{};
    gmtime_r(&now, &day);
    char text[16];
    const std::size_t length = std::strftime(text, sizeof text, "%Y-%m-%d", &day);
    return {text, length};
}

HighScores::HighScores(std::optional<fs::path> file) : file_(std::move(file)) {
    read();
}

void HighScores::read() {
    std::error_code none;
    if (!file_ || !fs::exists(*file_, none)) return;
    try {
        scores_ = load_high_scores(*file_);
    } catch (const InputError& error) {
        file_.reset();
        trouble_ = "the high scores are left alone: " + std::string(error.what());
    }
}

void HighScores::write() {
    if (!file_) return;
    try {
        lab::make_folder(file_->parent_path());
        lab::write_whole_file(*file_, text_of_scores(scores_));
    } catch (const std::runtime_error& error) {
        file_.reset();
        trouble_ = "high scores are not kept for the next start: " + std::string(error.what());
    }
}

std::size_t HighScores::enter(const HighScore& score) {
    read();
    const auto better = [&](const HighScore& other) {
        return other.scene == score.scene && other.score >= score.score;
    };
    const auto place = static_cast<std::size_t>(std::ranges::count_if(scores_, better)) + 1;
    if (score.score <= 0 || place > most) return 0;
    scores_.insert(std::ranges::upper_bound(scores_, score.score, std::ranges::greater{}, &HighScore::score),
                   score);
    std::size_t seen = 0;
    std::erase_if(scores_, [&](const HighScore& one) { return one.scene == score.scene && ++seen > most; });
    write();
    return place;
}

std::vector<HighScore> HighScores::of(const std::string& scene) const {
    std::vector<HighScore> of_scene;
    std::ranges::copy_if(scores_, std::back_inserter(of_scene),
                         [&](const HighScore& score) { return score.scene == scene; });
    return of_scene;
}

}  // namespace flipside::app
