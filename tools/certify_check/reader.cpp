#include "reader.hpp"

#include <fstream>
#include <stdexcept>

namespace certificate {

Run read(const std::string& file) {
    const auto require = [](bool holds, const std::string& what) {
        if (!holds) throw std::runtime_error(what);
    };
    std::ifstream in(file);
    require(in.good(), "cannot be read");
    Run run = nlohmann::json::parse(in).get<Run>();
    require(run.format == "flipside-certificate/1", "\"format\" is not \"flipside-certificate/1\"");
    for (const Part& part : run.parts) require(part.material < run.materials.size(), "a part of no material");
    for (const Primitive& p : run.primitives) {
        struct Needs {
            const char* type;
            std::size_t points, radii, angles;
        };
        constexpr Needs all[] = {{"point", 1, 0, 0}, {"segment", 2, 0, 0}, {"circle", 1, 1, 0},
                                 {"arc", 1, 1, 2},   {"taper", 2, 2, 0},   {"polygon", 3, 0, 0}};
        bool fits = false;
        for (const Needs& needs : all)
            fits = fits || (p.type == needs.type && p.points.size() >= needs.points &&
                            p.radii.size() == needs.radii && p.angles.size() == needs.angles);
        require(fits && p.part < run.parts.size(),
                "a primitive of type '" + p.type + "' that is no such primitive");
    }
    for (Ball& ball : run.balls) {
        const std::string name = "ball " + std::to_string(ball.number);
        require(
            ball.radius > 0 && ball.mass > 0 && ball.material < run.materials.size() && !ball.legs.empty(),
            name + " has no size, mass, material or segment");
        for (std::size_t i = 0; i < ball.legs.size(); ++i) {
            Leg& leg = ball.legs[i];
            const double last = ball.gone.empty() ? run.seconds : ball.gone[0];
            leg.end = i + 1 < ball.legs.size() ? ball.legs[i + 1].start : last;
            require(leg.start <= leg.end, name + ": a segment ends before it starts");
            require(leg.form == "closed" || leg.form == "series" || leg.form == "rest",
                    name + ": form '" + leg.form + "'");
            require(leg.why == "given" || leg.why == "goes on" || leg.why == "part" || leg.why == "ball",
                    name + ": a segment begins by '" + leg.why + "'");
            require(leg.spins.size() == leg.displacements.size(), name + ": a series lacks terms");
            require(leg.why != "part" || leg.met < run.primitives.size(), name + " meets no primitive");
            for (const std::size_t primitive : leg.held)
                require(primitive < run.primitives.size(), name + " lies on no primitive");
        }
    }
    return run;
}

}  // namespace certificate
