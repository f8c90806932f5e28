/// flipside_check_certificate FILE [BOUND]: checks what `flipside certify` wrote.

#include <cmath>
#include <cstdio>
#include <fstream>

#include <CLI/CLI.hpp>

#include "checker.hpp"

namespace {

/// Text from a file, for a terminal.
std::string plain(std::string text) {
    std::ranges::replace_if(
        text, [](char c) { return c < ' ' || c > '~'; }, '?');
    return text;
}

}  // namespace

int main(int argc, char** argv) try {
    CLI::App app(
        "Checks a certificate that `flipside certify` wrote, by interval arithmetic: that every path is "
        "continuous and obeys the equation of motion, every impact its law, that what rests is in "
        "equilibrium, and that nothing came earlier. Exit codes: 0 accepted, 1 rejected, 2 bad usage or a "
        "file that is no certificate.");
    std::string file;
    double bound = 1e-9;
    app.add_option("FILE", file)->required();
    app.add_option("BOUND", bound, "relative to the radius, the speed, the acceleration")
        ->check(CLI::Range(1e-12, 1e-4));
    try {
        app.parse(argc, argv);
        if (std::isnan(bound))  // neither below nor above the range
            throw CLI::ValidationError("BOUND", "nan is no number; allowed is 1e-12 to 1e-4");
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : 2;
    }
    std::ifstream text(file);
    if (!text) throw std::runtime_error("cannot be read");
    const certificate::Run run = certificate::read(text);
    const certificate::Verdict v = certificate::Checker(run, bound).check();
    std::printf(
        "accepted: %.9g s, %zu balls, %zu segments (%zu in contact, %zu at rest), %zu impacts, %zu touches "
        "without approach, %zu given from outside; %zu enclosures\n"
        "gaps and overlaps of what rests or rolls: up to %.2g radii\n"
        "uncertified: %zu impacts without an isolating interval\n",
        run.seconds, run.balls.size(), v.legs, v.held, v.resting, v.impacts, v.touches, v.given, v.enclosures,
        v.loosest, v.not_isolated);
    if (!run.ends.empty()) std::printf("ends early: %s\n", plain(run.ends).c_str());
    return 0;
} catch (const certificate::Rejected& rejected) {
    std::printf("rejected: %s\n", plain(rejected.what()).c_str());
    return 1;
} catch (const std::exception& error) {
    std::fprintf(stderr, "flipside_check_certificate: %s\n",
                 plain(std::string(argv[1]) + ": " + error.what()).c_str());
    return 2;
}
