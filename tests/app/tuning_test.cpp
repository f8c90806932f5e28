/// sweep --tune: what it prints and writes, and what it refuses.

#include "command_line.hpp"

namespace flipside::app {
namespace {

class TuningCommand : public CommandLine {
  protected:
    [[nodiscard]] std::string tune(const std::string& more) const {
        return "sweep pinball --balls 1 --tune box2d --quick --finest 60 --out " + file("tuned") + ' ' + more;
    }
};

TEST_F(TuningCommand, PrintsAndWritesEachErrorWithItsThreeContenders) {
    const Result result = flipside(tune("--error 2,1"));
    ASSERT_EQ(result.code, 0) << result.err;
    EXPECT_LT(result.out.find("pinball-1, error at most 2 r"),
              result.out.find("pinball-1, error at most 1 r"));
    const std::string csv = text_of(file("tuned/tuning.csv"));
    EXPECT_EQ(csv.find("variant,target,tried,role,contender,error,cpu,ratio,ratio_low,ratio_high\n"), 0U);
    EXPECT_EQ(std::ranges::count(csv, '\n'), 1 + 2 * 3);
    for (const char* row : {"pinball-1,2,", ",tuned,\"box2d-tuned=box2d,dt=", ",untuned,\"box2d=box2d,dt=",
                            ",custom,\"custom=custom,dt=0.03"})
        EXPECT_NE(csv.find(row), std::string::npos) << row << '\n' << csv;
    // What it found is a contender as it stands there.
    const std::size_t begin = result.out.find("box2d-tuned=");
    const std::string text = result.out.substr(begin, result.out.find('\n', begin) - begin);
    const Result compared =
        flipside("compare pinball --seconds 0.1 --contender c=custom,dt=1/30 --contender " + text);
    EXPECT_EQ(compared.code, 0) << text << '\n' << compared.err;
}

TEST_F(TuningCommand, RefusesWhatMakesNoSense) {
    expect_refused("sweep drop --tune nobody --out " + file("a"), 2, "nobody");
    expect_refused("sweep drop --error 1 --out " + file("a"), 2, "--tune");
    expect_refused(tune("--error 0"), 2, "--error");
    expect_refused(tune("--error much"), 2, "--error");
    expect_refused(tune("--shard 1/2"), 2, "--shard");
    expect_refused(tune("--contenders box2d"), 2, "--contenders");
    expect_refused(tune("--every-window"), 2, "--every-window");
    expect_refused(tune("--engine " + file("none.so")), 2, "--engine excludes --tune");
    EXPECT_FALSE(fs::exists(file("a")));
    EXPECT_FALSE(fs::exists(file("tuned")));
}

}  // namespace
}  // namespace flipside::app
