#include "lab/report/figure.hpp"

#include <cmath>

#include <gtest/gtest.h>
#include <unistd.h>

#include "drawn.hpp"
#include "lab/files/csv_table.hpp"
#include "lab/process/failure.hpp"
#include "lab/report/gnuplot.hpp"
#include "lab/report/html.hpp"
#include "lab/report/markup.hpp"
#include "lab/report/page.hpp"
#include "lab/report/process.hpp"
#include "lab/report/svg.hpp"

namespace flipside::lab::report {
namespace {

namespace fs = std::filesystem;

constexpr double infinity = std::numeric_limits<double>::infinity();

class Figures : public ::testing::Test {
  protected:
    fs::path folder = fs::temp_directory_path() / ("flipside-figures-" + std::to_string(getpid()));
    void SetUp() override { fs::create_directory(folder); }
    void TearDown() override { fs::remove_all(folder); }

    /// Everything that can go wrong in names: quotes, commas, markup, what gnuplot or its SVG might take for
    /// a command.
    static Figure awkward() {
        Series first{"a, \"b\" & <c>_d'{}^", "#56b4e9", 2, 7, 0.8, true, {}};
        first.points = {{0.001, 1e-3, "dt = 1/60 s, \"fast\""},
                        {0.01, infinity, "lost <all> balls"},
                        {1, 1e-7, "%d\n$1"}};
        Series second{"second", "#e69f00", 1, 5, 0.8, false, {{0.1, 0, "nothing at all"}}};
        return {"awk-ward",         "A figure's title",
                {"x_1", "x", true}, {"y^2", "y", true, 1e-9},
                {first, second},    {{0.05, "a mark", "#009e73"}},
                "Read it."};
    }
};

TEST_F(Figures, FramesHoldEveryPointInsideRoundEnds) {
    Figure figure = awkward();
    Frame frame = frame_of(figure);
    EXPECT_NEAR(std::log10(frame.x.from), -3.06, 1e-9);  // 1e-3 … 1, and 2 % of three decades more
    EXPECT_NEAR(std::log10(frame.x.to), 0.06, 1e-9);
    EXPECT_NEAR(std::log10(frame.y.from), -9.12, 1e-9);  // the floor … 1e-3
    EXPECT_NEAR(std::log10(frame.y.to), -2.88, 1e-9);
    figure.x.logarithmic = false;
    frame = frame_of(figure);
    EXPECT_NEAR(frame.x.from, -0.02, 1e-12);
    EXPECT_NEAR(frame.x.to, 1.02, 1e-12);
}

TEST_F(Figures, TheCsvHoldsEveryPointWithAllItsBits) {
    const Figure figure = awkward();
    write_csv(figure, folder / "f.csv");
    const CsvTable table(folder / "f.csv");
    ASSERT_EQ(table.rows(), 4U);
    EXPECT_EQ(table.text(0, "series"), figure.series[0].name);
    EXPECT_EQ(table.number(0, "x"), 0.001);
    EXPECT_EQ(table.number(1, "y"), 1e-7);
    EXPECT_EQ(table.text(0, "point"), "dt = 1/60 s, \"fast\"");
    EXPECT_EQ(table.text(1, "point"), "%d; $1");
    EXPECT_EQ(table.number(2, "y"), infinity);  // the failed one is the last of its series
    EXPECT_EQ(table.text(2, "point"), "lost <all> balls");
    EXPECT_EQ(table.number(3, "y"), 0);
}

TEST_F(Figures, PointsAreDrawnWhereTheirNumbersSay) {
    const Figure figure = awkward();
    write_csv(figure, folder / "f.csv");
    draw(figure, folder / "f.csv", folder);
    const std::string svg = text_of(folder / "awk-ward.svg");
    const Layout box = file_layout(figure);
    EXPECT_EQ(text_of(folder / "awk-ward.png").substr(1, 3), "PNG");

    const auto points = points_of(svg);
    ASSERT_EQ(points.size(), 4U);
    const double decade_x = (box.right - box.left) / 3.12, decade_y = (box.bottom - box.top) / 6.24;
    const auto at_x = [&](double x) { return box.left + (std::log10(x) + 3.06) * decade_x; };
    const auto at_y = [&](double y) { return box.bottom - (std::log10(y) + 9.12) * decade_y; };
    constexpr double px = 0.02;  // what gnuplot rounds to
    EXPECT_NEAR(points[0].x, at_x(0.001), px);
    EXPECT_NEAR(points[0].y, at_y(1e-3), px);
    EXPECT_NEAR(points[1].x, at_x(1), px);
    EXPECT_NEAR(points[1].y, at_y(1e-7), px);
    EXPECT_NEAR(points[2].x, at_x(0.01), px);
    EXPECT_NEAR(points[2].y, box.top, px);  // failed: the upper edge
    EXPECT_NEAR(points[3].x, at_x(0.1), px);
    EXPECT_NEAR(points[3].y, box.bottom, px);  // 0 on a logarithmic scale: the lower edge
    EXPECT_EQ(points[2].words.find("a, &quot;b&quot; &amp; &lt;c&gt;_d&#39;{}^\nlost &lt;all&gt; balls"), 0U)
        << points[2].words;
    EXPECT_NE(points[1].words.find("x_1: 1\ny^2: 1e-07"), std::string::npos) << points[1].words;
}

TEST_F(Figures, TheAxesAreLabelledWhereTheirNumbersAre) {
    Figure figure = awkward();
    figure.x.logarithmic = false;  // -0.02 … 1.02
    write_csv(figure, folder / "f.csv");
    draw(figure, folder / "f.csv", folder);
    const std::string svg = text_of(folder / "awk-ward.svg");
    const Layout box = file_layout(figure);
    for (const auto& [label, value] : {std::pair("0\\.2", 0.2), {"0\\.8", 0.8}}) {
        const auto texts = texts_of(svg, label);
        ASSERT_EQ(texts.size(), 1U) << label;
        EXPECT_NEAR(texts[0].x, box.left + (value + 0.02) / 1.04 * (box.right - box.left), 0.02);
    }
    for (const int power : {-3, -5, -8}) {  // 10^-9.12 … 10^-2.88
        const auto texts = texts_of(svg, "10</tspan><tspan[^>]*>" + std::to_string(power) + "</tspan>.*");
        ASSERT_EQ(texts.size(), 1U) << power;
        const double y = box.bottom - (power + 9.12) / 6.24 * (box.bottom - box.top);
        EXPECT_NEAR(texts[0].y, y + 4.55, 0.02) << power;  // the text's foot, for its middle is at the mark
    }
    EXPECT_EQ(texts_of(svg, "x_1").size(), 1U);
    EXPECT_EQ(texts_of(svg, "a mark").size(), 1U);
}

TEST_F(Figures, ThePageShowsEachSeriesUnderAClassOfItsOwnAndWithoutTheFilesWords) {
    const Figure figure = awkward();
    write_csv(figure, folder / "f.csv");
    const std::string svg = draw(figure, folder / "f.csv", folder);
    EXPECT_EQ(points_of(svg).size(), 4U);
    EXPECT_TRUE(texts_of(svg, "x_1").empty());
    EXPECT_EQ(svg.find("_plot_"), std::string::npos);
    const auto second = svg.find("class=\"s1\"");
    ASSERT_NE(second, std::string::npos);
    EXPECT_EQ(points_of(svg.substr(0, second)).size(), 3U);
    EXPECT_NE(figure_html(figure, svg).find("class=\"k1\" checked"), std::string::npos);
}

TEST_F(Figures, ThingsStandWhereTheirNumbersAre) {
    Figure figure = awkward();
    figure.y = {"regime", "y", false, 0, {"gas", "rain"}};
    figure.series = {{"one", "#56b4e9", 1, 7, 0.8, false, {{1, 1, ""}, {0.1, 2, ""}}}};
    write_csv(figure, folder / "f.csv");
    draw(figure, folder / "f.csv", folder);
    const std::string svg = text_of(folder / "awk-ward.svg");
    const auto points = points_of(svg);
    const auto gas = texts_of(svg, "gas"), rain = texts_of(svg, "rain");
    ASSERT_EQ(gas.size(), 1U);
    ASSERT_EQ(rain.size(), 1U);
    EXPECT_NEAR(gas[0].y - points[0].y, rain[0].y - points[1].y, 0.02);
    EXPECT_LT(rain[0].y, gas[0].y);
}

TEST_F(Figures, TheSvgStandsInAPageByItself) {
    const Figure figure = awkward();
    write_csv(figure, folder / "f.csv");
    const std::string svg = draw(figure, folder / "f.csv", folder);
    EXPECT_EQ(svg.find("<svg role=\"img\" aria-label=\"A figure&#39;s title\""), 0U) << svg.substr(0, 200);
    for (const char* unwanted :
         {"<script", "onmouse", "gnuplot_svg", "<?xml", "<!DOCTYPE", "gpPt", "rgb(  1,   1,   1)"})
        EXPECT_EQ(svg.find(unwanted), std::string::npos) << unwanted;
}

/// What a script, a page or a shell might take for more than text.
constexpr const char* hostile =
    "#x' \"\nsystem 'touch RUN'\n`touch RUN` $(touch RUN) @a \\\n<script>alert(1)</script>]]>{/*=+ "
    "\x1b[31m\x7f\u202e\xff";

TEST_F(Figures, AreDrawnWithTheSamePointsWhateverTheTextsSay) {
    Figure figure = awkward();
    write_csv(figure, folder / "f.csv");
    const auto plain = points_of(draw(figure, folder / "f.csv", folder));
    figure.title = figure.reading = figure.x.label = figure.y.label = figure.marks[0].says = hostile;
    for (Series& series : figure.series) {
        series.name = hostile;
        for (Point& point : series.points) point.says = hostile;
    }
    write_csv(figure, folder / "f.csv");
    const std::string svg = draw(figure, folder / "f.csv", folder);
    const auto points = points_of(svg);
    ASSERT_EQ(points.size(), plain.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_EQ(points[i].x, plain[i].x);
        EXPECT_EQ(points[i].y, plain[i].y);
    }
    EXPECT_FALSE(fs::exists(folder / "RUN")) << text_of(folder / "awk-ward.gp");
    for (const fs::path& file : {folder / "awk-ward.svg", folder / "awk-ward.gp", folder / "f.csv"})
        for (const char* bad : {"\x1b", "\x7f", "\u202e", "\xff"})
            EXPECT_EQ(text_of(file).find(bad), std::string::npos) << file;
    EXPECT_EQ(svg.find("<script"), std::string::npos);
    EXPECT_EQ(CsvTable(folder / "f.csv").rows(), 4U);
}

TEST_F(Figures, HavePlainIds) {
    Figure figure = awkward();
    write_csv(figure, folder / "f.csv");
    for (const char* id : {"../x", "|touch RUN", "<touch RUN", "a\nb", "", "-e", "a b", "a'b"}) {
        figure.id = id;
        EXPECT_THROW(draw(figure, folder / "f.csv", folder), Failure) << id;
        EXPECT_THROW(static_cast<void>(script_of(figure, "f.csv")), Failure) << id;
    }
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
    figure.id = "a.b_c-d";
    EXPECT_EQ(points_of(draw(figure, folder / "f.csv", folder)).size(), 4U);
}

TEST(Markup, HasNoMarkupLeft) {
    EXPECT_EQ(escape("<a href='x'>\"&\n\x1b\u202e"), "&lt;a href=&#39;x&#39;&gt;&quot;&amp;\n\\x1b\\u{202e}");
}

TEST(Markup, IsUsedForEveryTextOfAPage) {
    Figure figure;
    figure.id = "f";
    figure.title = figure.reading = figure.x.label = figure.y.label = hostile;
    figure.series.push_back({hostile, "#000000", 1, 7, 1, true, {{1, 1, hostile}}});
    const Table table{hostile, hostile, {hostile}, {{{hostile, false, hostile}}}, hostile};
    const Content content{
        {figure}, {table}, {hostile}, {{hostile, hostile, hostile, hostile, hostile, hostile}}};
    const Page page{hostile,
                    hostile,
                    hostile,
                    hostile,
                    hostile,
                    hostile,
                    {{hostile, hostile, ""}},
                    {{hostile, hostile, hostile, content, {""}}},
                    {{hostile, hostile}}};
    std::string html = html_of(page);
    EXPECT_EQ(html.find("<script>alert"), std::string::npos);
    for (const char* bad : {"\x1b", "\x7f", "\u202e", "\xff", "'touch", "\"\nsystem"})
        EXPECT_EQ(html.find(bad), std::string::npos) << bad;
}

TEST_F(Figures, ASeriesMayBeEmptyAndAFigureToo) {
    Figure figure = awkward();
    figure.series[0].points.clear();
    figure.series[1].points = {{1, infinity, "failed"}};
    write_csv(figure, folder / "f.csv");
    EXPECT_EQ(points_of(draw(figure, folder / "f.csv", folder)).size(), 1U);
}

TEST(Processes, SayHowTheyEndedAndWhatTheySaid) {
    const Finished good = run_program({"echo", "$HOME 'a b'"});
    EXPECT_EQ(good.code, 0);
    EXPECT_EQ(good.said, "$HOME 'a b'\n");  // no shell in between
    EXPECT_EQ(run_program({"sh", "-c", "echo no >&2; exit 3"}).code, 3);
    EXPECT_EQ(run_program({"sh", "-c", "echo no >&2"}).said, "no\n");
    EXPECT_EQ(run_program({"sh", "-c", "kill -9 $$"}).code, 128 + 9);
    EXPECT_THROW(static_cast<void>(run_program({"no-such-program"})), Failure);
}

TEST(Numbers, AreShortForPeople) {
    EXPECT_EQ(short_number(1234567), "1.235e+06");
    EXPECT_EQ(short_number(0.25), "0.25");
    EXPECT_EQ(step_text(1.0 / 7680), "1/7680 s");
    EXPECT_EQ(step_text(0.3), "0.3 s");
}

}  // namespace
}  // namespace flipside::lab::report
