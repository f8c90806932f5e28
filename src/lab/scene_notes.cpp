#include "lab/scene_notes.hpp"

#include "custom/geometry/bounds.hpp"
#include "custom/geometry/inside.hpp"

namespace flipside::lab {

namespace {

std::string name_of(const Ball& ball) {
    return "ball " + std::to_string(ball.number);
}

void note_parts(const Scene& scene, const Ball& ball, std::vector<std::string>& notes) {
    for (const Part& part : scene.parts)
        if (!part.sensor && layers_meet(ball, part) && custom::inside(ball.position, part.shape))
            notes.push_back(name_of(ball) + " starts inside part '" + part.name + "'");
}

}  // namespace

std::vector<std::string> notes_on(const Scene& scene) {
    std::vector<std::string> notes;
    for (const Ball& ball : scene.balls) {
        if (!custom::overlap(scene.bounds, ball.position, ball.radius))
            notes.push_back(name_of(ball) + " starts outside the bounds");
        note_parts(scene, ball, notes);
        for (const Ball& other : scene.balls) {
            if (other.number >= ball.number) break;
            const double touching = ball.radius + other.radius;
            // Balls laid side by side in decimals may overlap by a rounding.
            constexpr double tolerance = 1e-9;
            if (layers_meet(ball, other) &&
                length(ball.position - other.position) < touching * (1 - tolerance))
                notes.push_back(name_of(ball) + " starts inside " + name_of(other));
        }
    }
    return notes;
}

}  // namespace flipside::lab
