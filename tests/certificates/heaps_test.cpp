// Certificates of static heaps: what is accepted, and that no wrong contact force is.

#include "certified_heaps.hpp"
#include "checking.hpp"

namespace flipside {
namespace {

TEST(HeapCertificates, AreAccepted) {
    for (const Scene& scene : {column(2), column(10), groove(4, 0), groove(4, 0.5)}) {
        const HeapJson run = certified(scene);
        ASSERT_EQ(run["rests"].size(), 1U);
        EXPECT_GE(run["rests"][0]["forces"].size(), scene.balls.size());
        const Checked checked = check_certificate(run.dump());
        EXPECT_EQ(checked.code, 0) << checked.says;
        EXPECT_NE(checked.says.find(std::to_string(scene.balls.size()) + " at rest)"), std::string::npos)
            << checked.says;
    }
}

TEST(HeapCertificates, OfABallBetweenTwoPartsToo) {
    Scene scene = groove(0, 0.3);
    scene.balls[0].position = {0, 0.2};
    scene.balls[0].spin = 30;  // it is rubbed to rest
    const HeapJson run = certified(scene);
    ASSERT_EQ(run["rests"].size(), 2U);
    EXPECT_EQ(check_certificate(run.dump()).code, 0) << check_certificate(run.dump()).says;
    HeapJson other = run;
    other["rests"][0]["forces"][0]["friction"] = -run["rests"][0]["forces"][0]["friction"].get<double>();
    EXPECT_EQ(check_certificate(other.dump()).code, 1);
}

/// No ball of a heap is in the way of a cheat: one that is at rest by forces from a ball that is not.
TEST(HeapCertificates, ForcesActOnBothSides) {
    HeapJson run = certified(column(2));
    HeapJson& forces = run["rests"][0]["forces"];
    // The lower ball no longer carries the upper one: the floor bears its own weight alone.
    for (HeapJson& force : forces)
        if (force["other"] == -1) force["normal"] = heap_gravity;
    EXPECT_EQ(check_certificate(run.dump()).code, 1);
    // Nor by a rest of its own beside that of the upper one.
    HeapJson own = certified(column(2));
    HeapJson rest = own["rests"][0];
    rest["forces"] = {
        {{"ball", 0}, {"other", -1}, {"feature", 0}, {"normal", heap_gravity}, {"friction", 0.0}}};
    own["rests"].insert(own["rests"].begin(), rest);
    const Checked checked = check_certificate(own.dump());
    EXPECT_EQ(checked.code, 1);
    EXPECT_NE(checked.says.find("forces balance its weight"), std::string::npos) << checked.says;
}

TEST(HeapCertificates, OnWhatCannotBeTouchedAreRejected) {
    HeapJson run = certified(column(2));
    run["parts"][0]["collides_with"] = 0;
    EXPECT_NE(check_certificate(run.dump()).says.find("can be touched"), std::string::npos);
    HeapJson layers = certified(column(2));
    layers["balls"][1]["collides_with"] = 0;
    EXPECT_NE(check_certificate(layers.dump()).says.find("can be touched"), std::string::npos);
}

}  // namespace
}  // namespace flipside
