#include "app/window/card.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/window/words.hpp"
#include "world/printable.hpp"
#include "world/surface.hpp"
#include "world/table.hpp"

namespace flipside::app {

namespace {

constexpr std::string_view not_told = "not told";

std::string degrees(double radians) {
    const double angle = radians * 180 / std::numbers::pi;
    return with_unit(angle, 1, "") + "°";
}

std::string both(Vec2 v, int digits) {
    return with_unit(v.x, digits, "") + ", " + with_unit(v.y, digits, "");
}

/// Names come from files and may be of any length.
std::string short_name(std::string_view name) {
    constexpr std::size_t most = 18;  // bytes, the ellipsis too
    return shortened(printable(name), [](const std::string& words) { return words.size() <= most; });
}

std::string called(Other what, const Scene& scene) {
    if (what.is_ball) return "ball " + std::to_string(what.index);
    return short_name(scene.parts[what.index].name);
}

/// Of two that met, the one that `subject` is not.
Other met(const Event& event, Other subject) {
    return event.other == subject ? Other::ball(event.ball) : event.other;
}

const Ball* ball_in(const Run& run, BallNumber number) {
    return find_ball(run.session().world().balls(), number);
}

/// The impact of the last step between the same two, if it told of one.
const Event* impact_of(const Run& run, const Contact& contact) {
    const auto same = [&](const Event& event) {
        return event.kind == EventKind::impact && event.ball == contact.ball && event.other == contact.other;
    };
    const auto events = run.events();
    const auto at = std::find_if(events.rbegin(), events.rend(), same);
    return at == events.rend() ? nullptr : &*at;
}

/// The restitution that the materials of two that met have together; "" where one is gone.
std::string of_materials(const Run& run, const Event& event) {
    const Scene& scene = run.session().scene();
    const auto material_of = [&](Other what) -> const Material* {
        if (!what.is_ball) return &scene.materials[scene.parts[what.index].material];
        const Ball* ball = ball_in(run, what.index);
        return ball ? &scene.materials[ball->material] : nullptr;
    };
    const Material *a = material_of(Other::ball(event.ball)), *b = material_of(event.other);
    return a && b ? with_unit(mix(*a, *b).restitution, 3, "") : "";
}

/// The touches of a ball or part, as many as are shown.
struct Touches {
    std::vector<Contact> shown;
    std::size_t more = 0;
};

Touches touches_of(const Run& run, Other subject) {
    constexpr std::size_t most = 2;
    Touches touches;
    for (const Contact& contact : run.session().world().contacts()) {
        if (!(contact.other == subject || (subject.is_ball && contact.ball == subject.index))) continue;
        if (touches.shown.size() < most)
            touches.shown.push_back(contact);
        else
            ++touches.more;
    }
    return touches;
}

/// The restitution that came about, beside that of the materials.
std::string restitution_in_words(const Run& run, const lab::Impact& impact) {
    const auto restitution = impact.restitution();
    const std::string materials = of_materials(run, impact.event);
    return (restitution ? with_unit(*restitution, 3, "") : std::string(not_told)) +
           (materials.empty() ? "" : " of " + materials);
}

/// "17.0 ms late", "normal 2.1° off".
std::string in_words(const lab::ImpactVerdict& verdict, Other subject, const Scene& scene) {
    if (verdict.missed)
        return called(met(verdict.impact, subject), scene) + "\nmissed at " +
               with_unit(verdict.impact.time, 3, "s");
    if (!verdict.error) return "not hit by\nthe reference";
    const double late = verdict.error->late, degrees_off = verdict.error->normal * 180 / std::numbers::pi;
    std::string words = "on time";
    if (std::abs(late) >= 1e-10) words = engineering(std::abs(late), "s") + (late > 0 ? " late" : " early");
    if (degrees_off < 1e-9) return words + "\nnormal exact";
    return words + "\nnormal " + (degrees_off < 0.1 ? "< 0.1" : with_unit(degrees_off, 1, "")) + "° off";
}

class Writer {
  public:
    Writer(const Stage& stage, Other subject) : stage_(stage), subject_(subject) { card_.subject = subject; }

    void ball() {
        card_.title = called(subject_, stage_.scene());
        const Run* some = nullptr;
        for (const Run& run : stage_.runs())
            if (!some && ball_in(run, subject_.index)) some = &run;
        if (!some) {
            card_.about = "gone";
            return;
        }
        const Ball& ball = *ball_in(*some, subject_.index);
        const Scene& scene = stage_.scene();
        card_.about = engineering(1000 * ball.mass, "g") + "  ·  radius " + engineering(ball.radius, "m") +
                      "  ·  " + short_name(scene.materials[ball.material].name);
        of_ball("Position, mm", "Of its centre", [](const Ball& b) { return both(1000 * b.position, 1); });
        of_ball("Velocity, m/s", "Along x and y", [](const Ball& b) { return both(b.velocity, 3); });
        of_ball("Speed", "Of its centre; asleep: the engine does not move it",
                [](const Ball& b) { return b.asleep ? "asleep" : with_unit(length(b.velocity), 3, "m/s"); });
        of_ball("Spin", "Anticlockwise", [](const Ball& b) { return with_unit(b.spin, 2, "rad/s"); });
        of_ball("Energy", "½mv² + ½Iω² − m g·p, with I = ½mr² and 0 at the origin of the scene",
                [&scene](const Ball& b) {
                    return engineering(0.5 * b.mass * length_squared(b.velocity) +
                                           0.5 * inertia(b) * b.spin * b.spin -
                                           b.mass * dot(scene.gravity, b.position),
                                       "J");
                });
    }
    void part() {
        const Scene& scene = stage_.scene();
        const Part& part = scene.parts[subject_.index];
        const Material& material = scene.materials[part.material];
        card_.title = called(subject_, scene);
        card_.about = short_name(material.name) + "  ·  restitution " +
                      with_unit(material.restitution, 2, "") + "  ·  friction " +
                      with_unit(material.friction, 2, "");
        if (material.kick > 0) card_.about += "  ·  kick " + with_unit(material.kick, 2, "m/s");
        if (part.sensor) card_.about += "  ·  sensor: balls pass";
        const auto state = [this](const Run& run) { return run.session().world().parts()[subject_.index]; };
        if (Table::moves(part))
            row("Angle", "From where the scene file has it, anticlockwise",
                [&](const Run& run) { return degrees(state(run).angle); });
        if (gate_of(part))
            row("Gate", "It stays open while a ball is in it",
                [&](const Run& run) { return state(run).open ? "open" : "closed"; });
        if (part.target)
            row("Target", "Gone after a hit, until it is raised again",
                [&](const Run& run) { return state(run).down ? "down" : "up"; });
    }
    /// They come and go with every step, so they come last.
    void touches() {
        row("Touches", "What it touches now", [this](const Run& run) {
            const Touches touches = touches_of(run, subject_);
            std::string words;
            for (const Contact& contact : touches.shown)
                words += (words.empty() ? "" : "\n") +
                         called(contact.other == subject_ ? Other::ball(contact.ball) : contact.other,
                                run.session().scene());
            if (touches.more > 0) words += "\nand " + std::to_string(touches.more) + " more";
            return words.empty() ? "nothing" : words;
        });
        of_touches("  normal", "Towards it, as an angle from the x axis",
                   [this](const Run&, const Contact& contact) {
                       const bool other_way = contact.other == subject_;
                       return degrees(angle_of(other_way ? -contact.normal : contact.normal));
                   });
        of_touches("  depth", "By which the two overlap, or are apart",
                   [](const Run&, const Contact& contact) {
                       const std::string depth = engineering(std::abs(contact.separation), "m");
                       return contact.separation > 0 ? depth + " apart" : depth;
                   });
        of_touches("  impulse", "Along the normal, of the impact in this step",
                   [](const Run& run, const Contact& contact) {
                       const Event* impact = impact_of(run, contact);
                       return impact ? engineering(impact->impulse, "N·s") : std::string(not_told);
                   });
        of_touches("  restitution", "Of the two materials, for the impact in this step",
                   [](const Run& run, const Contact& contact) {
                       const Event* impact = impact_of(run, contact);
                       const std::string materials = impact ? of_materials(run, *impact) : "";
                       return materials.empty() ? std::string(not_told) : materials;
                   });
    }
    void impact() {
        row("Last impact", "With what, and when; engines that only know contacts per step tell its end",
            [this](const Run& run) {
                const auto last = last_of(run);
                if (!last) return std::string("none");
                return called(met(last->event, subject_), run.session().scene()) + "\n" +
                       with_unit(last->event.time, 4, "s");
            });
        of_impact(
            "Speed before", "Along the normal, in the frame of what was met",
            [](const Run&, const lab::Impact& impact) { return with_unit(impact.event.speed, 3, "m/s"); });
        of_impact("Speed after", "Along the normal too, as the impulse has it",
                  [](const Run&, const lab::Impact& impact) {
                      return impact.leaving ? with_unit(*impact.leaving, 3, "m/s") : std::string(not_told);
                  });
        of_impact("Restitution",
                  "The speed after over that before, of what the materials have together. Kickers add to it",
                  restitution_in_words);
        of_impact("Impulse", "Along the normal", [](const Run&, const lab::Impact& impact) {
            return engineering(impact.event.impulse, "N·s");
        });
        of_impact(
            "Normal", "From what was met to the ball, as an angle from the x axis",
            [](const Run&, const lab::Impact& impact) { return degrees(angle_of(impact.event.normal)); });
        if (const Run* exact = stage_.exact())
            row("Wrong by", "Against the reference, as long as that is sure",
                [&](const Run& run) { return verdict(run, *exact); });
    }
    void title(std::string words, std::string about) {
        card_.title = std::move(words);
        card_.about = std::move(about);
    }
    [[nodiscard]] Card card() { return std::move(card_); }

  private:
    template <class Cell>
    void row(const char* label, const char* meaning, const Cell& cell) {
        Card::Row row{label, {}, meaning};
        for (const Run& run : stage_.runs()) row.cells.emplace_back(cell(run));
        const auto says = [](const std::string& words) { return !words.empty(); };
        if (std::ranges::any_of(row.cells, says)) card_.rows.push_back(std::move(row));
    }
    template <class Cell>
    void of_touches(const char* label, const char* meaning, const Cell& cell) {
        row(label, meaning, [&](const Run& run) {
            std::string words;
            for (const Contact& contact : touches_of(run, subject_).shown)
                words += (words.empty() ? "" : "\n") + cell(run, contact);
            return words;
        });
    }
    template <class Cell>
    void of_ball(const char* label, const char* meaning, const Cell& cell) {
        row(label, meaning, [&](const Run& run) -> std::string {
            const Ball* ball = ball_in(run, subject_.index);
            return ball ? cell(*ball) : "gone";
        });
    }
    template <class Cell>
    void of_impact(const char* label, const char* meaning, const Cell& cell) {
        row(label, meaning, [&](const Run& run) -> std::string {
            const auto last = last_of(run);
            return last ? cell(run, *last) : "";
        });
    }
    [[nodiscard]] std::optional<lab::Impact> last_of(const Run& run) const {
        return run.impacts().last(subject_, run.session().world().time());
    }
    [[nodiscard]] std::string verdict(const Run& run, const Run& exact) const {
        if (&run == &exact || run.halt()) return "";
        const double now = run.session().world().time();
        const double certain = std::min(exact.passed_horizon().value_or(now), exact.session().world().time());
        // Two steps of most engines, or as many of a long one.
        constexpr double least = 0.1;
        const auto verdict =
            lab::judge(run.impacts(), exact.impacts(), subject_, std::max(least, 2 * run.dt()), now, certain);
        if (verdict) return in_words(*verdict, subject_, stage_.scene());
        const auto last = last_of(run);
        if (!last) return "";
        return last->event.time > certain ? "not known" : "not known yet";
    }

    const Stage& stage_;
    Other subject_;
    Card card_;
};

/// Of the exact run, or else the first that has had one.
std::optional<lab::Impact> last_impact(const Stage& stage) {
    if (const Run* exact = stage.exact())
        if (auto last = exact->impacts().last(stage.time())) return last;
    for (const Run& run : stage.runs())
        if (auto last = run.impacts().last(run.session().world().time())) return last;
    return std::nullopt;
}

}  // namespace

std::optional<Card> card_of(const Stage& stage, std::optional<Other> subject) {
    if (subject && !subject->is_ball && subject->index >= stage.scene().parts.size()) return std::nullopt;
    if (subject) {
        Writer writer(stage, *subject);
        if (subject->is_ball)
            writer.ball();
        else
            writer.part();
        writer.impact();
        writer.touches();
        return writer.card();
    }
    const auto last = last_impact(stage);
    const Other ball = Other::ball(last ? last->event.ball : 0);
    Writer writer(stage, ball);
    writer.title("Last impact", last ? "of " + called(ball, stage.scene()) : "none yet");
    if (last) writer.impact();
    return writer.card();
}

}  // namespace flipside::app
