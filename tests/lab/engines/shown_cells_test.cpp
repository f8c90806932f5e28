/// What the engine shows of its broad phase's cells is what lies in them now.

#include <gtest/gtest.h>

#include "lab/contenders/engines.hpp"
#include "lab/files/assets.hpp"
#include "lab/session/session.hpp"
#include "world/scene_file.hpp"

namespace flipside::lab {
namespace {

struct ShownCell {
    double left = 0, bottom = 0, width = 0;  ///< m
    int count = 0;
    friend bool operator==(const ShownCell&, const ShownCell&) = default;
};

class CellList : public Inspector {
  public:
    std::vector<ShownCell> cells;

    [[nodiscard]] bool wants(Topic topic) const override { return topic == Topic::cells; }
    void cell(const Box& box, int count) override {
        cells.push_back({box.min.x, box.min.y, box.max.x - box.min.x, count});
    }
};

/// Those that list something.
std::vector<ShownCell> cells_of(const World& world) {
    CellList list;
    world.inspect(list);
    std::erase_if(list.cells, [](const ShownCell& cell) { return cell.count == 0; });
    return list.cells;
}

class ShownCells : public testing::TestWithParam<std::string_view> {
  protected:
    std::shared_ptr<const Scene> scene = std::make_shared<const Scene>(load_scene(scene_file("pinball")));
    const Engine& engine = engine_named("custom");

    Settings settings() const {
        Settings settings = settings_for(engine, *scene);
        const bool simple = GetParam() != "continuous";
        settings.set("solver", std::string_view(simple ? "simple" : "continuous"));
        if (simple) settings.set("broad_phase", GetParam());
        return settings;
    }
};

// An empty table, a game of three balls at once, and the table after that.
TEST_P(ShownCells, AreThoseOfTheTableAsItIsNow) {
    Settings fixed = settings();
    fixed.set("grid_cell", 0.04);
    Session session(scene, engine, fixed);
    bool played = false;
    for (int i = 0; i < 60 * 40; ++i) {
        const World& world = session.world();
        const auto cells = cells_of(world);
        if (GetParam() == "continuous") {
            // A ball is listed in one cell.
            int balls = 0;
            for (const ShownCell& cell : cells) balls += cell.count;
            ASSERT_LE(balls, world.balls().size()) << "at " << world.time() << " s";
        } else {
            const auto fresh = engine.make(scene, fixed);
            fresh->restore(world.save());
            ASSERT_EQ(cells, cells_of(*fresh)) << "at " << world.time() << " s";
        }
        if (i == 30) session.apply(control::Launch{0.7, 3, 1});
        session.step(1.0 / 60);
        played |= !session.world().balls().empty();
    }
    EXPECT_TRUE(played);
    EXPECT_TRUE(session.world().balls().empty());
}

// Nothing is found by cells as wide as the table.
TEST_P(ShownCells, AreNeverOneAsLargeAsTheTableThatListsAllOfIt) {
    const auto world = engine.make(scene, settings());
    for (const ShownCell& cell : cells_of(*world)) EXPECT_LT(cell.count, scene->parts.size());
}

INSTANTIATE_TEST_SUITE_P(OfEveryKind, ShownCells,
                         testing::Values("continuous", "brute", "sweep", "grid", "quadtree", "adaptive"));

}  // namespace
}  // namespace flipside::lab
