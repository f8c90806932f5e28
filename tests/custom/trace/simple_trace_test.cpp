// The trace of a step of the simple solver: each stage can be computed again from the stages before it.

#include <map>
#include <set>

#include <gtest/gtest.h>

#include "custom/flight.hpp"
#include "custom/layout.hpp"
#include "custom/response.hpp"
#include "custom/scenes.hpp"
#include "custom/tolerances.hpp"
#include "lab/files/assets.hpp"
#include "world/scene_file.hpp"
#include "world/surface.hpp"

namespace flipside::custom {
namespace {

/// The balls according to the trace so far; checks the next items against them.
class Recomputed {
  public:
    Recomputed(const Scene& scene, const World& world, double driven)
        : scene_(scene), primitives_(surface_of(scene)), around_{scene.gravity, scene.rest_speed, driven} {
        for (const Ball& ball : world.balls()) balls_[ball.number] = ball;
    }

    void check(const TraceStage& stage, const TraceStage* next) {
        SCOPED_TRACE(stage.name);
        EXPECT_FALSE(stage.says.empty());
        EXPECT_TRUE(stage.where.find(".cpp: ") != std::string::npos) << stage.where;
        if (stage.name.starts_with("move")) return check_moves(stage);
        if (stage.name.starts_with("broad phase")) return check_pairs(stage);
        if (stage.name.starts_with("narrow phase")) return check_round(stage, *next);
        if (stage.name == "read-out") check_read_out(stage);
    }
    int responses() const { return responses_; }

  private:
    static BallNumber ball_in(const TraceItem& item, const char* name = "ball") {
        return static_cast<BallNumber>(item.get<std::int64_t>(name));
    }

    void check_moves(const TraceStage& stage) {
        EXPECT_EQ(stage.items.size(), balls_.size());
        for (const TraceItem& item : stage.items) {
            Ball& ball = balls_.at(ball_in(item));
            EXPECT_EQ(item.get<Vec2>("position_before"), ball.position);
            EXPECT_EQ(item.get<Vec2>("velocity_before"), ball.velocity);
            const TimeInterval interval(item.get<double>("damping"), item.get<double>("seconds"));
            fly_freely(ball, item.get<Vec2>("gravity"), interval);
            EXPECT_EQ(item.get<Vec2>("position"), ball.position);
            EXPECT_EQ(item.get<Vec2>("velocity"), ball.velocity);
            EXPECT_EQ(item.get<double>("angle"), ball.angle);
        }
    }

    using Thing = std::pair<bool, std::int64_t>;  ///< number of a ball, or index of a primitive
    static Thing thing(const TraceItem& item, const std::string& prefix) {
        const TraceValue* ball = item.find(prefix + "ball");
        return ball != nullptr ? Thing{true, std::get<std::int64_t>(*ball)}
                               : Thing{false, item.get<std::int64_t>("primitive")};
    }

    void check_pairs(const TraceStage& stage) {
        std::map<Thing, Box> boxes;
        pairs_.clear();
        for (const TraceItem& item : stage.items)
            if (item.kind == "box") boxes[thing(item, "")] = item.get<Box>("box");
        for (const TraceItem& item : stage.items) {
            if (item.kind != "test") continue;
            const Thing a = thing(item, ""), b = item.find("primitive")
                                                     ? Thing{false, item.get<std::int64_t>("primitive")}
                                                     : thing(item, "other_");
            EXPECT_EQ(item.get<bool>("overlap"), overlap(boxes.at(a), boxes.at(b)));
            if (item.get<bool>("overlap")) pairs_.insert(std::minmax(a, b));
        }
        for (const auto& [number, ball] : balls_) {
            EXPECT_EQ(boxes.at({true, number}), bounds_of(ball.position, ball.radius));
            for (const auto& [other, box] : boxes) {
                const bool same = other == Thing{true, number};
                const bool meets = other.first
                                       ? layers_meet(ball, balls_.at(static_cast<BallNumber>(other.second)))
                                       : layers_meet(ball, part_of(other.second));
                if (!same && meets && overlap(box, boxes.at({true, number}))) {
                    EXPECT_TRUE(pairs_.contains(std::minmax(other, Thing{true, number})));
                }
            }
        }
    }

    [[nodiscard]] const Part& part_of(std::int64_t primitive) const {
        return scene_.parts[layout_.primitive(static_cast<PrimitiveIndex>(primitive)).part];
    }

    /// Narrow phase and response alternate.
    void check_round(const TraceStage& narrow, const TraceStage& response) {
        ASSERT_TRUE(response.name.starts_with("response"));
        auto answer = response.items.begin();
        for (const TraceItem& item : narrow.items) {
            if (item.kind != "closest") continue;
            const Touch found = check_closest(item);
            const bool answered = answer != response.items.end() &&
                                  answer->get<std::int64_t>("turn") == item.get<std::int64_t>("turn");
            EXPECT_EQ(answered, item.get<bool>("overlap"));
            if (answered) check_response(item, found, *answer++);
        }
        EXPECT_EQ(answer, response.items.end());
    }

    Touch check_closest(const TraceItem& item) {
        const Ball& ball = balls_.at(ball_in(item));
        EXPECT_EQ(item.get<Vec2>("center"), ball.position);
        EXPECT_TRUE(pairs_.contains(std::minmax(
            Thing{true, ball.number}, item.find("primitive") ? thing(item, "no ") : thing(item, "other_"))));
        Touch found;
        if (item.find("other_ball") != nullptr) {
            const Ball& other = balls_.at(ball_in(item, "other_ball"));
            found = touch(ball.position, ball.radius, other.position, other.radius);
        } else {
            const Primitive& primitive =
                layout_.primitive(static_cast<PrimitiveIndex>(item.get<std::int64_t>("primitive")));
            found = touch(ball.position, ball.radius, primitive,
                          {item.get<Vec2>("pivot"), item.get<double>("pose_angle")});
        }
        EXPECT_EQ(item.get<Vec2>("point"), found.point);
        EXPECT_EQ(item.get<Vec2>("normal"), found.normal);
        EXPECT_EQ(item.get<double>("separation"), found.separation);
        EXPECT_FALSE(item.get<std::string>("filled").empty());
        EXPECT_FALSE(item.get<std::string>("feature").empty());
        if (const TraceValue* heights = item.find("heights")) {
            const double most = *std::ranges::max_element(std::get<std::vector<double>>(*heights));
            EXPECT_LE(most, found.separation + ball.radius + 1e-12);
        }
        return found;
    }

    void check_response(const TraceItem& seen, const Touch& found, const TraceItem& item) {
        ++responses_;
        Ball& ball = balls_.at(ball_in(item));
        EXPECT_EQ(item.get<Vec2>("velocity_before"), ball.velocity);
        Impact impact;
        if (const TraceValue* number = seen.find("other_ball")) {
            Ball& other = balls_.at(static_cast<BallNumber>(std::get<std::int64_t>(*number)));
            impact = respond(ball, other, layout_.mixed(ball, other), around_);
            push_out(ball, other, found);
            EXPECT_EQ(item.get<Vec2>("other_velocity"), other.velocity);
            EXPECT_EQ(item.get<Vec2>("other_position"), other.position);
        } else {
            const auto primitive = static_cast<PrimitiveIndex>(seen.get<std::int64_t>("primitive"));
            const Part& part = scene_.parts[layout_.primitive(primitive).part];
            impact =
                respond(ball, found, item.get<Vec2>("surface_velocity"), layout_.mixed(ball, part), around_);
            push_out(ball, found);
        }
        EXPECT_EQ(item.get<Vec2>("velocity"), ball.velocity);
        EXPECT_EQ(item.get<double>("spin"), ball.spin);
        EXPECT_EQ(item.get<Vec2>("position"), ball.position);
        EXPECT_EQ(item.get<double>("impulse"), impact.impulse);
        EXPECT_EQ(item.get<double>("speed"), impact.speed);
        EXPECT_EQ(item.get<std::string>("answer") == "impact", impact.happened);
    }

    void check_read_out(const TraceStage& stage) const {
        for (const TraceItem& item : stage.items) {
            if (item.kind != "ball") continue;
            const Ball& ball = balls_.at(ball_in(item));
            EXPECT_EQ(item.get<Vec2>("position"), ball.position);
            EXPECT_EQ(item.get<Vec2>("velocity"), ball.velocity);
            EXPECT_EQ(item.get<double>("spin"), ball.spin);
        }
    }

    const Scene& scene_;
    std::vector<Primitive> primitives_;
    Layout layout_{scene_};
    Surroundings around_;
    std::map<BallNumber, Ball> balls_;
    std::set<std::pair<Thing, Thing>> pairs_;
    int responses_ = 0;
};

/// Traces every `every`-th of so many steps of a scene.
int check_scene(const char* name, const char* broad_phase, int steps, int every) {
    SCOPED_TRACE(name);
    const Scene scene = load_scene(lab::scene_file(name));
    const auto world = test::make_world(scene, {{"solver", "simple"},
                                                {"broad_phase", broad_phase},
                                                {"motion_iterations", "2"},
                                                {"collision_iterations", "3"}});
    constexpr double dt = 1.0 / 60;
    int responses = 0;
    if (scene.launcher) world->apply(control::Launch{1});
    for (int k = 0; k < steps; ++k) {
        if (k % every != 0 || k == 0) {
            world->step(dt);
            continue;
        }
        Recomputed recomputed(scene, *world, dt / 2);
        Trace trace;
        world->trace(&trace);
        world->step(dt);
        world->trace(nullptr);
        for (std::size_t i = 0; i < trace.stages.size(); ++i)
            recomputed.check(trace.stages[i], i + 1 < trace.stages.size() ? &trace.stages[i + 1] : nullptr);
        EXPECT_EQ(trace.stages.back().name, "read-out");
        std::size_t told = 0;
        for (const TraceItem& item : trace.stages.back().items) told += item.kind == "ball";
        EXPECT_EQ(told, world->balls().size());
        responses += recomputed.responses();
    }
    return responses;
}

TEST(SimpleTrace, EveryStageFollowsFromWhatWasWrittenBefore) {
    int responses = 0;
    for (const char* broad_phase : {"brute", "quadtree", "adaptive", "grid", "sweep"}) {
        SCOPED_TRACE(broad_phase);
        for (const char* name : {"toy", "box", "bowl", "cradle", "drop"})
            responses += check_scene(name, broad_phase, 200, 41);
        responses += check_scene("pinball", broad_phase, 300, 37);
    }
    responses += check_scene("rain", "grid", 181, 90);
    EXPECT_GT(responses, 500);
}

TEST(SimpleTrace, ChangesNoBit) {
    const Scene scene = load_scene(lab::scene_file("box"));
    const auto traced = test::make_world(scene, {{"solver", "simple"}});
    const auto plain = test::make_world(scene, {{"solver", "simple"}});
    Trace trace;
    traced->trace(&trace);
    test::run(*traced, 2);
    test::run(*plain, 2);
    EXPECT_EQ(traced->save(), plain->save());
    EXPECT_EQ(traced->statistics().pair_tests, plain->statistics().pair_tests);
}

/// The broad phase of a step among many balls.
TraceStage broad_phase_stage(const char* broad_phase) {
    Scene scene = load_scene(lab::scene_file("rain"), 120);
    const auto world = test::make_world(scene, {{"solver", "simple"},
                                                {"motion_iterations", "1"},
                                                {"broad_phase", broad_phase},
                                                {"adaptive_capacity", "3"}});
    test::run(*world, 0.5);
    Trace trace;
    world->trace(&trace);
    test::run(*world, 1.0 / 60);
    return trace.stages[1];
}

using CellName = std::pair<bool, std::int64_t>;  ///< of the still tree, index

std::map<CellName, const TraceItem*> cells_of(const TraceStage& stage) {
    std::map<CellName, const TraceItem*> cells;
    for (const TraceItem& item : stage.items)
        if (item.kind == "cell") {
            const CellName name{item.get<bool>("of_still"), item.get<std::int64_t>("cell")};
            EXPECT_TRUE(cells.insert({name, &item}).second);
        }
    return cells;
}

TEST(SimpleTrace, CellsOfTreesAreQuartersOfTheirParents) {
    for (const char* tree : {"quadtree", "adaptive"}) {
        SCOPED_TRACE(tree);
        const TraceStage stage = broad_phase_stage(tree);
        const auto cells = cells_of(stage);
        ASSERT_GT(cells.size(), 40U);
        std::size_t roots = 0;
        for (const auto& [name, cell] : cells) {
            if (cell->find("parent") == nullptr) {
                EXPECT_EQ(name.second, 0);
                EXPECT_EQ(cell->get<std::int64_t>("level"), 0);
                ++roots;
                continue;
            }
            const auto above = cells.find({name.first, cell->get<std::int64_t>("parent")});
            ASSERT_NE(above, cells.end());
            if (tree == std::string("quadtree")) {
                EXPECT_EQ(above->first.second, (name.second - 1) / 4);
            }
            const Box &box = cell->get<Box>("box"), &parent = above->second->get<Box>("box");
            EXPECT_EQ(cell->get<std::int64_t>("level"), above->second->get<std::int64_t>("level") + 1);
            EXPECT_NEAR(box.max.x - box.min.x, 0.5 * (parent.max.x - parent.min.x), 1e-12);
            EXPECT_NEAR(box.max.y - box.min.y, 0.5 * (parent.max.y - parent.min.y), 1e-12);
            EXPECT_TRUE(box.min.x == parent.min.x || box.max.x == parent.max.x);
            EXPECT_TRUE(box.min.y == parent.min.y || box.max.y == parent.max.y);
        }
        EXPECT_EQ(roots, tree == std::string("quadtree") ? 1U : 2U);
    }
}

TEST(SimpleTrace, EveryTestIsInACellThatItsSearchWentTo) {
    for (const char* tree : {"quadtree", "adaptive"}) {
        SCOPED_TRACE(tree);
        const TraceStage stage = broad_phase_stage(tree);
        const auto cells = cells_of(stage);
        std::map<std::int64_t, const TraceItem*> searches;
        for (const TraceItem& item : stage.items)
            if (item.kind == "search") searches[item.get<std::int64_t>("ball")] = &item;
        EXPECT_EQ(searches.size(), 120U);
        std::size_t tests = 0;
        for (const TraceItem& item : stage.items) {
            if (item.kind != "test") continue;
            ++tests;
            const bool still = item.get<bool>("of_still");
            const auto cell = item.get<std::int64_t>("cell");
            ASSERT_TRUE(cells.contains({still, cell}));
            EXPECT_GT(cells.at({still, cell})->get<std::int64_t>("listed"), 0);
            const auto& went_to = searches.at(item.get<std::int64_t>("search_of_ball"))
                                      ->get<std::vector<double>>(still ? "still_cells" : "cells");
            EXPECT_EQ(std::ranges::count(went_to, static_cast<double>(cell)), 1);
        }
        EXPECT_GT(tests, 100U);
    }
}

}  // namespace
}  // namespace flipside::custom
