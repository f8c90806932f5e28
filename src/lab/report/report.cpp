#include "lab/report/report.hpp"

#include <thread>

#include <nlohmann/json.hpp>

#include "lab/contenders/engines.hpp"
#include "lab/files/csv.hpp"
#include "lab/files/csv_table.hpp"
#include "lab/files/data_file.hpp"
#include "lab/files/text_stream.hpp"
#include "lab/files/whole_file.hpp"
#include "lab/process/build_commit.hpp"
#include "lab/report/facts.hpp"
#include "lab/report/gnuplot.hpp"
#include "lab/report/scene_pictures.hpp"
#include "world/input_error.hpp"
#include "world/json_file.hpp"

namespace flipside::lab::report {

namespace fs = std::filesystem;

namespace {

constexpr double share_of_drawing = 0.05;  ///< of the time that all takes, for the progress

constexpr const char *claim_file = "report.json", *claim_origin = "report", *facts_file = "facts.csv";

/// Notes what the folder's data are of, or checks that they are of the same.
void claim(const Data& data, const Effort& effort) {
    nlohmann::ordered_json json{
        {"format", "flipside-report-data/2"}, {"effort", effort.name}, {"commit", build_commit()}};
    for (const Engine* engine : engines())
        if (!engine->file.empty())
            json["libraries"][std::string(engine->name)] = checksum(read_file(engine->file));
    const std::string text = json_text(json, 2) + '\n';
    const auto found = read_back(
        data.path(claim_file), data.notice(),
        [&] { return read_data_file(data.path(claim_file), claim_origin); }, "it is made again");
    if (!found) return write_data_file(data.path(claim_file), claim_origin, text);
    if (*found != text)
        throw InputError(
            data.path(claim_file).string() +
            ": the data beside it are of another build, of other libraries or of another effort than '" +
            effort.name + "' (--quick or not); remove the folder or name another one");
}

/// The commit of the build that measured what is in the folder.
std::string measured_by(const fs::path& folder, const Effort& effort) {
    const fs::path file = folder / claim_file;
    const Json json = parse_json(read_data_file(file, claim_origin), file.string());
    if (json.value("effort", "") != effort.name)
        throw InputError(file.string(), "/effort",
                         "is another than '" + effort.name +
                             "'; with --quick a quick report is drawn, without a full one");
    return json.value("commit", "");
}

/// What was true when it was measured, as name and value.
std::string facts_csv() {
    TextStream file;
    CsvRow row;
    row.add("name").add("value").write(file);
    for (const auto& [name, value] : build_facts()) row.add(name).add(value).write(file);
    row.add("Date").add(today()).write(file);
    return file.str();
}

std::vector<std::pair<std::string, std::string>> facts_of(const Data& data) {
    std::vector<std::pair<std::string, std::string>> facts;
    const CsvTable table(data.path(facts_file), data.read(facts_file));
    for (std::size_t row = 0; row < table.rows(); ++row)
        facts.emplace_back(table.text(row, "name"), table.text(row, "value"));
    return facts;
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

std::string list_of(const std::vector<fs::path>& folders) {
    std::string list;
    for (const fs::path& folder : folders) list += (list.empty() ? "" : ", ") + folder.string();
    return list;
}

Page empty_page(const ReportInput& input, const Data& data, const std::string& commit) {
    Page page;
    page.title = "Flipside: which physics engine, which step, and how sure?";
    page.intro =
        "Scenes whose right answer is known: errors in radii of a ball, costs in CPU time per simulated "
        "second.";
    page.warning = input.effort.warning;
    page.pick_rule =
        "Taken is the cheapest setting with a step of at most 1/60 s that is good enough: with 95 % "
        "confidence off by less than a tenth of a radius in the median window, or, where only overlap can "
        "tell, overlapping by less than that.";
    page.facts = facts_of(data);
    const std::string date = page.facts.back().second;
    const std::string from = list_of(input.from);
    page.facts.emplace_back("Drawn with", gnuplot_version() + ", by commit " + build_commit());
    page.facts.emplace_back("Effort", input.effort.name + (from.empty() ? "" : "; sweep from " + from));
    page.cite =
        "Flipside report (" + input.effort.name + "), measured by commit " + commit + ", " + date + ".";
    page.scenes = scene_pictures(input.effort.variants);
    return page;
}

/// What was run and how long, as the data say.
std::string work_done(const Data& data, const ReportInput& input, const std::string& from) {
    const Effort& effort = input.effort;
    const Spent spent = data.spent();
    return "Effort " + effort.name + ": every engine on " +
           (from.empty() ? effort.windows : "the windows of the sweep in " + from) + "; " + effort.runs +
           " It took " + time_text(spent.cpu_seconds) + " of CPU time on one thread" +
           (spent.most_load > 0
                ? ", with at most " + short_number(spent.most_load) +
                      " programs running at once on the machine's " +
                      std::to_string(std::thread::hardware_concurrency()) + " hardware threads"
                : std::string()) +
           ".";
}

}  // namespace

std::vector<Chapter> chapters(const Effort& effort, const std::vector<fs::path>& from) {
    return {work_precision_chapter(effort, from),
            regime_chapter(effort),
            hard_case_chapter(effort),
            case_work_chapter(effort),
            border_chapter(effort),
            energy_chapter(effort),
            divergence_chapter(effort),
            penetration_chapter(effort),
            growth_chapter(effort),
            broad_phase_chapter(effort),
            tuning_chapter(effort)};  // takes longest
}

void make_report(const ReportInput& input, const Watch& watch, const Notice& notice) {
    static_cast<void>(gnuplot_version());  // before all work
    const std::vector<Chapter> all = chapters(input.effort, input.from);
    const fs::path pictures = input.out / "figures";
    const std::string commit =
        input.redraw ? measured_by(input.out / "data", input.effort) : std::string(build_commit());
    const Data data(input.out / "data", input.effort.name, commit, notice);
    make_folder(data.folder());
    make_folder(pictures);
    if (!input.redraw) {
        claim(data, input.effort);
        if (!data.has(facts_file)) data.write(facts_file, facts_csv());
        measure(all, data, watch);
    }
    Page page = empty_page(input, data, commit);
    double done = 0;
    for (const Chapter& chapter : all) {
        const double left = 1 - done++ / static_cast<double>(all.size());
        const auto watch_drawing = [&] { watch(1 - share_of_drawing * left); };
        try {
            page.chapters.push_back(drawn(chapter, data, pictures, watch_drawing));
        } catch (const InputError& error) {
            if (!input.redraw) throw;
            notice(std::string(error.what()) + "; the chapter '" + chapter.title + "' is left out");
        }
    }
    page.was_run = work_done(data, input, list_of(input.from));
    write_whole_file(input.out / "index.html", html_of(page));
}

}  // namespace flipside::lab::report
