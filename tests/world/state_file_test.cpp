#include "world/state_file.hpp"

#include <bit>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <rapidcheck/gtest.h>

#include "world/support.hpp"
#include "world/table.hpp"

namespace flipside {
namespace {

State a_state(double number) {
    State state;
    const double time = std::abs(number), ulp = std::nextafter(time, INFINITY) - time;
    state.clock = {time, number < 0 ? -ulp : ulp};
    state.next_number = 4'294'967'295;
    Ball ball;
    ball.number = 2;
    ball.position = {number, -number / 3};
    ball.velocity = {-0.0, 5e-324};
    ball.angle = number * 7;
    ball.spin = 1 / (1 + std::abs(number));
    ball.radius = 0.1;
    ball.mass = 1.0 / 3;
    ball.material = 2;
    ball.layer = 4;
    ball.collides_with = 0x80000001;
    ball.asleep = true;
    Ball other;
    other.number = 4'294'967'294;
    other.radius = other.mass = 1;
    state.balls = {ball, other};
    state.parts.resize(6);
    state.parts[1].angle = 1.0 / 3;
    state.parts[2].angle = number;
    state.parts[3].open = number < 0;
    if (number >= 0) state.blocked = {{3, 2}, {3, 4'294'967'294}};
    state.parts[5].down = true;
    state.raised[1] = true;
    state.rotating = true;
    state.launches = {{1.0 / 3, 5, 2}, {0, 1, 1}};
    state.next_look = next_look(state.clock.time);
    state.reported_lost = {4'294'967'294};
    state.memory = {"custom",
                    state.clock.time,
                    {{2, 4'294'967'294, 1 / (1 + std::abs(number)), -number}},
                    {{2, 3}, {4'294'967'294, 3}}};
    return state;
}

std::uint64_t bits(double x) {
    return std::bit_cast<std::uint64_t>(x);
}

RC_GTEST_PROP(StateFile, ReadsBackToTheSameBits, ()) {
    // Any double of a size that states may hold, built from its bits.
    const auto drawn = std::bit_cast<double>(*rc::gen::arbitrary<std::uint64_t>());
    RC_PRE(std::isfinite(drawn) && std::abs(drawn) < 1e11);
    const Scene scene = scene_with_everything();
    State before = a_state(drawn);
    before.origin = std::make_shared<const State>(a_state(drawn / 2));
    const std::string text = to_json(before, scene);
    const State after = parse_state(text, "state.json", scene);
    RC_ASSERT(after.clock == before.clock);
    RC_ASSERT(after.next_number == before.next_number);
    RC_ASSERT(after.balls == before.balls);
    RC_ASSERT(bits(after.balls[0].position.x) == bits(before.balls[0].position.x));
    RC_ASSERT(bits(after.balls[0].velocity.x) == bits(-0.0));
    RC_ASSERT(after.parts == before.parts);
    RC_ASSERT(!after.raised[0] && after.raised[1] && after.rotating);
    RC_ASSERT(after.launches.size() == 2U && after.launches[0].strength == 1.0 / 3);
    RC_ASSERT(after.reported_lost == before.reported_lost);
    RC_ASSERT(after.memory == before.memory);
    RC_ASSERT(after.blocked == before.blocked);
    RC_ASSERT(after.origin->balls == before.origin->balls);
    RC_ASSERT(after.origin->origin == nullptr);
    RC_ASSERT(to_json(after, scene) == text);
}

TEST(StateFile, BadOnesAreRefusedWithTheirPlace) {
    using Json = nlohmann::json;
    struct Bad {
        std::string pointer;  ///< what is replaced by `value`
        Json value;
        std::string error_at, says;
    };
    const Scene scene = scene_with_everything();
    const Json earlier = Json::parse(to_json(a_state(0.125), scene));
    const Json flat = {{"number", 0}, {"position", {0, 0}}, {"velocity", {0, 0}}, {"radius", 1}, {"mass", 1}};
    const Bad all[] = {
        {"/format", "flipside-scene/1", "/format", "flipside-state/1"},
        {"/scene", "another", "/scene", "is a state of \"another\"; allowed is one of \"everything\""},
        {"/table", "0123456789abcdef", "/table",
         "of another \"everything\", with other bounds, layers or parts"},
        {"/table", "x", "/table", "x"},
        {"/colour", 1, "/colour", "unknown key"},
        {"/time", -1, "/time", "from 0"},
        {"/time", nullptr, "/time", "is null"},
        {"/time_remainder", 1e-3, "/time_remainder", "more than the rounding of the time; allowed: from -"},
        {"/balls/0/position/0", 1e13, "/balls/0/position/0", "1000000000000"},
        {"/next_number", 0.5, "/next_number", "whole number"},
        {"/next_number", 4294967296, "/next_number", "to 4294967295"},
        {"/next_number", 3, "/balls/1/number", "not below next_number"},
        {"/balls", 3, "/balls", "an array"},
        {"/balls/0/radius", 0, "/balls/0/radius", "is 0"},
        {"/balls/0/mass", -1, "/balls/0/mass", "is -1"},
        {"/balls/0/position", {0, "x"}, "/balls/0/position/1", "a number"},
        {"/balls/0/velocity/0", 1e300, "/balls/0/velocity/0", "1e+300"},
        {"/balls/0/material", "gold", "/balls/0/material", "allowed: \"rubber\", \"steel\""},
        {"/balls/0/layer", 3, "/balls/0/layer", "power of two"},
        {"/balls/0/number", 4294967294, "/balls/1/number", "rising numbers"},
        {"/balls/2", flat, "/balls/2/number", "rising numbers"},
        {"/parts/nobody", {{"angle", 1}}, "/parts/nobody", "no such part; allowed: \"wall\""},
        {"/parts/wall", {{"angle", 1}}, "/parts/wall/angle", "does not move"},
        {"/parts/wall", {{"open", true}}, "/parts/wall/open", "no gate"},
        {"/parts/wall", {{"down", true}}, "/parts/wall/down", "no drop target"},
        {"/parts/bat/angle", 1.1, "/parts/bat/angle", "beyond the flipper's stops"},
        {"/parts/bat/angle", -0.1, "/parts/bat/angle", "beyond the flipper's stops"},
        {"/raised/0", "middle", "/raised/0", "left, right"},
        {"/launches/0/count", 0, "/launches/0/count", "from 1 to 1000"},
        {"/next_look", 1e9, "/next_look", "is too late; allowed: up to "},
        {"/raised/1", "right", "/raised/1", "is here twice"},
        {"/reported_lost/1", 4294967294, "/reported_lost", "has ball 4294967294 more than once"},
        {"/reported_lost/0", 7, "/reported_lost/0", "no ball has this number"},
        {"/blocked/0/ball", 7, "/blocked/0/ball", "no ball has this number"},
        {"/blocked/0/gate", "wall", "/blocked/0/gate", "no gate of this scene; allowed: \"gate\""},
        {"/blocked/1/ball", 2, "/blocked/1", "by gate, then ball"},
        {"/parts/gate", {{"open", true}}, "/blocked/0/gate", "is open"},
        {"/memory/forces/0/a", 7, "/memory/forces/0/a", "no ball has this number"},
        {"/memory/forces/0/b", 2, "/memory/forces/0/b", "rising numbers"},
        {"/memory/forces/0/normal", -1, "/memory/forces/0/normal", "is -1"},
        {"/memory/forces/1",
         {{"a", 2}, {"b", 4294967294}, {"normal", 1}},
         "/memory/forces/1",
         "by rising b, then a"},
        {"/memory/inside/0/ball", 7, "/memory/inside/0/ball", "no ball has this number"},
        {"/memory/inside/0/part", "wall", "/memory/inside/0/part",
         "no sensor or gate of this scene; allowed: \"gate\""},
        {"/memory/inside/1/ball", 2, "/memory/inside/1", "by ball, then part"},
        {"/origin/time", 0.5, "/origin/time", "after that of the state; allowed: up to 0.25"},
        {"/origin/origin", earlier, "/origin/origin", "allowed is one origin"},
        {"/origin/balls/0/mass", -1, "/origin/balls/0/mass", "is -1"},
        {"/origin/scene", "another", "/origin/scene", "is a state of \"another\""},
    };
    State state = a_state(0.25);
    state.origin = std::make_shared<const State>(a_state(0.125));
    const Json good = Json::parse(to_json(state, scene));
    for (const Bad& bad : all) {
        Json text = good;
        text[Json::json_pointer(bad.pointer)] = bad.value;
        expect_error(error_of([&] { (void)parse_state(text.dump(), "state.json", scene); }),
                     "state.json: " + bad.error_at + ": ", bad.says);
    }
}

TEST(StateFile, IsOfOneTableNotOfAllWithItsName) {
    const Scene scene = scene_with_everything();
    const std::string text = to_json(a_state(0.25), scene);
    const auto refusal = [&](const auto& change) {
        Scene other = scene;
        change(other);
        return error_of([&] { (void)parse_state(text, "state.json", other); });
    };
    for (const std::string& error : {
             refusal([](Scene& other) { other.bounds.max.x = 0.5; }),
             refusal([](Scene& other) { other.keep_lost = true; }),
             refusal([](Scene& other) { other.layers.emplace_back("upper"); }),
             refusal([](Scene& other) { std::get<motion::Turn>(other.parts[2].motion).rate = 4; }),
             refusal([](Scene& other) { std::get<shape::Segment>(other.parts[0].shape.is).a.y = -0.9; }),
             refusal([](Scene& other) { other.parts.pop_back(); }),
         })
        expect_error(error, "state.json: /table: ", "allowed is one of the same table");
    const std::string accepted = refusal([](Scene& other) {
        other.gravity = {0, 3}, other.damping = 1, other.materials[1].restitution = 0, other.balls.clear();
    });
    EXPECT_EQ(accepted, "no error");
}

TEST(StateFile, FromBeforeTablesHadFingerprintsMustLieInTheBounds) {
    const Scene scene = scene_with_everything();
    auto old = nlohmann::json::parse(to_json(a_state(0.25), scene));
    old.erase("table");
    (void)parse_state(old.dump(), "old.json", scene);
    old["balls"][1]["position"] = {5, 0};  // was reported lost
    (void)parse_state(old.dump(), "old.json", scene);
    old["balls"][0]["position"] = {0, 5};
    expect_error(error_of([&] { (void)parse_state(old.dump(), "old.json", scene); }),
                 "old.json: /balls/0/position: ", "x from -1 to 1, y from -1 to 1");
}

}  // namespace
}  // namespace flipside
