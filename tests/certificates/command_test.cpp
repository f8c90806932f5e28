// `flipside certify` and the checker as programs.
#ifdef FLIPSIDE_WITH_APP

#include "app/command_line.hpp"
#include "places.hpp"

namespace flipside {
namespace {

class Certify : public app::CommandLine {
  protected:
    [[nodiscard]] int check(const std::string& arguments) const {
        const std::string command =
            std::string(test::certificate_checker) + " " + arguments + " > " + file("says") + " 2>&1";
        const int status = std::system(command.c_str());
        return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    }
};

TEST_F(Certify, WritesWhatTheCheckerAccepts) {
    expect_good("certify drop --seconds 1 --out " + file("run.json"));
    EXPECT_EQ(check(file("run.json")), 0);
    // 1 m/9.81 m/s² falls for 0.452 s; the next impact is at 1.174 s.
    EXPECT_NE(app::text_of(file("says"))
                  .find("accepted: 1 s, 1 balls, 2 segments (0 in contact, 0 at rest), 1 impacts"),
              std::string::npos)
        << app::text_of(file("says"));
    expect_good("certify rain --balls 20 --seconds 0.2 --set precision=53 --out " + file("rain.json"));
    EXPECT_EQ(check(file("rain.json") + " 1e-6"), 0);
}

TEST_F(Certify, EndsWhereTheReferenceRefuses) {
    // A pile: the reference says so at 1.2 s.
    const Result result = flipside("certify rain --balls 12 --seconds 3 --out " + file("run.json"));
    EXPECT_EQ(result.code, 0);
    EXPECT_NE(result.err.find("the certificate ends after"), std::string::npos) << result.err;
    EXPECT_EQ(check(file("run.json")), 0);
    EXPECT_NE(app::text_of(file("says")).find("ends early: reference: balls"), std::string::npos);
}

TEST_F(Certify, RefusesBadUsage) {
    expect_refused("certify nowhere --out " + file("run.json"), 2, "nowhere");
    expect_refused("certify drop", 2, "--out is required");
    expect_refused("certify drop --seconds -1 --out " + file("run.json"), 2, "--seconds");
    expect_refused("certify drop --set precision=7 --out " + file("run.json"), 2, "precision");
    EXPECT_EQ(check(""), 2);
    EXPECT_EQ(check(file("none")), 2);
    EXPECT_NE(app::text_of(file("says")).find("cannot be read"), std::string::npos);
    EXPECT_EQ(check(file("run.json") + " 1"), 2);
    EXPECT_EQ(check(file("run.json") + " nan"), 2);
    EXPECT_EQ(check("--help"), 0);
}

}  // namespace
}  // namespace flipside

#endif
