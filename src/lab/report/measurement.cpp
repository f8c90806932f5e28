#include "lab/report/measurement.hpp"

namespace flipside::lab::report {

void take(std::span<const Measurement> measurements, const std::filesystem::path& folder,
          const Watch& watch) {
    double whole = 0, done = 0;
    for (const Measurement& measurement : measurements) whole += measurement.seconds;
    const auto watch_part = [&](double begin, double seconds) {
        return [&watch, begin, seconds, whole](double share) { watch((begin + share * seconds) / whole); };
    };
    // What is there counts first, so that it is not taken for quick work in the time left.
    for (const Measurement& measurement : measurements)
        if (exists(folder / measurement.file)) done += measurement.seconds;
    for (const Measurement& measurement : measurements) {
        if (exists(folder / measurement.file)) continue;
        watch(done / whole);
        measurement.take(folder / measurement.file, watch_part(done, measurement.seconds));
        done += measurement.seconds;
    }
    watch(1);
}

}  // namespace flipside::lab::report
