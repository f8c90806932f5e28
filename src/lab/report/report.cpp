#include "lab/report/report.hpp"

#include <system_error>

#include <nlohmann/json.hpp>

#include "lab/failure.hpp"
#include "lab/report/facts.hpp"
#include "lab/report/gnuplot.hpp"
#include "lab/whole_file.hpp"
#include "world/input_error.hpp"
#include "world/json_file.hpp"

namespace flipside::lab::report {

namespace fs = std::filesystem;

namespace {

constexpr double share_of_drawing = 0.05;  ///< of the time that all takes, for the progress

void make_folder(const fs::path& folder) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) throw Failure(folder.string() + ": cannot be made (" + error.message() + ")");
}

std::string text_of(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

/// Notes what the folder's data are of, or checks that they are of the same.
void claim(const fs::path& data, const Effort& effort) {
    const fs::path file = data / "report.json";
    const nlohmann::ordered_json json{
        {"format", "flipside-report-data/1"}, {"effort", effort.name}, {"commit", build_commit()}};
    const std::string text = json.dump(2) + '\n';
    if (!exists(file)) return write_whole_file(file, text);
    if (text_of(file) != text)
        throw InputError(file.string() +
                         ": the data beside it are of another build or of another effort than '" +
                         effort.name + "' (--quick or not); remove the folder or name another one");
}

std::vector<Chapter> measured(const ReportInput& input, const fs::path& data, const Watch& watch) {
    std::vector<Chapter> all = chapters(input.effort);
    std::vector<Measurement> measurements;
    for (const Chapter& chapter : all)
        measurements.insert(measurements.end(), chapter.measurements.begin(), chapter.measurements.end());
    take(measurements, data, [&](double share) { watch((1 - share_of_drawing) * share); });
    return all;
}

}  // namespace

std::vector<Chapter> chapters(const Effort& effort) {
    return {energy_chapter(effort), divergence_chapter(effort), penetration_chapter(effort),
            growth_chapter(effort), broad_phase_chapter(effort)};
}

void make_report(const ReportInput& input, const Watch& watch) {
    const std::string gnuplot = gnuplot_version();
    const fs::path data = input.out / "data", pictures = input.out / "figures";
    make_folder(data);
    make_folder(pictures);
    claim(data, input.effort);

    Page page{"Flipside: speed and error of two physics engines",
              "What each engine makes of scenes whose right answer is known, and what it costs. Point at a "
              "point of a "
              "figure, or tap it, and it says which setting it is.",
              {},
              build_facts()};
    page.facts.emplace_back("Drawn with", gnuplot);
    page.facts.emplace_back("Effort", input.effort.name);
    page.facts.emplace_back("Date", today());
    const std::vector<Chapter> all = measured(input, data, watch);
    for (const Chapter& chapter : all) {
        PageChapter shown{chapter.id, chapter.title, chapter.intro, chapter.show(data), {}};
        for (const Figure& figure : shown.content.figures) {
            watch(1 - share_of_drawing *
                          (1 - static_cast<double>(page.chapters.size()) / static_cast<double>(all.size())));
            const fs::path csv = data / ("figure-" + figure.id + ".csv");
            write_csv(figure, csv);
            shown.svgs.push_back(draw(figure, csv, pictures));
        }
        page.chapters.push_back(std::move(shown));
    }
    write_whole_file(input.out / "index.html", html_of(page));
}

}  // namespace flipside::lab::report
