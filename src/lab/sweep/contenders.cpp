#include "lab/sweep/contenders.hpp"

#include <algorithm>
#include <deque>
#include <iterator>
#include <sstream>

#include "world/input_error.hpp"

namespace flipside::lab::sweep {

namespace {

constexpr int coarse = coarsest_steps, middle = 960, fine = finest_steps;

constexpr Contender all[] = {
    {"custom-continuous", "custom", "solver=continuous", coarse, fine,
     "the bespoke engine from impact to impact"},
    {"custom-simple", "custom", "solver=simple", coarse, fine,
     "the bespoke engine's toy: the loop that it teaches"},
    {"custom-simple-tuned", "custom", "solver=simple motion_iterations=16 collision_iterations=12", coarse,
     middle, "the same with four times the motion iterations and twice the collision iterations"},
    {"box2d", "box2d", "", coarse, fine, "Box2D as it comes: bullets, 8 velocity and 3 position iterations"},
    {"box2d-no-bullets", "box2d", "bullets=off", coarse, middle, "no continuous collision between balls"},
    {"box2d-20-10", "box2d", "velocity_iterations=20 position_iterations=10", coarse, middle,
     "more iterations"},
    {"box2d-substeps-4", "box2d", "substeps=4", coarse, middle, "four sub-steps a step"},
    {"box2d-verlet", "box2d", "integrator=verlet", coarse, middle,
     "flies the parabola: what is left of its error is that of contacts"},
    {"box2d-fine-arcs", "box2d", "chord_error=1e-6", coarse, middle, "twenty times smaller error of arcs"},
    {"reference-53", "reference", "precision=53", 60, 60,
     "the exact engine in double precision: its error is what rounding leaves to nobody"},
    // Its slop is a length: ten times the units make it ten times smaller. Its limit of 2 units a step then
    // is one of 11 radii, which a pinball needs 480 steps a second to keep.
    {"box2d-tuned", "box2d",
     "chord_error=1e-6 velocity_iterations=20 position_iterations=10 length_scale=185", 480, fine,
     "fine arcs, more iterations, and a tenth of its slop"},
};

/// One for each library that was loaded, as it comes. They stay where they are.
const std::deque<Contender>& loaded_contenders() {
    static std::deque<Contender> loaded;
    for (const Engine* engine : engines())
        if (!engine->file.empty() &&
            std::ranges::find(loaded, engine->name, &Contender::name) == loaded.end())
            loaded.push_back({engine->name, engine->name, "", coarse, middle, engine->about});
    return loaded;
}

}  // namespace

std::span<const Contender> contenders() {
    return all;
}

std::vector<const Contender*> all_contenders() {
    std::vector<const Contender*> pointers;
    for (const Contender& contender : all) pointers.push_back(&contender);
    for (const Contender& contender : loaded_contenders()) pointers.push_back(&contender);
    return pointers;
}

const Contender& contender_named(std::string_view name) {
    if (name.find('/') != std::string_view::npos) name = engine_named(name).name;
    const std::vector<const Contender*> there = all_contenders();
    const auto at = std::ranges::find(there, name, &Contender::name);
    if (at != there.end()) return **at;
    std::string known;
    for (const Contender* one : there) known += (known.empty() ? "" : ", ") + std::string(one->name);
    throw InputError("unknown contender '" + std::string(name) + "' of a sweep; allowed are " + known +
                     ", and the path of a library, after which its own name is known too");
}

Settings settings_of(const Contender& contender, const Scene& scene) {
    const Engine* const engine = &engine_named(contender.engine);
    std::istringstream words{std::string(contender.settings)};
    const std::vector<std::string> texts{std::istream_iterator<std::string>(words), {}};
    return settings_for(*engine, scene, parse_changes(texts, {&engine, 1}));
}

}  // namespace flipside::lab::sweep
