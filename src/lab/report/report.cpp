#include "lab/report/report.hpp"

#include <nlohmann/json.hpp>

#include "lab/contenders/engines.hpp"
#include "lab/files/data_file.hpp"
#include "lab/files/whole_file.hpp"
#include "lab/process/build_commit.hpp"
#include "lab/report/facts.hpp"
#include "lab/report/gnuplot.hpp"
#include "world/input_error.hpp"
#include "world/json_file.hpp"

namespace flipside::lab::report {

namespace fs = std::filesystem;

namespace {

constexpr double share_of_drawing = 0.05;  ///< of the time that all takes, for the progress

/// Notes what the folder's data are of, or checks that they are of the same.
void claim(const Data& data, const Effort& effort) {
    const std::string file = "report.json", origin = "report";
    nlohmann::ordered_json json{
        {"format", "flipside-report-data/2"}, {"effort", effort.name}, {"commit", build_commit()}};
    for (const Engine* engine : engines())
        if (!engine->file.empty())
            json["libraries"][std::string(engine->name)] = checksum(read_file(engine->file));
    const std::string text = json_text(json, 2) + '\n';
    const auto found = read_back(
        data.path(file), data.notice(), [&] { return read_data_file(data.path(file), origin); },
        "it is made again");
    if (!found) return write_data_file(data.path(file), origin, text);
    if (*found != text)
        throw InputError(
            data.path(file).string() +
            ": the data beside it are of another build, of other libraries or of another effort than '" +
            effort.name + "' (--quick or not); remove the folder or name another one");
}

void measure(const std::vector<Chapter>& all, const Data& data, const Watch& watch) {
    std::vector<Measurement> measurements;
    for (const Chapter& chapter : all)
        measurements.insert(measurements.end(), chapter.measurements.begin(), chapter.measurements.end());
    take(measurements, data, [&](double share) { watch((1 - share_of_drawing) * share); });
}

/// Draws the chapter's figures; their points lie beside the data.
PageChapter drawn(const Chapter& chapter, const Data& data, const fs::path& pictures,
                  const std::function<void()>& watch) {
    PageChapter shown{chapter.id, chapter.title, chapter.intro, chapter.show(data), {}};
    for (const Figure& figure : shown.content.figures) {
        watch();
        const fs::path csv = data.path("figure-" + figure.id + ".csv");
        write_csv(figure, csv);
        shown.svgs.push_back(draw(figure, csv, pictures));
    }
    return shown;
}

Page empty_page(const ReportInput& input, const std::string& gnuplot) {
    Page page{
        "Flipside: speed and error of physics engines",
        "What each engine makes of scenes whose right answer is known, and what it costs. Point at a point "
        "of a figure, or tap it, and it says which setting it is.",
        {},
        build_facts()};
    std::string from;
    for (const fs::path& folder : input.from) from += (from.empty() ? "" : ", ") + folder.string();
    page.facts.emplace_back("Drawn with", gnuplot);
    page.facts.emplace_back("Effort", input.effort.name + (from.empty() ? "" : "; sweep from " + from));
    page.facts.emplace_back("Date", today());
    return page;
}

}  // namespace

std::vector<Chapter> chapters(const Effort& effort, const std::vector<fs::path>& from) {
    return {work_precision_chapter(effort, from),
            hard_case_chapter(effort),
            case_work_chapter(effort),
            stability_chapter(effort),
            energy_chapter(effort),
            divergence_chapter(effort),
            penetration_chapter(effort),
            growth_chapter(effort),
            broad_phase_chapter(effort)};
}

void make_report(const ReportInput& input, const Watch& watch, const Notice& notice) {
    Page page = empty_page(input, gnuplot_version());
    const std::vector<Chapter> all = chapters(input.effort, input.from);
    const Data data(input.out / "data", input.effort.name, notice);
    const fs::path pictures = input.out / "figures";
    make_folder(data.folder());
    make_folder(pictures);
    claim(data, input.effort);
    measure(all, data, watch);
    for (const Chapter& chapter : all) {
        const double left = 1 - static_cast<double>(page.chapters.size()) / static_cast<double>(all.size());
        page.chapters.push_back(drawn(chapter, data, pictures, [&] { watch(1 - share_of_drawing * left); }));
    }
    write_whole_file(input.out / "index.html", html_of(page));
}

}  // namespace flipside::lab::report
