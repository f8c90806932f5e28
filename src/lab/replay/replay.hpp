#pragma once
/// A game that can be played again to the bit, and shared: its scene, and for each run of it the engine, the
/// settings and the recording. As a file: assets/replay.schema.json.

#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "lab/session/session.hpp"

namespace flipside::lab {

/// One engine's run of the game.
struct ReplayRun {
    std::string name;
    move::Change start;  ///< with what it began
    double dt = 0;       ///< of its first steps, s
    std::uint64_t steps = 0;
    Script script;                        ///< what was applied at its own times, within steps
    std::vector<Recording::Entry> moves;  ///< what was done between steps; no Scripted and no Check
    std::vector<std::uint64_t> checks;    ///< checksum_of() after every steps_between_checks steps
    struct {
        double time = 0;  ///< s
        long score = 0;
        std::uint64_t checksum = 0;
    } end;
};

/// How the names of replay files end.
inline constexpr std::string_view replay_ending = ".flipside-replay";

struct Replay {
    std::string program;  ///< which version saved it
    std::shared_ptr<const Scene> scene;
    std::vector<ReplayRun> runs;
};

/// A session under a name. `dt` is the length of its steps where it has made none yet, s.
struct RecordedRun {
    std::string name;
    const Session* session = nullptr;
    double dt = 0;
};
/// Throws Failure that says why where one cannot be played again. All are of one scene.
[[nodiscard]] Replay replay_of(std::span<const RecordedRun> runs);

[[nodiscard]] std::string to_json(const Replay& replay);
/// Throws InputError with file, JSON pointer, what is wrong and what is allowed. Only engines that are built
/// in may be named: a file from elsewhere loads no library.
[[nodiscard]] Replay parse_replay(std::string_view text, const std::string& file);
[[nodiscard]] Replay load_replay(const std::filesystem::path& file);

/// The scene with that gravity.
[[nodiscard]] std::shared_ptr<const Scene> with_gravity(const std::shared_ptr<const Scene>& scene,
                                                        Vec2 gravity);

}  // namespace flipside::lab
