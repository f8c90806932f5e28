#include "world/trace.hpp"

#include <algorithm>
#include <cstdio>

#include "world/printable.hpp"
#include "world/world.hpp"

namespace flipside {

namespace {

struct InBrief {
    std::string operator()(bool value) const { return value ? "yes" : "no"; }
    std::string operator()(std::int64_t value) const { return std::to_string(value); }
    std::string operator()(double value) const { return brief(value); }
    std::string operator()(const std::string& value) const { return printable(value); }
    std::string operator()(Vec2 value) const { return '(' + brief(value.x) + ", " + brief(value.y) + ')'; }
    std::string operator()(const Box& value) const { return (*this)(value.min) + ".." + (*this)(value.max); }
    std::string operator()(const std::vector<double>& values) const {
        std::string text = "[";
        for (const double value : values) text += (text.size() > 1 ? ", " : "") + brief(value);
        return text + ']';
    }
};

}  // namespace

TraceItem& TraceItem::with(std::string_view name, TraceValue value) {
    fields.emplace_back(std::string(name), std::move(value));
    return *this;
}

TraceItem& TraceItem::with_other(Other other, const Scene& scene) {
    if (other.is_ball) return with("other_ball", other.index);
    return with("part", scene.parts[other.index].name);
}

TraceItem& TraceItem::with_impact(const Event& impact) {
    return with("point", impact.point)
        .with("normal", impact.normal)
        .with("speed", impact.speed)
        .with("impulse", impact.impulse);
}

const TraceValue* TraceItem::find(std::string_view name) const {
    const auto at = std::ranges::find(fields, name, &std::pair<std::string, TraceValue>::first);
    return at == fields.end() ? nullptr : &at->second;
}

void trace_read_out(Trace& trace, std::string_view where, const World& world, const Scene& scene) {
    const auto balls = world.balls();
    const auto events = world.events();
    TraceStage& stage = trace.stage("read-out", where);
    for (const Ball& ball : balls)
        stage.add("ball")
            .with("ball", ball.number)
            .with("position", ball.position)
            .with("velocity", ball.velocity)
            .with("angle", ball.angle)
            .with("spin", ball.spin)
            .with("asleep", ball.asleep);
    for (const Event& event : events) {
        TraceItem& item = stage.add("event");
        item.with("time", event.time).with("event", name_of(event.kind)).with("ball", event.ball);
        if (event.kind != EventKind::lost) item.with_other(event.other, scene);
        if (event.kind == EventKind::impact)
            item.with_impact(event);
        else
            item.with("point", event.point);
    }
    stage.says = "The step is over: " + counted(balls.size(), "ball") + ", " +
                 counted(events.size(), "event") + ", " + counted(world.contacts().size(), "contact") + ".";
}

std::vector<double> swept(double from, double to, const std::function<Vec2(double)>& place) {
    constexpr int primitives = 12;
    std::vector<double> path;
    for (int k = 0; k <= primitives; ++k) {
        const Vec2 at = place(from + k * (to - from) / primitives);
        path.push_back(at.x);
        path.push_back(at.y);
    }
    return path;
}

std::string brief(double number) {
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", number + 0.0);  // no sign of a zero
    return text;
}

std::string milliseconds(double seconds) {
    return brief(1e3 * seconds) + " ms";
}

std::string counted(std::uint64_t n, std::string_view thing) {
    return std::to_string(n) + ' ' + std::string(thing) + (n == 1 ? "" : "s");
}

std::string in_brief(const TraceValue& value) {
    return std::visit(InBrief{}, value);
}

}  // namespace flipside
