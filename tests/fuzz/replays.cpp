/// Replays: read, written again, and the first steps played.

#include "fuzz/oracle.hpp"
#include "fuzz/target.hpp"
#include "lab/replay/play.hpp"

namespace flipside::fuzz {

void run_input(std::string_view input) {
    set_subject("reader");
    lab::Replay replay;
    const bool read = accepted([&] {
        const CpuLimit limit(longest_answer);
        replay = lab::parse_replay(input, "input.json");
    });
    if (!read) return;
    const std::string text = to_json(replay);
    require(to_json(lab::parse_replay(text, "written")) == text, "a replay is not read as it was written");
    // What steps do to scenes from elsewhere is the target of scenes.
    constexpr std::size_t most_balls = 20;
    constexpr int most_steps = 40;
    if (replay.scene->balls.size() > most_balls) return;
    set_subject("player");
    for (std::size_t run = 0; run < replay.runs.size(); ++run)
        static_cast<void>(accepted([&] {
            lab::ReplayPlayer player(replay, run);
            bool more = true;
            for (int step = 0; more && step < most_steps; ++step) {
                const CpuLimit limit(longest_answer);
                more = player.step();
            }
        }));
}

}  // namespace flipside::fuzz
