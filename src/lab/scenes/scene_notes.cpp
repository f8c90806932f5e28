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

/// A bit for each layer that something is on.
std::uint32_t layers_in_use(const Scene& scene) {
    std::uint32_t used = scene.launcher ? scene.launcher->ball.layer : 0;
    for (const Ball& ball : scene.balls) used |= ball.layer;
    for (const Part& part : scene.parts) used |= part.layer;
    return used;
}

/// Layers that somebody names in collides_with alone: a slip of the pen, more often than not.
std::vector<std::string> notes_on_layers(const Scene& scene) {
    std::vector<std::string> notes;
    const std::uint32_t used = layers_in_use(scene);
    for (std::size_t i = 1; i < scene.layers.size(); ++i)
        if ((used >> i & 1U) == 0)
            notes.push_back("nothing is on layer '" + scene.layers[i] + "', which a collides_with names");
    return notes;
}

}  // namespace

std::vector<std::string> notes_on(const Scene& scene) {
    // What the custom engine finds in touch when nothing has moved yet: it need not look at every pair.
    const auto world =
        custom::engine().make(std::make_shared<const Scene>(scene), Settings(custom::engine().settings));
    const std::span<const Contact> contacts = world->contacts();
    std::vector<std::string> notes = notes_on_layers(scene);
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
