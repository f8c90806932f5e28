#include "app/window/camera.hpp"

#include <gtest/gtest.h>

namespace flipside::app {
namespace {

Camera fitted() {
    Camera camera;
    camera.size = {400, 300};
    camera.fit({{0, 0}, {1, 2}}, 10);
    return camera;
}

TEST(Camera, FitShowsTheWholeBoxCentredWithItsMargin) {
    const Camera camera = fitted();
    // 280 px of height for 2 m decide.
    EXPECT_DOUBLE_EQ(camera.scale, 140);
    const Vec2 top = camera.to_pixels({0.5, 2}), bottom = camera.to_pixels({0.5, 0});
    EXPECT_NEAR(top.x, 200, 1e-9);
    EXPECT_NEAR(top.y, 10, 1e-9);
    EXPECT_NEAR(bottom.y, 290, 1e-9);
}

TEST(Camera, PixelsAndMetresAreInverse) {
    const Camera camera = fitted();
    for (const Vec2 p : {Vec2{0, 0}, Vec2{0.3, 1.7}, Vec2{-4, 9}}) {
        const Vec2 back = camera.to_metres(camera.to_pixels(p));
        EXPECT_NEAR(back.x, p.x, 1e-12);
        EXPECT_NEAR(back.y, p.y, 1e-12);
    }
}

TEST(Camera, ZoomKeepsWhatLiesUnderTheMouse) {
    Camera camera = fitted();
    const Vec2 mouse{37, 211};
    const Vec2 before = camera.to_metres(mouse);
    camera.zoom(mouse, 1.7);
    const Vec2 after = camera.to_metres(mouse);
    EXPECT_DOUBLE_EQ(camera.scale, 140 * 1.7);
    EXPECT_NEAR(after.x, before.x, 1e-12);
    EXPECT_NEAR(after.y, before.y, 1e-12);
}

TEST(Camera, ZoomHasLimits) {
    Camera camera = fitted();
    camera.zoom({0, 0}, 1e30);
    EXPECT_EQ(camera.scale, 1e6);
    camera.zoom({0, 0}, 1e-30);
    EXPECT_EQ(camera.scale, 1);
}

TEST(Camera, PanMovesTheTableWithTheMouse) {
    Camera camera = fitted();
    const Vec2 point{0.25, 0.75};
    const Vec2 before = camera.to_pixels(point);
    camera.pan({12, -30});
    const Vec2 after = camera.to_pixels(point);
    EXPECT_NEAR(after.x - before.x, 12, 1e-9);
    EXPECT_NEAR(after.y - before.y, -30, 1e-9);
}

}  // namespace
}  // namespace flipside::app
