#include "lab/scenes/scene_notes.hpp"

#include <algorithm>

#include "custom/engine.hpp"

namespace flipside::lab {

namespace {

std::string name_of(const Ball& ball) {
    return "ball " + std::to_string(ball.number);
}

bool is_outside(const Ball& ball, const Box& bounds) {
    const Vec2 nearest{std::clamp(ball.position.x, bounds.min.x, bounds.max.x),
                       std::clamp(ball.position.y, bounds.min.y, bounds.max.y)};
    return length_squared(ball.position - nearest) > ball.radius * ball.radius;
}

}  // namespace

std::vector<std::string> notes_on(const Scene& scene) {
    // What the custom engine finds in touch when nothing has moved yet: it need not look at every pair.
    const auto world =
        custom::engine().make(std::make_shared<const Scene>(scene), Settings(custom::engine().settings));
    const std::span<const Contact> contacts = world->contacts();
    std::vector<std::string> notes;
    auto contact = contacts.begin();
    for (const Ball& ball : scene.balls) {
        if (is_outside(ball, scene.bounds)) notes.push_back(name_of(ball) + " starts outside the bounds");
        for (; contact != contacts.end() && contact->ball == ball.number; ++contact) {
            if (contact->other.is_ball) {
                const Ball& other = scene.balls[contact->other.index];
                // Balls laid side by side in decimals may overlap by a rounding.
                constexpr double tolerance = 1e-9;
                if (-contact->separation > tolerance * (ball.radius + other.radius))
                    notes.push_back(name_of(other) + " starts inside " + name_of(ball));
            } else if (contact->separation < -ball.radius) {  // its centre is inside
                notes.push_back(name_of(ball) + " starts inside part '" +
                                scene.parts[contact->other.index].name + "'");
            }
        }
    }
    return notes;
}

}  // namespace flipside::lab
