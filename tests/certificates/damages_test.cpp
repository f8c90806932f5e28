// Certificates that are damaged on purpose are rejected.

#include <functional>

#include <nlohmann/json.hpp>

#include "checking.hpp"
#include "in_small.hpp"
#include "lab/scenes/dice.hpp"

namespace flipside {
namespace {

using Json = nlohmann::json;

/// Does some damage to a segment, or to what it met; false where this one does not lend itself to it.
struct Damage {
    const char* name;
    std::function<bool(Json& run, Json& legs, std::size_t leg)> done;
};

bool hits(const Json& leg) {
    return leg["within"] > 0;
}
bool hits_part(const Json& leg) {
    return hits(leg) && leg["why"] == "part";
}
void add(Json& number, double change) {
    number = number.get<double>() + change;
}
double speed(const Json& velocity) {
    return std::hypot(velocity[0].get<double>(), velocity[1].get<double>());
}

const Damage damages[] = {
    {"time of an impact",
     [](Json&, Json& legs, std::size_t i) {
         if (!hits(legs[i]) || speed(legs[i]["velocity_before"]) < 0.05) return false;
         add(legs[i]["start"], 1e-6);
         return true;
     }},
    {"velocity",
     [](Json&, Json& legs, std::size_t i) {
         if (i == 0) return false;
         add(legs[i]["velocity"][i % 2], 1e-6);
         return true;
     }},
    {"velocity at the start",
     [](Json&, Json& legs, std::size_t) {
         if (legs.size() < 2) return false;
         add(legs[0]["velocity"][0], 1e-4);
         return true;
     }},
    {"position",
     [](Json&, Json& legs, std::size_t i) {
         if (i == 0) return false;
         add(legs[i]["position"][i % 2], 1e-6);
         return true;
     }},
    {"missing event",
     [](Json&, Json& legs, std::size_t i) {
         if (!hits(legs[i])) return false;
         legs.erase(i);
         return true;
     }},
    {"normal",
     [](Json&, Json& legs, std::size_t i) {
         if (!hits(legs[i])) return false;
         for (Json& n : legs[i]["normal"]) n = -n.get<double>();
         return true;
     }},
    {"turned normal",
     [](Json&, Json& legs, std::size_t i) {
         if (!hits(legs[i])) return false;
         const double x = legs[i]["normal"][0], y = legs[i]["normal"][1];
         legs[i]["normal"] = {x - 1e-6 * y, y + 1e-6 * x};
         return true;
     }},
    {"wrong feature",
     [](Json& run, Json& legs, std::size_t i) {
         if (!hits_part(legs[i]) || run["features"].size() < 9) return false;
         legs[i]["met"] =
             (legs[i]["met"].get<std::size_t>() + run["features"].size() / 2) % run["features"].size();
         return true;
     }},
    {"gravity",
     [](Json& run, Json& legs, std::size_t i) {
         if (i != 0 || legs.size() < 2) return false;
         add(run["gravity"][1], 1e-3);
         return true;
     }},
    {"acceleration",
     [](Json&, Json& legs, std::size_t i) {
         if (!legs[i]["displacements"].empty() || speed(legs[i]["velocity"]) > 3) return false;
         if (i + 1 < legs.size() && legs[i]["start"] == legs[i + 1]["start"]) return false;
         add(legs[i]["acceleration"][0], 1e-3);
         return true;
     }},
    {"spin",
     [](Json&, Json& legs, std::size_t i) {
         if (i == 0) return false;
         add(legs[i]["spin"], 1e-3);
         legs[i]["roll"] = {0, 0};
         return true;
     }},
    {"isolating interval",
     [](Json&, Json& legs, std::size_t i) {
         if (!hits(legs[i])) return false;
         legs[i]["within"] = 0;
         return true;
     }},
    {"an impact called a given velocity",
     [](Json&, Json& legs, std::size_t i) {
         if (!hits(legs[i])) return false;
         legs[i]["why"] = "given";
         return true;
     }},
    {"an impact called none",
     [](Json&, Json& legs, std::size_t i) {
         if (!hits(legs[i])) return false;
         legs[i]["why"] = "goes on";
         return true;
     }},
    {"velocity before",
     [](Json&, Json& legs, std::size_t i) {
         if (!hits(legs[i])) return false;
         add(legs[i]["velocity_before"][1], 1e-6);
         return true;
     }},
    {"contact left out",
     [](Json&, Json& legs, std::size_t i) {
         if (legs[i]["held"] < 0 || i + 1 == legs.size()) return false;
         if (legs[i]["start"] == legs[i + 1]["start"]) return false;
         legs[i]["held"] = -1;
         return true;
     }},
    {"term of a series",
     [](Json&, Json& legs, std::size_t i) {
         if (legs[i]["displacements"].empty() || i + 1 == legs.size()) return false;
         add(legs[i]["displacements"][0][0], 1e-3);
         return true;
     }},
    {"place of a part",
     [](Json& run, Json& legs, std::size_t i) {
         if (!hits_part(legs[i])) return false;
         for (Json& point : run["features"][legs[i]["met"].get<std::size_t>()]["points"]) {
             add(point[0], 1e-6);
             add(point[1], 1e-6);
         }
         return true;
     }},
    {"restitution",
     [](Json& run, Json& legs, std::size_t i) {
         if (!hits_part(legs[i])) return false;
         const std::size_t part = run["features"][legs[i]["met"].get<std::size_t>()]["part"];
         const std::size_t material = run["parts"][part]["material"];
         if (run["materials"][material]["kick"] > 0) return false;
         add(run["materials"][material]["restitution"], 1e-3);
         return true;
     }},
    {"a wall in the way",
     [](Json& run, Json& legs, std::size_t i) {
         if (i + 1 >= legs.size() || legs[i]["held"] >= 0) return false;
         const double share = 0.4, t0 = legs[i]["start"], t1 = legs[i + 1]["start"];
         if (t1 - t0 < 0.02) return false;
         const auto along = [&](std::size_t k) {
             const double a = legs[i]["position"][k], b = legs[i + 1]["position"][k];
             return a + share * (b - a);
         };
         run["features"].push_back({{"part", 0},
                                    {"type", "round"},
                                    {"points", {{along(0), along(1)}}},
                                    {"radius", 0},
                                    {"wide", false},
                                    {"joined", {false, false}}});
         return true;
     }},
};

TEST(Damages, AreRejected) {
    std::vector<Json> whole;
    for (const auto& [name, seconds] : {std::pair{"pinball", 1.0},
                                        {"pinball", test::in_small ? 0.8 : 1.7},
                                        {"drop", test::in_small ? 1.0 : 3.0},
                                        {"box", test::in_small ? 0.5 : 2.0},
                                        {"bowl", 0.5},
                                        {"toy", test::in_small ? 0.5 : 1.0}}) {
        const Shipped shipped(name);
        lab::Session session = shipped.session("113");
        const std::string json = shipped.certified(session, seconds).json;
        ASSERT_EQ(check_certificate(json).code, 0) << name;
        whole.push_back(Json::parse(json));
    }
    lab::Dice dice(2026);
    const auto any = [&](std::size_t n) {
        return static_cast<std::size_t>(dice.below(static_cast<double>(n)));
    };
    constexpr std::size_t wanted = test::in_small ? 20 : 60;  // 1 or 3 of each kind
    for (std::size_t n = 0; n < wanted;) {
        Json run = whole[any(whole.size())];
        Json& legs = run["balls"][any(run["balls"].size())]["legs"];
        const Damage& damage = damages[n % std::size(damages)];
        const std::size_t leg = any(legs.size());
        if (!damage.done(run, legs, leg)) continue;
        const Checked checked = check_certificate(run.dump());
        EXPECT_EQ(checked.code, 1) << damage.name << " of segment " << leg << " of " << run["scene"] << ": "
                                   << checked.says;
        ++n;
    }
}

TEST(Damages, AFileThatIsNoCertificateIsRefused) {
    for (const char* text : {"", "{}", "[1, 2]", "{\"format\": \"flipside-scene/1\"}", "not json"})
        EXPECT_EQ(check_certificate(text).code, 2) << text;
    const Shipped shipped("drop");
    lab::Session session = shipped.session("53");
    const Json whole = Json::parse(shipped.certified(session, 1).json);
    const auto refused = [&](const auto& change) {
        Json run = whole;
        change(run);
        return check_certificate(run.dump()).code == 2;
    };
    EXPECT_TRUE(refused([](Json& run) { run["balls"][0]["legs"][1]["met"] = 99; }));
    EXPECT_TRUE(refused([](Json& run) { run["balls"][0]["radius"] = 0; }));
    EXPECT_TRUE(refused([](Json& run) { run["balls"][0]["legs"][1]["start"] = -1; }));
    EXPECT_TRUE(refused([](Json& run) { run["features"][0]["type"] = "spline"; }));
    EXPECT_TRUE(refused([](Json& run) { run["features"][0]["part"] = 7; }));
    EXPECT_TRUE(refused([](Json& run) { run.erase("inputs"); }));
}

}  // namespace
}  // namespace flipside
