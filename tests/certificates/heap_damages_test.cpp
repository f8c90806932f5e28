// Certificates of static heaps that are damaged on purpose are rejected, and for the right reason.

#include <functional>
#include <set>

#include "certified_heaps.hpp"
#include "checking.hpp"
#include "in_small.hpp"
#include "lab/scenes/dice.hpp"

namespace flipside {
namespace {

constexpr const char *balance = "forces balance its weight", *torque = "spin changes by friction",
                     *cone = "friction within Coulomb's cone", *against = "friction against the slip",
                     *push = "contact force is at least 0", *touch = "touches what it rests on",
                     *stay = "stays in contact", *faces = "what it touches faces it",
                     *holds = "rests as long as forces hold it", *flies = "flies by the equation of motion";

/// One of the forces and the ball on which it acts.
struct Struck {
    HeapJson &run, &force, &leg;
    [[nodiscard]] double number(const char* what) const { return force[what].get<double>(); }
};
/// False where the force does not lend itself to it.
struct HeapDamage {
    const char* name;
    std::set<std::string> reasons;
    std::function<bool(const Struck&)> done;
};

bool add_to(HeapJson& number, double change) {
    number = number.get<double>() + change;
    return true;
}
bool on_wall(const Struck& at) {
    return at.force["other"] == -1;
}

const HeapDamage heap_damages[] = {
    {"a force scaled",
     {balance, torque},
     [](const Struck& at) {
         at.force["normal"] = 1.00001 * at.number("normal");
         at.force["friction"] = 1.00001 * at.number("friction");
         return at.number("normal") > 0.01;
     }},
    {"a force dropped",
     {balance, torque},
     [](const Struck& at) {
         const bool bears = at.number("normal") > 0.01;
         at.run["rests"][0]["forces"].erase(
             static_cast<std::size_t>(&at.force - &at.run["rests"][0]["forces"][0]));
         return bears;
     }},
    {"a force turned away from the normal",
     {torque, balance, cone},
     [](const Struck& at) {
         return at.number("normal") > 0.01 && add_to(at.force["friction"], 1e-5 * at.number("normal"));
     }},
    {"friction beyond the cone",
     {cone},
     [](const Struck& at) {
         at.force["friction"] = at.number("normal");  // µ is half
         return at.number("normal") > 0.01;
     }},
    {"a force that pulls",
     {push, cone},
     [](const Struck& at) {
         at.force["normal"] = -1e-3;
         at.force["friction"] = 0;
         return true;
     }},
    {"a ball lifted off", {touch}, [](const Struck& at) { return add_to(at.leg["position"][1], 4e-4); }},
    {"a ball pressed deep into the others",
     {touch},
     [](const Struck& at) { return add_to(at.leg["position"][1], -2e-3); }},
    {"a ball shifted by less than what counts as touching",
     {balance, torque},
     [](const Struck& at) { return at.number("normal") > 0.01 && add_to(at.leg["position"][0], 1e-5); }},
    {"a ball in the place of the topmost",
     {touch, faces},
     [](const Struck& at) {
         const HeapJson& top = at.run["balls"].back()["legs"][0];
         if (&top == &at.leg) return false;
         at.leg["position"] = top["position"];
         return true;
     }},
    {"a contact with the other wall",
     {touch, faces},
     [](const Struck& at) {
         if (!on_wall(at)) return false;
         // Both lines of the groove come before its points.
         at.force["feature"] = 1 - at.force["feature"].get<int>();
         return at.force["ball"] != 0;  // the lowest one touches both
     }},
    {"a contact with a part in place of a ball",
     {touch, faces, torque, balance},
     [](const Struck& at) {
         if (on_wall(at)) return false;
         at.force["other"] = -1;
         return true;
     }},
    {"a contact with a ball that is elsewhere",
     {touch},
     [](const Struck& at) {
         if (on_wall(at)) return false;
         const HeapJson& top = at.run["balls"].back()["number"];
         const char* const end = at.force["ball"] == 0 ? "other" : "ball";
         if (at.force["ball"] != 0 && at.force["other"] != 0) return false;
         at.force[end] = top;
         return true;
     }},
    {"a force on nobody",
     {balance, torque},
     [](const Struck& at) {
         at.force["ball"] = 99;
         return on_wall(at) && at.number("normal") > 0.01;
     }},
    {"a ball that creeps", {stay}, [](const Struck& at) { return add_to(at.leg["velocity"][1], 1e-6); }},
    {"a ball that turns",
     {against, "slips one way"},
     [](const Struck& at) { return add_to(at.leg["spin"], 1e-4); }},
    {"a heavier ball",
     {balance, torque},
     [](const Struck& at) {
         return add_to(at.run["balls"][at.force["ball"].get<std::size_t>()]["mass"], 1e-3);
     }},
    {"gravity aslant",
     {balance, torque},
     [](const Struck& at) { return add_to(at.run["gravity"][0], 1e-5); }},
    {"walls that give way",
     {stay},
     [](const Struck& at) {
         at.run["parts"][0]["turns"] = {{{"since", 0}, {"angle", 0}, {"rate", 1e-5}}};
         return true;
     }},
    {"smoother walls and balls",
     {cone},
     [](const Struck& at) {
         for (HeapJson& material : at.run["materials"]) material["friction"] = 1e-3;
         return true;
     }},
    {"forces that end too early",
     {holds},
     [](const Struck& at) {
         at.run["rests"][0]["until"] = 0.4;
         return true;
     }},
    {"no forces",
     {flies},
     [](const Struck& at) {
         at.run["rests"] = HeapJson::array();
         return true;
     }},
};

TEST(HeapDamages, AreRejectedForTheRightReason) {
    const HeapJson whole = certified(groove(3, 0.5));
    ASSERT_EQ(check_certificate(whole.dump()).code, 0);
    const std::size_t forces = whole["rests"][0]["forces"].size();
    lab::Dice dice(2026);
    constexpr int of_each = test::in_small ? 1 : 5;
    int rejected = 0;
    for (const HeapDamage& damage : heap_damages)
        for (int done = 0, tries = 0; done < of_each; ++tries) {
            ASSERT_LT(tries, 500) << damage.name;
            HeapJson run = whole;
            HeapJson& force =
                run["rests"][0]["forces"][static_cast<std::size_t>(dice.below(static_cast<double>(forces)))];
            HeapJson& leg = run["balls"][force["ball"].get<std::size_t>()]["legs"][0];
            if (!damage.done({run, force, leg})) continue;
            ++done;
            const Checked checked = check_certificate(run.dump());
            EXPECT_EQ(checked.code, 1) << damage.name << ": " << checked.says;
            const auto is_said = [&](const std::string& reason) {
                return checked.says.find(reason) != std::string::npos;
            };
            EXPECT_TRUE(std::ranges::any_of(damage.reasons, is_said)) << damage.name << ": " << checked.says;
            rejected += checked.code == 1;
        }
    std::printf("%d damaged heaps rejected\n", rejected);
}

/// A ball does not glide on past the end of what it lies on, though nothing is in its way there.
TEST(HeapDamages, AContactPastTheEndOfALineIsRejected) {
    Scene scene = empty_scene({0, -heap_gravity});
    add_part(scene, {shape::Segment{{0, 0}, {2, 0}}});
    add_ball(scene, {0.5, 0.1}, {1, 0}, 0.1);
    HeapJson run = certified(scene);
    ASSERT_EQ(check_certificate(run.dump()).code, 0) << check_certificate(run.dump()).says;
    // Half a second takes it to 1 m.
    for (HeapJson& feature : run["features"])
        for (HeapJson& point : feature["points"])
            if (point[0] == 2) point[0] = 0.9;
    const Checked checked = check_certificate(run.dump());
    EXPECT_EQ(checked.code, 1);
    EXPECT_NE(checked.says.find(faces), std::string::npos) << checked.says;
}

}  // namespace
}  // namespace flipside
