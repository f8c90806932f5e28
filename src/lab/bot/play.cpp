#include "lab/bot/play.hpp"

#include <algorithm>

#include "lab/bot/player.hpp"
#include "lab/bot/still_watch.hpp"
#include "lab/files/whole_file.hpp"
#include "lab/replay/replay.hpp"
#include "lab/session/run.hpp"
#include "world/input_error.hpp"
#include "world/json_file.hpp"

namespace flipside::lab::bot {

namespace {

void save_replay(const Request& request, const Session& session, std::uint64_t seed) {
    const RecordedRun runs[] = {{std::string(request.engine->name), &session, request.dt}};
    write_whole_file(replay_file(*request.replays, seed), to_json(replay_of(runs)));
}

/// What every ball in play met last of that by which a drain is told from another.
class LastMet {
  public:
    explicit LastMet(const Scene& scene) : scene_(scene) {}

    void see(std::span<const Event> events, std::map<std::string, int>& drained_after) {
        for (const Event& event : events) {
            if (event.kind == EventKind::lost) {
                const auto met = last_.find(event.ball);
                ++drained_after[met == last_.end() ? "" : scene_.parts[met->second].name];
                last_.erase(event.ball);
            } else if (!event.other.is_ball && tells(scene_.parts[event.other.index])) {
                last_[event.ball] = event.other.index;
            }
        }
    }

  private:
    static bool tells(const Part& part) {
        return part.sensor || std::holds_alternative<motion::Flip>(part.motion);
    }

    const Scene& scene_;
    std::map<BallNumber, PartIndex> last_;
};

}  // namespace

std::filesystem::path replay_file(const std::filesystem::path& folder, std::uint64_t seed) {
    return folder / ("game-" + std::to_string(seed) + std::string(replay_ending));
}

void require_playable(const Scene& scene) {
    const auto flips = [](const Part& part) { return std::holds_alternative<motion::Flip>(part.motion); };
    if (scene.rules && scene.launcher && std::ranges::any_of(scene.parts, flips)) return;
    throw InputError("on scene " + in_quotes(scene.name) +
                     " no game can be played; that takes \"rules\", a \"launcher\" and flippers");
}

Played play(const Request& request, std::uint64_t seed) {
    const Scene& scene = *request.scene;
    Session session(request.scene, *request.engine, request.settings);
    Player player(request.scene, seed);
    StillWatch watch(request.scene);
    LastMet last_met(scene);
    Played played;
    played.seed = seed;
    while (!session.game().over()) {
        const double time = session.world().time();
        if (time >= request.longest) {
            played.finished = false;
            break;
        }
        for (const Control& control : player.act(time, session.world().balls(), session.game()))
            if (session.press(control) && std::holds_alternative<control::Nudge>(control)) ++played.nudges;
        session.step(request.dt);
        check_finite(session, session.world().time());
        watch.look(session.world().time(), session.world().balls());
        last_met.see(session.events(), played.drained_after);
    }
    played.score = session.game().score();
    played.seconds = session.world().time();
    played.launched = session.game().launched();
    played.lost = session.game().lost();
    played.strays = session.totals().strays;
    played.stuck = watch.stuck();
    played.longest_still = watch.longest();
    played.searches = session.game().searches();
    played.script = session.recording().controls();
    if (request.replays) save_replay(request, session, seed);
    return played;
}

std::vector<Played> play(const Request& request, std::uint64_t seed, std::size_t games,
                         const std::function<void(std::size_t done)>& after) {
    std::vector<Played> all;
    for (std::size_t i = 0; i < games; ++i) {
        all.push_back(play(request, seed + i));
        after(i + 1);
    }
    return all;
}

}  // namespace flipside::lab::bot
