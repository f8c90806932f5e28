/// sweep --every-window: windows that are left out otherwise are run too.

#include "command_line.hpp"

namespace flipside::app {
namespace {

class SweepCommand : public CommandLine {
  protected:
    /// Windows run at steps of 1/960 s, of 40.
    [[nodiscard]] int windows_at_finest(const std::string& folder, const std::string& more) {
        const Result result = flipside("sweep rain --balls 40 --quick --contenders custom-continuous --out " +
                                       file(folder) + ' ' + more);
        EXPECT_EQ(result.code, 0) << result.err;
        const Rows rows = rows_of(file(folder + "/sweep.csv"));
        return rows.empty() ? 0 : std::stoi(rows.back().at("windows"));
    }
};

TEST_F(SweepCommand, RunsEveryWindowWhereAsked) {
    EXPECT_EQ(windows_at_finest("thinned", ""), 20);
    EXPECT_EQ(windows_at_finest("whole", "--every-window"), 40);
}

}  // namespace
}  // namespace flipside::app
