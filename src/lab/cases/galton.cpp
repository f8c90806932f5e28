// A board of pins (F. Galton, Natural inheritance, 1889). With real pins the distribution of the balls is no
// binomial one; what is known is that it is symmetric, and that every engine must give the same.

#include <algorithm>
#include <cmath>

#include <boost/math/distributions/binomial.hpp>
#include <boost/math/distributions/kolmogorov_smirnov.hpp>

#include "lab/cases/double_policy.hpp"
#include "lab/cases/families.hpp"
#include "lab/cases/text.hpp"
#include "lab/contenders/engines.hpp"
#include "lab/scenes/dice.hpp"
#include "world/scene_builder.hpp"

namespace flipside::lab {

namespace {

constexpr double doubt = 0.001;    // a hypothesis is given up when its data are rarer than this
constexpr int balls_at_once = 50;  // which do not meet each other
constexpr int rows = 8;
constexpr double pitch = 0.1, grain = 0.02, pin = 0.01;  // m
constexpr double tray = -rows * pitch - 0.2;             // m, the height at which a ball's place is taken

Scene board(Dice& dice) {
    Scene scene = empty_scene({0, -g});
    scene.rest_speed = 0;
    shape::Compound pins;
    for (int row = 0; row < rows; ++row)
        for (int i = -rows - 4; i <= rows + 4; ++i)
            pins.of.push_back({shape::Circle{{(i + 0.5 * (row % 2)) * pitch, -row * pitch}, pin}});
    add_part(scene, {pins}, {"", 0.4, 0, 0});
    for (int i = 0; i < balls_at_once; ++i) {
        Ball& ball = add_ball(scene, {dice.below(pitch) - pitch / 2, 0.1}, {}, grain);
        ball.layer = 2;
        ball.collides_with = 1;
    }
    return scene;
}

/// Where a ball in flight below the pins came through the height of the tray.
double place_in_tray(const Ball& ball) {
    const double fall = ball.position.y - tray;  // ≤ 0
    const double then = std::sqrt(ball.velocity.y * ball.velocity.y + 2 * g * fall);
    return ball.position.x - ball.velocity.x * (-ball.velocity.y - then) / g;
}

/// The places of as many balls as seeds from `seed` on give, sorted.
std::vector<double> places(Experiment& experiment, int worlds, std::uint64_t seed) {
    std::vector<double> found;
    for (int k = 0; k < worlds; ++k) {
        Dice dice(seed + static_cast<std::uint64_t>(k));
        Trial trial(experiment, board(dice));
        std::vector<bool> through(balls_at_once);
        const auto look = [&] {
            for (const Ball& ball : trial.world().balls()) {
                if (ball.position.y > tray || through[ball.number]) continue;
                through[ball.number] = true;
                found.push_back(place_in_tray(ball));
            }
            return std::ranges::all_of(through, [](bool it) { return it; });
        };
        static_cast<void>(trial.run_until(look, 20));
    }
    std::ranges::sort(found);
    return found;
}

/// Largest distance between the distribution functions of two sorted samples.
double kolmogorov_smirnov(const std::vector<double>& a, const std::vector<double>& b) {
    double worst = 0;
    std::size_t i = 0, j = 0;
    while (i < a.size() && j < b.size()) {
        const double x = std::min(a[i], b[j]);
        while (i < a.size() && a[i] <= x) ++i;
        while (j < b.size() && b[j] <= x) ++j;
        worst = std::max(worst, std::abs(static_cast<double>(i) / static_cast<double>(a.size()) -
                                         static_cast<double>(j) / static_cast<double>(b.size())));
    }
    return worst;
}

}  // namespace

void galton_board(Experiment& experiment) {
    const int worlds = experiment.size(40, 4);
    const std::vector<double> own = places(experiment, worlds, 1);
    const double dropped = worlds * balls_at_once;
    experiment.always("balls that came through", "", dropped, static_cast<double>(own.size()));

    const auto right = static_cast<double>(std::ranges::count_if(own, [](double x) { return x > 0; }));
    const boost::math::binomial_distribution<double, DoublePolicy> fair(dropped, 0.5);
    experiment.exact("balls right of the middle", "", dropped / 2, right,
                     dropped / 2 - quantile(fair, doubt / 2));

    const Engine& truth = engine_named("reference");
    const CaseInput input{{&truth, settings_for(truth, Scene{})},
                          experiment.dt(),
                          experiment.input().quick,
                          experiment.input().watch};
    Experiment other(input);
    const std::vector<double> reference = places(other, worlds, 1'000'000);
    const double distance = kolmogorov_smirnov(own, reference);
    const auto n = static_cast<double>(own.size()), m = static_cast<double>(reference.size());
    const boost::math::kolmogorov_smirnov_distribution<double, DoublePolicy> same(n * m / (n + m));
    experiment.exact("Kolmogorov-Smirnov distance from the reference", "", 0, distance,
                     quantile(complement(same, doubt)));
    experiment.note("its p-value", "", cdf(complement(same, distance)));
}

}  // namespace flipside::lab
