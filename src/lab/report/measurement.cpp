#include "lab/report/measurement.hpp"

#include <algorithm>
#include <cstdlib>
#include <vector>

#include "lab/files/csv.hpp"
#include "lab/files/csv_table.hpp"
#include "lab/files/text_stream.hpp"
#include "lab/process/cpu_clock.hpp"

namespace flipside::lab::report {

namespace {

constexpr const char* spent_file = "spent.csv";

}  // namespace

Data::Data(std::filesystem::path folder, const std::string& effort, const std::string& commit, Notice notice)
    : folder_(std::move(folder)),
      origin_(origin_of("report", {effort, commit})),
      notice_(std::move(notice)) {}

std::string Data::origin(const std::string& file) const {
    return origin_of("measurement", {origin_, file});
}

bool Data::has(const std::string& file) const {
    const auto text = read_back(
        path(file), notice_, [&] { return read(file); }, "it is measured again");
    return text.has_value();
}

std::string Data::read(const std::string& file) const {
    return read_data_file(path(file), origin(file));
}

void Data::write(const std::string& file, const std::string& text) const {
    write_data_file(path(file), origin(file), text);
}

Spent Data::spent() const {
    if (!has(spent_file)) return {};
    const CsvTable table(path(spent_file), read(spent_file));
    return {table.finite(0, "cpu_seconds"), table.finite(0, "cpu_most_load")};
}

void Data::spend(double cpu_seconds) const {
    Spent all = spent();
    double load = 0;
    if (getloadavg(&load, 1) == 1) all.most_load = std::max(all.most_load, load);
    TextStream file;
    CsvRow row;
    row.add("cpu_seconds").add("cpu_most_load").write(file);
    row.add(all.cpu_seconds + cpu_seconds).add(all.most_load).write(file);
    write(spent_file, file.str());
}

Measurement measurement_of_file(const std::string& file, double seconds,
                                std::function<std::string(const Watch& watch)> measure) {
    return {seconds, [file](const Data& data) { return data.has(file); },
            [file, measure = std::move(measure)](const Data& data, const Watch& watch) {
                data.write(file, measure(watch));
            }};
}

void take(std::span<const Measurement> measurements, const Data& data, const Watch& watch) {
    double whole = 0, done = 0;
    for (const Measurement& measurement : measurements) whole += measurement.seconds;
    const auto watch_part = [&](double begin, double seconds) {
        return [&watch, begin, seconds, whole](double share) { watch((begin + share * seconds) / whole); };
    };
    // What is there counts first, so that it is not taken for quick work in the time left.
    std::vector<const Measurement*> missing;
    for (const Measurement& measurement : measurements) {
        if (measurement.is_done(data))
            done += measurement.seconds;
        else
            missing.push_back(&measurement);
    }
    for (const Measurement* measurement : missing) {
        watch(done / whole);
        const CpuStopwatch stopwatch;
        measurement->take(data, watch_part(done, measurement->seconds));
        data.spend(stopwatch.seconds());
        done += measurement->seconds;
    }
    watch(1);
}

}  // namespace flipside::lab::report
