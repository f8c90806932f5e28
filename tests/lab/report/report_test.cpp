// A whole report of very little work: its figures show what their CSV files say, and a report that was
// stopped ends as one that was not.

#include "lab/report/report.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include <gtest/gtest.h>
#include <unistd.h>

#include "drawn.hpp"
#include "in_small.hpp"
#include "lab/files/csv_table.hpp"
#include "lab/process/build_commit.hpp"
#include "lab/process/failure.hpp"
#include "lab/report/gnuplot.hpp"
#include "made_up_sweep.hpp"
#include "tiny_effort.hpp"
#include "world/input_error.hpp"

namespace flipside::lab::report {
namespace {

namespace fs = std::filesystem;

/// Where nothing is damaged, nothing is noticed.
const Notice unnoticed = [](const std::string& sentence) { ADD_FAILURE() << sentence; };

class Reports : public ::testing::Test {
  protected:
    fs::path folder = fs::temp_directory_path() / ("flipside-report-" + std::to_string(getpid()));
    fs::path swept = folder / "swept";
    void SetUp() override { make_up_sweep(swept); }
    void TearDown() override { fs::remove_all(folder); }

    [[nodiscard]] ReportInput input(const fs::path& out) const { return {out, {swept}, tiny_effort()}; }
    void make(const fs::path& out) const {
        make_report(
            input(out), [](double) {}, unnoticed);
    }

    [[nodiscard]] std::vector<Figure> figures_in(const fs::path& out) const {
        std::vector<Figure> figures;
        for (const Chapter& chapter : chapters(tiny_effort(), {swept}))
            for (Figure& figure :
                 chapter.show({out / "data", tiny_effort().name, build_commit(), unnoticed}).figures)
                figures.push_back(std::move(figure));
        return figures;
    }
    /// Everything below a folder that must be the same in two reports with the same measurements.
    static std::map<std::string, std::string> files_in(const fs::path& out) {
        std::map<std::string, std::string> files;
        for (const auto& entry : fs::recursive_directory_iterator(out))
            if (entry.is_regular_file()) files[fs::relative(entry, out)] = text_of(entry);
        return files;
    }
};

/// Where a value stands between the ends of an axis, 0 … 1, those beyond at the end.
double place(double value, const Axis& axis, const Range& range) {
    if (axis.logarithmic)
        return value <= range.from
                   ? 0
                   : std::min(1.0, std::log(value / range.from) / std::log(range.to / range.from));
    return std::clamp((value - range.from) / (range.to - range.from), 0.0, 1.0);
}

TEST_F(Reports, EveryFigureShowsWhatItsCsvSaysInAPageThatNeedsNothingElse) {
    make(folder);
    const auto figures = figures_in(folder);
    EXPECT_GE(figures.size(), 18U);
    for (const Figure& figure : figures) {
        const CsvTable table(folder / "data" / ("figure-" + figure.id + ".csv"));
        const auto points = points_of(text_of(folder / "figures" / (figure.id + ".svg")));
        EXPECT_GT(table.rows(), 1U) << figure.id;
        ASSERT_EQ(points.size(), table.rows()) << figure.id;
        const Frame frame = frame_of(figure);
        const Layout box = file_layout(figure);
        for (std::size_t row = 0; row < table.rows(); ++row) {
            const double across = place(table.number(row, figure.x.column), figure.x, frame.x);
            const double up = place(table.number(row, figure.y.column), figure.y, frame.y);
            EXPECT_NEAR(points[row].x, box.left + across * (box.right - box.left), 0.02)
                << figure.id << " row " << row;
            EXPECT_NEAR(points[row].y, box.bottom - up * (box.bottom - box.top), 0.02)
                << figure.id << " row " << row;
        }
        EXPECT_EQ(text_of(folder / "figures" / (figure.id + ".png")).substr(1, 3), "PNG") << figure.id;
        EXPECT_GT(figure.reading.size(), 80U) << figure.id;
    }

    // The page holds every figure and needs nothing else.
    const std::string page = text_of(folder / "index.html");
    for (const Figure& figure : figures)
        EXPECT_NE(page.find("<figure id=\"" + figure.id + "\""), std::string::npos);
    for (const char* words : {"Compiler", "-ffp-contract=off", "Box2D 2.", "Commit"})
        EXPECT_NE(page.find(words), std::string::npos) << words;
    EXPECT_TRUE(std::regex_search(page, std::regex("gnuplot [0-9]")));
    EXPECT_NE(
        page.find(
            "of box2d on toy 67 % begin at arcs, as late contacts, and 33 % begin in flight, as drift."),
        std::string::npos);
    EXPECT_NE(page.find("custom-continuous never diverges on toy."), std::string::npos);
    for (const char* outside : {"<script src", "<link rel=\"stylesheet", "@import", "url(", "<img"})
        EXPECT_EQ(page.find(outside), std::string::npos) << outside;
    // Ids are there once only, though every picture brings its own.
    std::map<std::string, int> ids;
    const std::regex id("\\sid=[\"']([^\"']*)[\"']");
    for (std::sregex_iterator at(page.begin(), page.end(), id), end; at != end; ++at) ++ids[(*at)[1]];
    for (const auto& [name, count] : ids) EXPECT_EQ(count, 1) << name;
}

TEST_F(Reports, OneThatWasStoppedEndsAsOneThatWasNot) {
    make(folder / "whole");
    auto expected = files_in(folder / "whole");
    // Stopped after each of several shares of the work, with what is left of a measurement under way removed.
    for (const double stop : {0.2, 0.5, 0.9}) {
        if (test::in_small && stop != 0.5) continue;
        try {
            make_report(
                input(folder / "parts"),
                [stop](double share) {
                    if (share > stop) throw Failure("stopped");
                },
                unnoticed);
            FAIL() << "was not stopped";
        } catch (const Failure& stopped) {
            EXPECT_STREQ(stopped.what(), "stopped");
        }
        for (const auto& [name, text] : files_in(folder / "parts"))
            EXPECT_TRUE(expected.contains(name)) << name << " at " << stop;
    }
    make(folder / "parts");
    auto found = files_in(folder / "parts");
    ASSERT_EQ(found.size(), expected.size());
    // What was measured by the clock differs between two reports, and with it what is drawn of it.
    const auto is_timed = [](const std::string& name) {
        return name == "index.html" || name == "data/spent.csv" ||
               name.find("regimes") != std::string::npos || name.find("growth") != std::string::npos ||
               name.find("pairs") != std::string::npos || name.find("case") != std::string::npos;
    };
    std::erase_if(expected, [&](const auto& file) { return is_timed(file.first); });
    for (const auto& [name, text] : expected) EXPECT_EQ(found.at(name), text) << name;
    // Once measured, even those stay: the same report again.
    make(folder / "parts");
    EXPECT_EQ(files_in(folder / "parts"), found);
}

const Series& series_named(const Figure& figure, const std::string& name) {
    return *std::ranges::find(figure.series, name, &Series::name);
}

TEST_F(Reports, WorkAndPrecisionAreThoseOfTheSweep) {
    const Chapter chapter = work_precision_chapter(tiny_effort(), {swept});
    EXPECT_TRUE(chapter.measurements.empty());
    const Content content = chapter.show({{}, "", "", unnoticed});
    ASSERT_EQ(content.figures.size(), 2U);
    const Figure &work = content.figures[0], &order = content.figures[1];
    for (const char* contender : {"custom-continuous", "custom-simple", "box2d"}) {
        const Series& points = series_named(work, contender);
        ASSERT_EQ(points.points.size(), 6U) << contender;
        double dt = 1. / 30;
        for (const Point& point : points.points) {
            EXPECT_NEAR(point.x, made_up_cost(dt), 1e-12) << contender;
            EXPECT_NEAR(point.y, made_up_error(contender, dt), 1e-15) << contender;
            EXPECT_NE(point.says.find("dt = " + step_text(dt)), std::string::npos) << point.says;
            dt /= 2;
        }
    }
    const Series& failing = series_named(work, "box2d-no-bullets");
    EXPECT_TRUE(std::isinf(failing.points[0].y));
    EXPECT_NE(failing.points[0].says.find("3 failed: lost ball"), std::string::npos)
        << failing.points[0].says;
    EXPECT_FALSE(std::isinf(failing.points[1].y));
    // The fitted orders are those that were made up; what lies at rounding has none.
    EXPECT_EQ(series_named(order, "custom-simple: order 1.00 (R² 1.000)").points.size(), 2U);
    EXPECT_EQ(series_named(order, "box2d: order 2.00 (R² 1.000)").points.size(), 2U);
    EXPECT_TRUE(std::ranges::none_of(order.series, [](const Series& series) {
        return series.name.starts_with("custom-continuous: order");
    }));
}

TEST_F(Reports, FoldersWithoutASweepAreRefused) {
    EXPECT_THROW(make_report(
                     {folder / "out", {folder}, tiny_effort()}, [](double) {}, unnoticed),
                 InputError);
}

TEST_F(Reports, AreDrawnAgainFromWhatIsThereAndSayWhatIsMissing) {
    make(folder / "out");
    const auto expected = files_in(folder / "out");
    fs::remove_all(folder / "out" / "figures");
    ReportInput again = input(folder / "out");
    again.redraw = true;
    const auto watch = [](double) {};
    make_report(again, watch, unnoticed);
    EXPECT_EQ(files_in(folder / "out"), expected);

    fs::remove(folder / "out" / "data" / "borders-box2d.csv");
    std::string noticed;
    make_report(again, watch, [&](const std::string& sentence) { noticed += sentence; });
    EXPECT_NE(noticed.find("the chapter 'Borders of stability' is left out"), std::string::npos) << noticed;
    const std::string page = text_of(folder / "out" / "index.html");
    EXPECT_EQ(page.find("chapter-borders"), std::string::npos);
    EXPECT_NE(page.find("chapter-regimes"), std::string::npos);

    again.effort.name = "other";
    EXPECT_THROW(make_report(again, watch, unnoticed), InputError);
}

TEST_F(Reports, DataOfAnotherEffortAreRefused) {
    const auto stop = [](double) { throw Failure("stopped"); };
    EXPECT_THROW(make_report(input(folder), stop, unnoticed), Failure);
    Effort other = tiny_effort();
    other.name = "other";
    EXPECT_THROW(make_report(
                     {folder, {swept}, other}, [](double) {}, unnoticed),
                 InputError);
}

}  // namespace
}  // namespace flipside::lab::report
