/// flipside_check_certificate FILE [BOUND]: checks what `flipside certify` wrote.

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string_view>

#include "check.hpp"

namespace {

constexpr const char* help =
    "usage: flipside_check_certificate FILE [BOUND]\n"
    "Checks a certificate that `flipside certify` wrote, by interval arithmetic: that every path is "
    "continuous and\n"
    "obeys the equation of motion, every impact its law, that what rests is in equilibrium, and that nothing "
    "came\n"
    "earlier. BOUND is relative (to the radius, the speed, the acceleration), from 1e-12 to 1e-4; default "
    "1e-9.\n"
    "Exit codes: 0 accepted, 1 rejected, 2 bad usage or a file that is no certificate.\n";

/// Text from a file, for a terminal.
std::string plain(std::string text) {
    for (char& c : text)
        if (c < ' ' || c > '~') c = '?';
    return text;
}
int refuse(const std::string& why) {
    std::fprintf(stderr, "flipside_check_certificate: %s\n", plain(why).c_str());
    return 2;
}

void report(const certificate::Run& run, const certificate::Verdict& v) {
    std::printf(
        "accepted: %.9g s, %zu balls, %zu segments (%zu in contact, %zu at rest), %zu impacts, %zu touches "
        "without approach, %zu given from outside; %zu enclosures\n",
        run.seconds, v.balls, v.legs, v.held, v.resting, v.impacts, v.touches, v.given, v.enclosures);
    for (const auto& [what, share] : v.largest)
        std::printf("  %-34s %.2g of the bound\n", what.c_str(), share);
    if (v.resting > 0) std::printf("gaps and overlaps of what rests: up to %.2g radii\n", v.loosest);
    std::printf("uncertified: %zu impacts without an isolating interval\n", v.not_isolated);
    if (!run.ends.empty()) std::printf("ends early: %s\n", plain(run.ends).c_str());
}

}  // namespace

int main(int argc, char** argv) {
    if (argc == 2 && std::string_view(argv[1]) == "--help") return std::fputs(help, stdout) < 0;
    char* end = nullptr;
    const double bound = argc == 3 ? std::strtod(argv[2], &end) : 1e-9;
    if (argc < 2 || argc > 3 || (end != nullptr && *end != 0) || !(bound >= 1e-12 && bound <= 1e-4))
        return refuse("takes a FILE and perhaps a BOUND from 1e-12 to 1e-4 (--help says more)");
    try {
        std::ifstream file(argv[1]);
        auto run = nlohmann::json::parse(file).get<certificate::Run>();
        report(run, certificate::check(run, bound));
        return 0;
    } catch (const certificate::Rejected& rejected) {
        std::printf("rejected: %s\n", plain(rejected.what()).c_str());
        return 1;
    } catch (const std::exception& error) {
        return refuse(std::string(argv[1]) + ": " + error.what());
    }
}
