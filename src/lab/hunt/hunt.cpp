#include "lab/hunt/hunt.hpp"

#include <algorithm>
#include <cstdio>

#include "lab/files/csv.hpp"
#include "lab/files/whole_file.hpp"
#include "lab/process/build_commit.hpp"
#include "world/input_error.hpp"
#include "world/scene_file.hpp"
#include "world/scene_json.hpp"
#include "world/trace.hpp"

namespace flipside::lab::hunt {

namespace fs = std::filesystem;

namespace {

constexpr const char* of_damaged = "it is made again";

/// As --contender takes it; a scene of a hunt recommends nothing.
std::string contender_text(const Request& request) {
    return text_of(contender_for(request.contender, Scene{}, request.dt), Scene{});
}

void settle_plan(const fs::path& folder, const std::string& plan, const Notice& notice) {
    const fs::path file = folder / "plan.txt";
    const std::string origin = origin_of("hunt-plan", {});
    const auto found = read_back(
        file, notice, [&] { return read_data_file(file, origin); }, of_damaged);
    if (!found) return write_data_file(file, origin, plan);
    if (*found != plan)
        throw InputError(
            file.string(), "",
            "is the plan of another hunt or of another build; allowed is the same one, or an empty "
            "folder");
}

struct Round {
    fs::path file;
    std::string origin;
};

Round round_in(const fs::path& folder, const std::string& plan, std::size_t round) {
    char name[32];
    std::snprintf(name, sizeof name, "%03zu.txt", round + 1);
    return {folder / "rounds" / name, origin_of("hunt-round", {plan, name})};
}

/// What a round's file holds: the scene alone is kept, the rest is measured again.
std::optional<Found> read_round(const Request& request, const Round& round, const Notice& notice) {
    const auto read = [&] {
        Found found;
        found.text = read_data_file(round.file, round.origin);
        const Scene scene = parse_scene(found.text, round.file.string());
        found.measured = measure(request, scene);
        found.balls = scene.balls.size();
        found.parts = scene.parts.size();
        return found;
    };
    return read_back(round.file, notice, read, of_damaged);
}

void write_rounds(const Request& request, const std::vector<Found>& all, const fs::path& folder) {
    WholeFile whole(folder / "rounds.csv");
    whole.out() << "goal,contender,value,time,what,balls,parts\n";
    CsvRow row;
    for (const Found& found : all) {
        row.add(name_of(request.goal)).add(contender_text(request)).add(found.measured.value);
        row.add(found.measured.time).add(found.measured.what);
        row.add(found.balls).add(found.parts).write(whole.out());
    }
    whole.finish();
}

}  // namespace

std::string plan_of(const Request& request) {
    return contender_text(request) + " goal=" + std::string(name_of(request.goal)) +
           " length=" + brief(request.seconds) + " seed=" + std::to_string(request.seed) +
           " scenes=" + std::to_string(request.scenes) + " build=" + build_commit() + "\n";
}

std::string sentence(const Request& request, const Measured& measured) {
    std::string text = request.contender.name + " at steps of " +
                       brief(request.contender.dt.value_or(request.dt)) + " s: " + brief(measured.value) +
                       ' ' + std::string(unit_of(request.goal));
    if (!measured.what.empty()) text += ", " + measured.what + ", at " + brief(measured.time) + " s";
    return text;
}

std::string titled(const Request& request, const Found& found) {
    Scene scene = parse_scene(found.text, "a scene of the hunt");
    scene.name = request.contender.name + "-" + std::string(name_of(request.goal));
    scene.about = "Found by a hunt for " + std::string(name_of(request.goal)) + ". " +
                  sentence(request, found.measured) + ". To see it again: flipside hunt --goal " +
                  std::string(name_of(request.goal)) + " --length " + brief(request.seconds) +
                  " --contender " + contender_text(request) + " --replay FILE";
    return to_json(scene) + "\n";
}

std::optional<std::vector<Found>> hunt(const Request& request, sweep::Shard shard, const fs::path& folder,
                                       const std::function<void(double)>& watch, const Notice& notice) {
    const std::string plan = plan_of(request);
    make_folder(folder / "rounds");
    settle_plan(folder, plan, notice);
    for (std::size_t i = shard.index - 1; i < request.rounds; i += shard.count) {
        const Round round = round_in(folder, plan, i);
        if (read_round(request, round, notice)) continue;
        const auto share = [&](double done) {
            watch((static_cast<double>(i) + done) / static_cast<double>(request.rounds));
        };
        write_data_file(round.file, round.origin, hunt_round(request, i, share).text + "\n");
    }
    std::vector<Found> all;
    for (std::size_t i = 0; i < request.rounds; ++i) {
        auto found = read_round(request, round_in(folder, plan, i), notice);
        if (!found) return std::nullopt;
        all.push_back(std::move(*found));
    }
    std::ranges::stable_sort(all, std::greater<>(), [](const Found& found) { return found.measured.value; });
    write_rounds(request, all, folder);
    write_whole_file(folder / "worst.json", titled(request, all.front()));
    return all;
}

}  // namespace flipside::lab::hunt
