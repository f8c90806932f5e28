#pragma once
/// Whole games, played by the bot (player.hpp) on an engine.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "world/controls.hpp"
#include "world/engine.hpp"

namespace flipside::lab::bot {

struct Request {
    std::shared_ptr<const Scene> scene;  ///< with rules and a launcher
    const Engine* engine;
    Settings settings;
    double dt = 1.0 / 60;      ///< s
    double longest = 30 * 60;  ///< s of a game, after which it is left unfinished
    /// The folder in which each game is saved as game-SEED.flipside-replay (replay/replay.hpp), if any.
    std::optional<std::filesystem::path> replays = std::nullopt;
};

/// What became of a game.
struct Played {
    std::uint64_t seed = 0;
    long score = 0;
    double seconds = 0;    ///< simulated
    bool finished = true;  ///< by its rules
    long launched = 0;
    long lost = 0;             ///< balls that drained, saved ones among them
    std::uint64_t strays = 0;  ///< balls that left the table, but not through its drain
    int stuck = 0;             ///< how often a ball was still for 10 s (still_watch.hpp)
    double longest_still = 0;  ///< s
    int nudges = 0;
    int searches = 0;  ///< how often the table sought a ball (Rules::ball_search)
    /// Of the drained balls, what each one met last of flippers and sensors, by name; "" for none of them.
    std::map<std::string, int> drained_after;
    Script script;  ///< of the player's controls: plays the same game again
};

/// One game; the same request and seed give the same bits.
[[nodiscard]] Played play(const Request& request, std::uint64_t seed);

/// Where the game of this seed is saved.
[[nodiscard]] std::filesystem::path replay_file(const std::filesystem::path& folder, std::uint64_t seed);
/// So many games, with seeds that follow from `seed`. `after` is called after each with how many are done.
[[nodiscard]] std::vector<Played> play(const Request& request, std::uint64_t seed, std::size_t games,
                                       const std::function<void(std::size_t done)>& after);

/// Throws InputError for a scene on which no game can be played: without rules, launcher or flippers.
void require_playable(const Scene& scene);

}  // namespace flipside::lab::bot
