// The report's page as a browser shows it, from a file: headless Chromium renders it without a complaint,
// every point tells what it is, and nothing sticks out of a phone's screen.

#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>
#include <unistd.h>

#include "../lab/report/made_up_sweep.hpp"
#include "../lab/report/tiny_effort.hpp"
#include "lab/files/csv_table.hpp"
#include "lab/report/process.hpp"
#include "lab/report/report.hpp"

namespace flipside::lab::report {
namespace {

namespace fs = std::filesystem;

/// In the page: points at every point, and tells the page around it what became of that.
constexpr const char* visitor = R"(<script>
window.addEventListener('load', () => {
  const tip = document.getElementById('tip');
  let told = 0, drawn = 0;
  const hidden = [...document.querySelectorAll('.point')].filter(point => point.getBoundingClientRect().width === 0);
  for (const all of document.querySelectorAll('.key .all')) all.click();
  const points = document.querySelectorAll('.point');
  for (const point of points) {
    const size = point.getBoundingClientRect();
    if (size.width > 0 && size.height > 0) ++drawn;
    const words = point.querySelector('title').textContent;
    point.dispatchEvent(new PointerEvent('pointerover', {bubbles: true}));
    const box = tip.getBoundingClientRect();
    const inside = box.left >= 0 && box.right <= innerWidth;
    if (!tip.hidden && words.length > 5 && tip.textContent === words && inside) ++told;
  }
  document.body.dispatchEvent(new PointerEvent('pointerover', {bubbles: true}));
  const unlabelled = [...document.querySelectorAll('svg:not([aria-hidden])')].filter(svg => !svg.getAttribute('aria-label')).length;
  const scrolling = [...document.querySelectorAll('figure > svg')].filter(
      svg => svg.getBoundingClientRect().right > innerWidth).length;
  const wide = document.documentElement.scrollWidth > innerWidth;
  parent.postMessage(`${innerWidth} px: points ${points.length} drawn ${drawn} told ${told} tip left ${!tip.hidden} ` +
                     `unlabelled ${unlabelled} too wide ${wide} scrolling figures ${scrolling} hidden ${hidden.length > 0}`, '*');
});
</script>)";

constexpr const char* around = R"(<!DOCTYPE html><meta charset="utf-8"><body>
<script>onmessage = (event) => { document.body.append(event.data, document.createElement('br')); };</script>
<iframe src="visited.html" width="390" height="800"></iframe><iframe src="visited.html" width="1200" height="800"></iframe>
)";

TEST(ReportPage, IsShownByABrowserAsItIsMeant) {
    const fs::path folder = fs::temp_directory_path() / ("flipside-page-" + std::to_string(getpid()));
    make_up_sweep(folder / "swept");
    make_report(
        {folder, {folder / "swept"}, tiny_effort()}, [](double) {},
        [](const std::string& sentence) { ADD_FAILURE() << sentence; });
    std::size_t points = 0;
    for (const auto& entry : fs::directory_iterator(folder / "data"))
        if (entry.path().filename().string().starts_with("figure-")) points += CsvTable(entry).rows();

    std::ostringstream page;
    page << std::ifstream(folder / "index.html").rdbuf() << visitor;
    std::ofstream(folder / "visited.html") << page.str();
    std::ofstream(folder / "around.html") << around;
    const Finished seen =
        run_program({"timeout", "100", "chromium", "--headless", "--no-sandbox", "--disable-gpu",
                     "--disable-dev-shm-usage", "--user-data-dir=" + (folder / "profile").string(),
                     "--enable-logging=stderr", "--virtual-time-budget=20000", "--dump-dom",
                     "file://" + (folder / "around.html").string()});
    EXPECT_EQ(seen.code, 0) << seen.said;
    EXPECT_EQ(seen.said.find("CONSOLE"), std::string::npos) << seen.said;
    const std::string all = std::to_string(points);
    for (const char* width : {"390", "1200"})
        EXPECT_NE(
            seen.said.find(width + (" px: points " + all + " drawn " + all + " told " + all) +
                           " tip left false unlabelled 0 too wide false scrolling figures 0 hidden true"),
            std::string::npos)
            << seen.said;
    fs::remove_all(folder);
}

}  // namespace
}  // namespace flipside::lab::report
