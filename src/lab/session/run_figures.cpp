#include "lab/session/run_figures.hpp"

#include <nlohmann/json.hpp>

#include "lab/session/run.hpp"
#include "world/json_file.hpp"

namespace flipside::lab {

RunFigures figures_of(const Session& session, double sim_seconds, double energy_first) {
    const World& world = session.world();
    RunFigures figures;
    figures.totals = session.totals();
    figures.balls = world.balls().size();
    figures.asleep = world.statistics().asleep;
    figures.overlaps = overlaps(world.balls());
    figures.sim_seconds = sim_seconds;
    figures.energy_first = energy_first;
    figures.energy_last = energy(world, session.scene());
    figures.score = session.game().score();
    return figures;
}

std::string to_json(const RunFigures& figures) {
    const Totals& totals = figures.totals;
    const nlohmann::ordered_json json{{"steps", totals.steps},
                                      {"balls", figures.balls},
                                      {"sim_seconds", figures.sim_seconds},
                                      {"step_seconds", totals.step_seconds},
                                      {"pair_tests", totals.pair_tests},
                                      {"narrow_tests", totals.narrow_tests},
                                      {"contacts", totals.contacts},
                                      {"handed_over", totals.handed_over},
                                      {"impacts", totals.impacts},
                                      {"energy_first", figures.energy_first},
                                      {"energy_last", figures.energy_last},
                                      {"max_penetration", totals.max_penetration},
                                      {"lost", totals.lost},
                                      {"allocations", totals.allocations},
                                      {"launched", totals.launched},
                                      {"strays", totals.strays},
                                      {"overlaps", figures.overlaps},
                                      {"asleep", figures.asleep},
                                      {"score", figures.score}};
    return json_text(json, 2) + '\n';
}

}  // namespace flipside::lab
