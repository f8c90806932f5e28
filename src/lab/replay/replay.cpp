#include "lab/replay/replay.hpp"

#include "lab/process/build_commit.hpp"
#include "lab/process/failure.hpp"
#include "lab/session/checksum.hpp"
#include "world/scene_file.hpp"
#include "world/scene_json.hpp"

namespace flipside::lab {

namespace {

/// The scene as its file has it; throws Failure where the session runs another one.
std::shared_ptr<const Scene> scene_of_file(const Scene& scene) {
    if (!scene.document) throw Failure("this scene comes from no file, so its game cannot be saved");
    auto read = std::make_shared<const Scene>(parse_scene(*scene.document, "the scene"));
    Scene same = *read;
    same.gravity = scene.gravity;
    if (to_json(same) != to_json(scene))
        throw Failure("this scene is not as in its file, so its game cannot be saved");
    return read;
}

ReplayRun replay_run(const RecordedRun& recorded) {
    const Session& session = *recorded.session;
    const Recording& recording = session.recording();
    if (recording.spoiled())
        throw Failure("the game of '" + recorded.name + "' cannot be saved: " + *recording.spoiled());
    ReplayRun run{recorded.name, recording.start(), recorded.dt, recording.steps(), {}, {}, {}, {}};
    bool length_known = false;
    for (Recording::Entry& entry : recording.entries()) {
        if (const auto* scripted = std::get_if<move::Scripted>(&entry.move)) {
            run.script.push_back(scripted->timed);
        } else if (const auto* check = std::get_if<move::Check>(&entry.move)) {
            run.checks.push_back(check->checksum);
        } else if (const auto* length = std::get_if<move::StepLength>(&entry.move); length && !length_known) {
            run.dt = length->dt;
            length_known = true;
        } else {
            run.moves.push_back(std::move(entry));
        }
    }
    for (const auto& entry : run.moves)
        if (const auto* change = std::get_if<move::Change>(&entry.move);
            change && !change->engine->file.empty())
            throw Failure("the game of '" + recorded.name + "' cannot be saved: it ran on a library");
    if (!run.start.engine->file.empty())
        throw Failure("the game of '" + recorded.name + "' cannot be saved: it ran on a library");
    run.end = {session.world().time(), session.game().score(), checksum_of(session.world(), session.game())};
    return run;
}

}  // namespace

Replay replay_of(std::span<const RecordedRun> runs) {
    Replay replay{"flipside " + build_commit(), scene_of_file(runs.front().session->scene()), {}};
    for (const RecordedRun& run : runs) replay.runs.push_back(replay_run(run));
    return replay;
}

std::shared_ptr<const Scene> with_gravity(const std::shared_ptr<const Scene>& scene, Vec2 gravity) {
    if (scene->gravity == gravity) return scene;
    Scene changed = *scene;
    changed.gravity = gravity;
    return std::make_shared<const Scene>(std::move(changed));
}

}  // namespace flipside::lab
