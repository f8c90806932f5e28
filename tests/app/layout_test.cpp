#include "app/window/layout.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace flipside::app {
namespace {

bool overlap(const Rect& a, const Rect& b) {
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height;
}

std::vector<Rect> all_of(const Layout& layout) {
    std::vector<Rect> all = layout.panes;
    all.insert(all.end(), layout.headers.begin(), layout.headers.end());
    all.push_back(layout.strip);
    if (layout.bar.height > 0) all.push_back(layout.bar);
    if (layout.scrubber.height > 0) all.push_back(layout.scrubber);
    if (layout.panel.width > 0) all.push_back(layout.panel);
    return all;
}

TEST(Layout, NothingOverlapsAndAllIsInsideTheWindow) {
    const double sizes[][2] = {{1024, 640}, {1280, 800}, {1920, 1080}, {3840, 2160}};
    for (const auto& size : sizes)
        for (const auto& [panes, headers] : {std::pair(1, 1), {1, 4}, {2, 2}, {3, 3}, {4, 4}})
            for (const double aspect : {0.5, 1.0, 3.0})
                for (const auto& [column, bar] :
                     {std::pair(Column::none, false), {Column::folded, true}, {Column::open, true}}) {
                    const auto all =
                        all_of(lay_out(size[0], size[1], 1, {panes, headers, aspect, column, bar, bar}));
                    for (std::size_t i = 0; i < all.size(); ++i) {
                        EXPECT_GE(all[i].x, 0);
                        EXPECT_GE(all[i].y, 0);
                        EXPECT_LE(all[i].x + all[i].width, size[0]);
                        EXPECT_LE(all[i].y + all[i].height, size[1]);
                        for (std::size_t j = i + 1; j < all.size(); ++j)
                            EXPECT_FALSE(overlap(all[i], all[j]));
                    }
                }
}

TEST(Layout, PlotsAreAsHighAsAskedWithinBounds) {
    const auto strip_of = [](double asked, bool bar, double height = 800) {
        return lay_out(1280, height, 1, {2, 2, 0.5, Column::open, bar, true, asked}).strip.height;
    };
    EXPECT_EQ(strip_of(0, false), 120);
    EXPECT_EQ(strip_of(200, false), 200);
    EXPECT_EQ(strip_of(1, false), 80);
    EXPECT_EQ(strip_of(5000, false), 360);
    EXPECT_EQ(strip_of(5000, true), 176);
    EXPECT_LE(strip_of(5000, true, 300), 66);
    for (const double height : {400.0, 640.0, 800.0})
        for (const bool bar : {false, true}) {
            const Layout layout = lay_out(1024, height, 1, {4, 4, 1, Column::open, bar, true, 5000});
            EXPECT_GE(layout.panes.back().height, 1);
            EXPECT_LE(layout.strip.y + layout.strip.height, height);
            EXPECT_FALSE(overlap(layout.strip, layout.scrubber));
        }
}

TEST(Layout, PanesAreEqualAndOnWholePixels) {
    for (const int panes : {2, 3, 4}) {
        const Layout layout = lay_out(1281, 797, 1, {panes, panes, 1.3, Column::open, false});
        ASSERT_EQ(layout.panes.size(), static_cast<std::size_t>(panes));
        for (const Rect& pane : layout.panes) {
            EXPECT_EQ(pane.width, layout.panes[0].width);
            EXPECT_EQ(pane.height, layout.panes[0].height);
            for (const double side : {pane.x, pane.y, pane.width, pane.height})
                EXPECT_EQ(side, std::floor(side));
        }
    }
}

TEST(Layout, ThePanesAreTheLargestThing) {
    const Layout layout = lay_out(1024, 640, 1, {2, 2, 0.5, Column::open, false});
    const double panes = 2 * layout.panes[0].width * layout.panes[0].height;
    EXPECT_GT(panes, layout.panel.width * layout.panel.height);
    EXPECT_GT(panes, 0.44 * 1024 * 640);
}

TEST(Layout, LargeLettersInALowWindowLeaveRoomForTheTables) {
    const auto lines = [](double height, double scale) {
        const Layout layout = lay_out(1024, height, scale, {2, 2, 0.5, Column::open, true, true});
        return lines_of_facts(layout.headers[0].height / scale);
    };
    EXPECT_EQ(lines(640, 2), 1);
    EXPECT_EQ(lines(1280, 2), 4);
    EXPECT_GT(lay_out(1024, 640, 2, {2, 2, 0.5, Column::open, true, true}).panes[0].height, 80);

    // The step bar is readable there: plots make way for it.
    const Layout inside = lay_out(1280, 720, 2, {2, 2, 0.5, Column::open, true, true});
    EXPECT_EQ(inside.strip.height, 0);
    EXPECT_GT(inside.bar.height, 290);
    EXPECT_GT(inside.panes[0].height, 150);
    EXPECT_GT(lay_out(1280, 720, 2, {2, 2, 0.5, Column::open, false, true}).strip.height, 100);
    EXPECT_GT(lay_out(1024, 640, 1, {2, 2, 0.5, Column::open, true, true}).strip.height, 100);
}

TEST(Layout, TheLargestLettersLeaveRoomBesideTheOpenColumn) {
    for (const auto& [width, height] : {std::pair(800, 600), {1280, 720}, {1280, 800}, {1920, 1080}}) {
        const double scale = largest_scale(width, height);
        EXPECT_GT(lay_out(width, height, scale, {2, 2, 0.5, Column::open, true, true}).panel.x, 0.45 * width);
    }
    EXPECT_EQ(largest_scale(1280, 720), 2);
    EXPECT_EQ(largest_scale(3840, 2160), most_scale);
}

TEST(Layout, FoldingThePanelGivesItsRoomToThePanes) {
    const Layout open = lay_out(1280, 800, 1, {2, 2, 0.5, Column::open, false});
    const Layout folded = lay_out(1280, 800, 1, {2, 2, 0.5, Column::folded, false});
    EXPECT_GT(folded.panes[0].width, open.panes[0].width + 100);
}

TEST(Layout, PortraitTablesStandSideBySideAndLandscapeOnesOneBelowTheOther) {
    const auto panes_of = [](int panes, double aspect) {
        return lay_out(1280, 800, 1, {panes, panes, aspect, Column::open, false}).panes;
    };
    EXPECT_EQ(panes_of(2, 0.5)[0].y, panes_of(2, 0.5)[1].y);
    EXPECT_EQ(panes_of(2, 2.5)[0].x, panes_of(2, 2.5)[1].x);
    EXPECT_EQ(panes_of(4, 0.5)[0].y, panes_of(4, 0.5)[3].y);
    const auto square = panes_of(4, 1.3);
    EXPECT_EQ(square[0].y, square[1].y);
    EXPECT_EQ(square[0].x, square[2].x);
    EXPECT_LT(square[0].y, square[2].y);
}

}  // namespace
}  // namespace flipside::app
