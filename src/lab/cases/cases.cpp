#include <algorithm>
#include <sstream>

#include "lab/cases/families.hpp"
#include "world/input_error.hpp"

namespace flipside::lab {

namespace {

constexpr Case all[] = {
    {1, "zeno-drop", "Zeno drop",
     "A dropped ball bounces ever lower and faster, infinitely often in a finite time, and then lies.", "",
     zeno_drop},
    {2, "elastic-drop", "Elastic drop",
     "A ball bounces for ever; its energy shows what an engine gains or loses at every bounce.", "",
     elastic_drop},
    {3, "box", "Box", "A ball between four walls: unfolded, each coordinate is a triangle wave.", "", box},
    {4, "v-corner", "V corner",
     "A ball falls into a right-angled V and rests on both walls after the longer of two Zeno drops.", "",
     v_corner},
    {5, "galperin", "Galperin's pi",
     "A heavy ball drives a light one against a wall; the number of collisions spells out pi.",
     "G. Galperin, Playing pool with pi, 2003", galperin},
    {6, "channel", "Channel",
     "Equal elastic balls in a row are free points that pass through each other, kept in order.",
     "L. Tonks, The complete equation of state of one, two and three-dimensional gases of hard elastic "
     "spheres, 1936",
     channel},
    {7, "column", "Column",
     "Equal elastic balls that fall and bounce one above the other: points again, for the hardest stack.",
     "L. Tonks, 1936, as above, with falling points", column},
    {8, "cradle", "Newton's cradle",
     "An impact travels through a row of balls. Without gaps it passes from one ball to the next: a declared "
     "rule.",
     "", cradle},
    {9, "head-on", "Head-on impact",
     "Two balls meet head-on, the one up to a million times as heavy; momentum to the last bit.", "",
     head_on},
    {10, "stacked-drop", "Stacked drop",
     "A light ball dropped with a heavy one below it is thrown up at almost three times its speed.",
     "W. G. Harter, Velocity amplification in collision experiments involving superballs, 1971",
     stacked_drop},
    {11, "circular-billiard", "Circular billiard",
     "A ball in a circle hits at ever the same angle; chords would break that.",
     "S. Tabachnikov, Geometry and billiards, 2005", circular_billiard},
    {12, "bowl", "Bowl", "A ball that slides in a bowl swings as a pendulum does.",
     "C. F. Gauss: period by the arithmetic-geometric mean", bowl},
    {13, "leaving-a-circle", "Leaving a circle",
     "A ball that slides off the top of a circle leaves it where cos = 2/3.", "", leaving_a_circle},
    {14, "incline", "Incline",
     "Sliding, rolling, slipping down a slope, and sliding that turns into rolling.", "", incline},
    {15, "grazing", "Grazing a pin",
     "A pin hit by a hair deflects by a known angle, and missed by a hair not at all.", "", grazing},
    {16, "collinear-segments", "Collinear segments", "A floor of ten thousand primitives must feel like one.",
     "", collinear_segments},
    {17, "thin-wall", "Thin wall",
     "A wall without thickness holds a ball at up to a million radii per second.", "", thin_wall},
    {18, "far-away", "Far from the origin",
     "A drop up to ten million radii from the origin; errors in units of the last place there.", "",
     far_away},
    {19, "flipper", "Flipper hit", "A ball meets a flipper: still, rising, falling away, and just stopped.",
     "", flipper},
    {20, "friction-bounce", "Friction bounce",
     "Spin and slip at a bounce: Coulomb friction, capped where it makes the surface stick.", "",
     friction_bounce},
    {21, "deep-overlap", "Deep overlap", "What starts inside a part comes out without a gain of energy.", "",
     deep_overlap},
    {22, "opposed-balls", "Opposed balls",
     "Two fast balls meet at the exact time and never pass through each other.", "", opposed_balls},
    {23, "sensor", "Sensor", "A fast ball begins and ends each sensor once.", "", sensor},
    {24, "pile", "Pile", "A column and a V full of balls come to rest, keep still and fall asleep.", "",
     pile},
    {25, "crushed-ball", "Crushed ball",
     "A ball between a closing flipper and a wall stays where it belongs.", "", crushed_ball},
    {26, "mean-free-path", "Mean free path",
     "A dispersing billiard: a square with pins in its corners and its middle. (A scene cannot be a torus as "
     "Sinai's; the theorem holds for any table.)",
     "L. A. Santalo: mean chord pi A/P; N. Chernov, Entropy, Lyapunov exponents and mean free path for "
     "billiards, 1997",
     mean_free_path},
    {27, "disc-gas", "Hard-disc gas",
     "The pressure of a gas of discs, from its impacts, away from the walls.",
     "D. Henderson, A simple equation of state for hard discs, 1975", disc_gas, "custom.sleep=off"},
    {28, "equipartition", "Equipartition", "Light and heavy balls in a box come to the same mean energy.", "",
     equipartition},
    {29, "galton-board", "Galton board",
     "Balls fall through pins: as many to the left as to the right, spread as on the reference.",
     "F. Galton, Natural inheritance, 1889", galton_board},
    {30, "gate-end", "Gate end",
     "A ball comes to the free end of a gate from every side: whether that lets it through is decided once, "
     "by a declared rule, in every orientation and at every step.",
     "", gate_end},
    {31, "smooth-joint", "Smooth joint without weight",
     "A weightless ball slides off the flat of a part past its round end: a straight line in every "
     "orientation.",
     "", smooth_joint},
    {32, "wedge", "One ball in a wedge",
     "A ball falls into a wedge, lies there and sleeps, whatever the step, with friction or without.", "",
     wedge},
    {33, "heavy-on-light", "Heavy on light",
     "Balls a thousand times as heavy as those that carry them: they do not sink in, and they fall asleep.",
     "", heavy_on_light},
    {34, "mirror", "Mirror",
     "The mirror image of a scene, its balls in another order, moves as the mirror image.", "", mirror},
    {35, "quarter-turn", "Quarter turn", "A scene turned by a quarter turn gives the same bits.", "",
     quarter_turn},
    {36, "time-reversal", "Time reversal",
     "Elastic balls whose velocities are reversed come back to where they began.", "J. Loschmidt, 1876",
     time_reversal},
    {37, "step-independence", "Step independence",
     "Steps of any length give the same bits where no balls are in resting contact with each other.", "",
     step_independence},
    {38, "radius-ratio", "Radius ratio 1 : 500", "Nothing leaves a closed box, however small.", "",
     radius_ratio},
    {39, "gaining-walls", "Walls that give more than they take",
     "With a restitution above 1 speeds grow without end: nothing leaves, and at the top speed the run is "
     "refused.",
     "", gaining_walls},
    {40, "impact-statistics", "Elastic impact statistics",
     "The pressure of 500 discs to half a percent: noise cannot pass for agreement.",
     "N. Clisby, B. M. McCoy, Ninth and tenth order virial coefficients for hard spheres in D dimensions, "
     "2006",
     impact_statistics, "custom.sleep=off"},
};

struct Recommended {
    std::string engine, name, value;
};
Recommended parts_of(const std::string& word) {
    const std::size_t dot = word.find('.'), equals = word.find('=');
    return {word.substr(0, dot), word.substr(dot + 1, equals - dot - 1), word.substr(equals + 1)};
}

bool answers_to(const Case& which, const std::string& name) {
    return which.name == name || std::to_string(which.number) == name;
}

}  // namespace

std::span<const Case> cases() {
    return all;
}

std::vector<const Case*> find_cases(std::span<const std::string> names) {
    std::string known;
    for (const Case& one : all) known += (known.empty() ? "" : ", ") + std::string(one.name);
    for (const std::string& name : names)
        if (std::ranges::none_of(all, [&](const Case& one) { return answers_to(one, name); }))
            throw InputError("unknown case '" + name + "'; known are " + known + ", or their numbers");
    std::vector<const Case*> found;
    for (const Case& one : all)
        if (names.empty() ||
            std::ranges::any_of(names, [&](const std::string& name) { return answers_to(one, name); }))
            found.push_back(&one);
    return found;
}

CaseResult run_case(const Case& which, const CaseInput& input) {
    Experiment experiment(input);
    experiment.attempt(std::string(which.title), [&] { which.run(experiment); });
    return experiment.finish();
}

CaseRun run_recommended(const Case& which, const CaseInput& input, std::span<const SettingChange> changes) {
    const Engine& engine = *input.contender.engine;
    CaseInput recommended = input;
    std::vector<SettingChange> others;
    std::istringstream words{std::string(which.recommend)};
    for (std::string word; words >> word;) {
        const Recommended part = parts_of(word);
        const bool said = std::ranges::find(changes, part.name, &SettingChange::name) != changes.end();
        if (part.engine != engine.name || said || input.contender.settings.text(part.name) == part.value)
            continue;
        recommended.contender.settings.set(part.name, part.value);
        others.push_back({&engine, part.name, part.value});
    }
    return {&which, run_case(which, recommended), std::move(others)};
}

}  // namespace flipside::lab
