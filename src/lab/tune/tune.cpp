#include "lab/tune/tune.hpp"

#include <algorithm>
#include <cmath>
#include <ostream>

#include "lab/files/csv.hpp"

namespace flipside::lab::tune {

namespace {

std::optional<Median> ratio(const std::vector<double>& a, const std::vector<double>& b) {
    std::vector<double> ratios;
    for (std::size_t i = 0; i < a.size(); ++i)
        if (std::isfinite(a[i] / b[i])) ratios.push_back(a[i] / b[i]);
    if (ratios.empty()) return {};
    return median_of(std::move(ratios));
}

/// Of windows that did not fail; infinite where all did.
double mean(const std::vector<double>& times) {
    double sum = 0, count = 0;
    for (const double time : times)
        if (std::isfinite(time)) sum += time, ++count;
    return sum / count;
}

/// Both figures of each, all of them in turn on the same windows, and which is the best: that one is
/// called tuned, whichever it is.
void judge(Tuning& tuning, const Trials& trials) {
    Judged* const all[] = {&tuning.tuned, &tuning.untuned, &tuning.ours};
    std::vector<Contender> contenders;
    for (const Judged* judged : all) contenders.push_back(judged->contender);
    const std::vector<std::vector<double>> times = trials.times(contenders);
    for (std::size_t i = 0; i < std::size(all); ++i)
        all[i]->score = {trials.error(contenders[i]), mean(times[i])};
    const Score &tuned = tuning.tuned.score, &untuned = tuning.untuned.score;
    // On these windows the engine as it comes may turn out better than what was found on others.
    const bool is_better =
        untuned.error <= tuning.target && (tuned.error > tuning.target || untuned.cost < tuned.cost);
    const std::size_t best = is_better ? 1 : 0;
    if (is_better) tuning.tuned = tuning.untuned;
    tuning.tuned.contender.name = std::string(tuning.untuned.contender.engine->name) + "-tuned";
    for (Judged* const judged : all) judged->text = text_of(judged->contender, trials.scene());
    tuning.over_untuned = ratio(times[best], times[1]);
    tuning.over_ours = ratio(times[best], times[2]);
}

}  // namespace

std::vector<Tuning> tune(const Request& request, const sweep::Variant& variant,
                         const std::function<void(double)>& watch) {
    double done = 0;
    const std::function<void()> look = [&] { watch(done); };
    const Trials search(variant, request.seed, Trials::search_block, request.windows, look);
    const Trials check(variant, request.seed, Trials::check_block, request.windows, look);
    std::vector<double> targets = request.targets;
    std::ranges::sort(targets, std::greater<>());
    Tuner tuner(*request.engine, search, request.finest, request.most_seconds);
    const Engine& custom = engine_named("custom");
    const SettingChange exact{&custom, "solver", "continuous"};
    std::vector<Tuning> all;
    for (const double target : targets) {
        const auto plain = [&](const Engine& engine, std::span<const SettingChange> changes) {
            return Judged{untuned(engine, search, request.finest, target, changes).contender};
        };
        const Found found = tuner.cheapest(target);
        Tuning tuning{variant.name,
                      target,
                      {found.contender},
                      plain(*request.engine, {}),
                      plain(custom, std::span(&exact, 1)),
                      found.tried};
        judge(tuning, check);
        all.push_back(std::move(tuning));
        ++done;
    }
    return all;
}

void write_csv(std::ostream& out, std::span<const Tuning> all) {
    out << "variant,target,tried,role,contender,error,cpu,ratio,ratio_low,ratio_high\n";
    CsvRow row;
    const auto write = [&](const Tuning& tuning, const char* role, const Judged& judged,
                           const std::optional<Median>& ratio) {
        row.add(tuning.variant).add(tuning.target).add(tuning.tried).add(role).add(judged.text);
        row.add(judged.score.error).add(judged.score.cost);
        const Median none{NAN, NAN, NAN}, shown = ratio.value_or(none);
        row.add(shown.value).add(shown.low).add(shown.high).write(out);
    };
    for (const Tuning& tuning : all) {
        write(tuning, "tuned", tuning.tuned, Median{1, 1, 1});
        write(tuning, "untuned", tuning.untuned, tuning.over_untuned);
        write(tuning, "custom", tuning.ours, tuning.over_ours);
    }
}

}  // namespace flipside::lab::tune
