/// flipside_check_certificate FILE [BOUND]: checks what `flipside certify` wrote. Exit codes: 0 accepted,
/// 1 rejected, 2 bad usage or a file that is no certificate.

#include <cstdio>
#include <cstdlib>
#include <string>

#include "check.hpp"

int main(int argc, char** argv) {
    const double bound = argc > 2 ? std::atof(argv[2]) : 1e-9;
    if (argc < 2 || argc > 3 || !(bound > 0 && bound < 1e-3)) {
        std::fprintf(
            stderr,
            "usage: flipside_check_certificate FILE [BOUND]   (relative, below 1e-3; default 1e-9)\n");
        return 2;
    }
    certificate::Run run;
    try {
        run = certificate::read(argv[1]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "flipside_check_certificate: %s: %s\n", argv[1], error.what());
        return 2;
    }
    try {
        const certificate::Verdict v = certificate::check(run, bound);
        std::printf(
            "accepted: %.9g s, %zu balls, %zu segments (%zu in contact), %zu impacts, %zu touches without "
            "approach, %zu given from outside; %zu enclosures\n",
            run.seconds, v.balls, v.legs, v.held, v.impacts, v.touches, v.given, v.enclosures);
        for (const auto& [what, share] : v.largest)
            std::printf("  %-34s %.2g of the bound\n", what.c_str(), share);
        std::printf("uncertified: %zu impacts without an isolating interval\n", v.not_isolated);
        if (!run.ends.empty()) std::printf("ends early: %s\n", run.ends.c_str());
        return 0;
    } catch (const certificate::Rejected& rejected) {
        std::printf("rejected: %s\n", rejected.what());
        return 1;
    }
}
