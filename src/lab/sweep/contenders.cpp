#include "lab/sweep/contenders.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <iterator>
#include <sstream>

#include "lab/contenders/recommended.hpp"
#include "lab/sweep/variants.hpp"
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
     "the exact engine in double precision: its error is that of rounding alone"},
    // Its slop is a length: ten times the units make it ten times smaller. Its limit of 2 units a step then
    // is one of 11 radii, which a pinball needs 480 steps a second to keep.
    {"box2d-tuned", "box2d",
     "chord_error=1e-6 velocity_iterations=20 position_iterations=10 length_scale=185", 480, fine,
     "fine arcs, more iterations, and a tenth of its slop"},
};

/// One for each other engine, as it comes. They stay where they are.
const std::deque<Contender>& other_contenders() {
    static std::deque<Contender> others;
    std::vector<std::string_view> listed;
    for (const Contender& contender : all) listed.push_back(contender.engine);
    for (const Contender& contender : others) listed.push_back(contender.engine);
    for (const Engine* engine : engines_beside(listed))
        others.push_back({engine->name, engine->name, "", coarse, middle, engine->about});
    return others;
}

/// One that a user defined, with the texts that it refers to.
struct Defined {
    std::string name, engine, settings, about;
    Contender contender{};

    bool operator==(const Defined& other) const {
        return name == other.name && engine == other.engine && settings == other.settings &&
               about == other.about && contender.coarsest == other.contender.coarsest &&
               contender.finest == other.contender.finest;
    }
};

/// They stay where they are.
std::deque<Defined>& defined_contenders() {
    static std::deque<Defined> defined;
    return defined;
}

std::vector<std::string> words_of(std::string_view settings) {
    std::istringstream words{std::string(settings)};
    return {std::istream_iterator<std::string>(words), {}};
}

/// Steps per second, of which every window has a whole number.
int rate_of(const ContenderRequest& request) {
    const double rate = 1 / *request.dt, unit = 1 / window_unit;
    const double whole = std::round(rate / unit) * unit;
    if (!(whole >= unit && whole <= finest_steps && std::abs(rate - whole) <= 1e-9 * whole))
        throw InputError("contender '" + request.name + "': a sweep has no steps of " +
                         std::to_string(*request.dt) +
                         " s; allowed are 1/n s, where n is a multiple of 30 up to 7680");
    return static_cast<int>(whole);
}

}  // namespace

std::span<const Contender> contenders() {
    return all;
}

std::vector<const Contender*> all_contenders() {
    std::vector<const Contender*> pointers;
    for (const Contender& contender : all) pointers.push_back(&contender);
    for (const Contender& contender : other_contenders()) pointers.push_back(&contender);
    return pointers;
}

const Contender* find_contender(std::string_view name) {
    const std::vector<const Contender*> there = all_contenders();
    const auto at = std::ranges::find(there, name, &Contender::name);
    if (at != there.end()) return *at;
    const auto defined = std::ranges::find(defined_contenders(), name, &Defined::name);
    return defined == defined_contenders().end() ? nullptr : &defined->contender;
}

const Contender& add_contender(const std::string& name, const std::string& engine,
                               const std::string& settings, int coarsest, int finest,
                               const std::string& about) {
    const auto known = std::ranges::find(engines(), engine, &Engine::name);
    if (known == engines().end())
        throw InputError("contender '" + name + "': no engine '" + engine + "' is known here");
    const Engine* const own = *known;
    for (const SettingChange& change : parse_changes(words_of(settings), {&own, 1}))
        Settings(own->settings).set(change.name, change.value);
    if (coarsest % coarsest_steps != 0 || finest % coarsest != 0)
        throw InputError("contender '" + name + "': its steps per second must be multiples of 30");
    Defined added{name, engine, settings, about};
    added.contender.coarsest = coarsest;
    added.contender.finest = finest;
    std::deque<Defined>& all = defined_contenders();
    if (const Contender* there = find_contender(name)) {
        const auto same = std::ranges::find(all, added);
        if (same != all.end()) return same->contender;
        throw InputError("contender '" + name +
                         "': the name has another meaning already: " + std::string(there->about));
    }
    Defined& kept = all.emplace_back(std::move(added));
    kept.contender = {kept.name, kept.engine, kept.settings, coarsest, finest, kept.about};
    return kept.contender;
}

const Contender& add_contender(const ContenderRequest& request) {
    std::string settings;
    for (const auto& [name, value] : request.set)
        settings += (settings.empty() ? "" : " ") + name + '=' + value;
    const int coarsest = request.dt ? rate_of(request) : coarse;
    return add_contender(
        request.name, std::string(request.engine->name), settings, coarsest, request.dt ? coarsest : fine,
        std::string(request.engine->name) + " with " + (settings.empty() ? "nothing changed" : settings));
}

const Contender& contender_named(std::string_view name) {
    if (name.find('/') != std::string_view::npos) name = engine_named(name).name;
    if (const Contender* there = find_contender(name)) return *there;
    const std::vector<const Contender*> there = all_contenders();
    std::string known;
    for (const Contender* one : there) known += (known.empty() ? "" : ", ") + std::string(one->name);
    throw InputError("unknown contender '" + std::string(name) + "' of a sweep; allowed are " + known +
                     ", and the path of a library, after which its own name is known too");
}

Settings settings_of(const Contender& contender, const Scene& scene) {
    const Engine* const engine = &engine_named(contender.engine);
    require_known_engines(scene);
    return settings_for(*engine, scene, parse_changes(words_of(contender.settings), {&engine, 1}));
}

}  // namespace flipside::lab::sweep
