#include "custom/trace/simple_trace.hpp"

#include <algorithm>
#include <map>

#include "custom/tolerances.hpp"
#include "custom/trace/explain.hpp"

namespace flipside::custom {

SimpleTrace::SimpleTrace(Trace& trace, const Table& table, const std::vector<Ball>& balls,
                         const Layout& layout, BroadPhase& broad)
    : trace_(trace), table_(table), scene_(table.scene()), balls_(balls), layout_(layout), broad_(broad) {
    broad_.log_searches(&log_);
}

void SimpleTrace::begin(std::string_view name, std::string_view function) {
    trace_.stage(name, "src/custom/simple/simple_solver.cpp: SimpleSolver::" + std::string(function));
}

void SimpleTrace::begin_motion(int k, int n) {
    of_motion_ = n > 1 ? "Motion iteration " + std::to_string(k) + " of " + std::to_string(n) + ". " : "";
    before_ = balls_;
    tests_before_ = broad_.tests();
}

void SimpleTrace::moved(double seconds) {
    begin("move", "move_balls");
    for (std::size_t i = 0; i < balls_.size(); ++i)
        stage()
            .add("move")
            .with("ball", balls_[i].number)
            .with("position_before", before_[i].position)
            .with("velocity_before", before_[i].velocity)
            .with("angle_before", before_[i].angle)
            .with("spin", balls_[i].spin)
            .with("gravity", scene_.gravity)
            .with("damping", scene_.damping)
            .with("seconds", seconds)
            .with("position", balls_[i].position)
            .with("velocity", balls_[i].velocity)
            .with("angle", balls_[i].angle)
            .with("formula", scene_.damping > 0 ? "p' = p + E v + F g, v' = e^(-ct) v + E g"
                                                : "p' = p + v t + g t² / 2, v' = v + g t");
    stage().says = of_motion_ + counted(balls_.size(), "ball") + (balls_.size() == 1 ? " flies" : " fly") +
                   " freely for " + milliseconds(seconds) + ", through whatever is in the way.";
}

TraceItem& SimpleTrace::name_proxy(TraceItem& item, const std::string& prefix, Handle handle) const {
    if (handle >= layout_.size()) return item.with(prefix + "ball", balls_[handle - layout_.size()].number);
    return item.with(prefix + "part", scene_.parts[layout_.primitive(handle).part].name)
        .with(prefix + "primitive", handle);
}

void SimpleTrace::found_pairs(std::span<const Proxy> moving) {
    begin("broad phase", "find_pairs");
    std::size_t overlapping = 0;
    const auto first = static_cast<Handle>(layout_.still_proxies().size());
    const std::vector<Cell> cells = broad_.cells();
    const bool two_trees = std::ranges::any_of(cells, &Cell::still);
    for (const auto& [pair, overlap, query, cell] : log_.tests) {
        TraceItem& item = name_proxy(stage().add("test"), "", pair.b);
        name_proxy(item, pair.a >= layout_.size() ? "other_" : "", pair.a);
        item.with("overlap", overlap);
        if (cell != no_cell) {
            item.with("cell", cell).with("of_still", two_trees && pair.a < first);
            name_proxy(item, "search_of_", query);
        }
        overlapping += overlap;
    }
    for (Handle i = 0; i < first + moving.size(); ++i)
        name_proxy(stage().add("box"), "", i)
            .with("box", i < first ? layout_.still_proxies()[i].box : moving[i - first].box);
    add_cells(cells);
    const std::uint64_t n = balls_.size(), all = n * (n - 1) / 2 + n * layout_.size();
    stage().says = std::to_string(overlapping) + " of " + counted(all, "pair") +
                   " survive the box test, of which the broad phase (" + std::string(broad_.facts().name) +
                   ") made " + std::to_string(broad_.tests() - tests_before_) + ".";
    log_ = {};
}

/// Adds the cells in which something is listed and, of trees, the nodes that each query visited.
void SimpleTrace::add_cells(std::span<const Cell> cells) {
    for (const Cell& cell : cells) {
        if (cell.within == 0) continue;
        TraceItem& item = stage().add("cell");
        if (cell.index != no_cell)
            item.with("level", static_cast<std::int64_t>(cell.level)).with("cell", cell.index);
        if (cell.parent != no_cell) item.with("parent", cell.parent);
        if (cell.index != no_cell) item.with("of_still", cell.still);
        item.with("listed", static_cast<std::int64_t>(cell.listed)).with("box", cell.box);
    }
    std::map<Handle, std::vector<double>[2]> visited;
    for (const auto& [query, cell, still] : log_.visits) visited[query][still].push_back(cell);
    for (const auto& [query, visits] : visited)
        name_proxy(stage().add("search"), "", query).with("cells", visits[0]).with("still_cells", visits[1]);
}

void SimpleTrace::decided_gates() {
    if (layout_.gates().empty()) return;
    begin("gates", "decide_gate");
    std::size_t open = 0;
    for (const PartIndex gate : layout_.gates()) {
        const bool is_open = table_.parts()[gate].open;
        stage().add("gate").with("part", scene_.parts[gate].name).with("open", is_open);
        open += is_open;
    }
    for (const Blocked& blocked : table_.blocked())
        stage().add("blocked").with("ball", blocked.ball).with("part", scene_.parts[blocked.gate].name);
    stage().says = counted(layout_.gates().size(), "gate") + ", " + std::to_string(open) + " open; " +
                   counted(table_.blocked().size(), "ball") + " held back.";
}

void SimpleTrace::begin_round(int k, int n) {
    of_round_ =
        n > 1 ? "Collision iteration " + std::to_string(k) + " of at most " + std::to_string(n) + ". " : "";
    begin("narrow phase", "respond_to_pairs");
    begin("response", "respond_to_pairs");
    turn_ = overlapping_ = impacts_ = resting_ = 0;
}

void SimpleTrace::passed_over(const Ball& ball, PrimitiveIndex primitive) {
    name_proxy(narrow().add("passed over").with("ball", ball.number), "", primitive)
        .with("reason", "a sensor, a target that is down, or a gate that lets this ball through");
}

void SimpleTrace::tested(const Ball& ball, PrimitiveIndex primitive, const Pose& pose, const Touch& found) {
    lower_ = ball;
    TraceItem item;
    name_proxy(item.with("turn", ++turn_).with("ball", ball.number), "", primitive);
    if (const auto* polygon = std::get_if<primitive::Polygon>(&layout_.primitive(primitive).is))
        explain_axes(narrow(), item, ball.position, ball.radius, *polygon, pose);
    item.kind = "closest";
    item.with("pivot", pose.pivot).with("pose_angle", pose.angle);
    explain_touch(item, ball.position, ball.radius, layout_.primitive(primitive), pose);
    finish_test(item, found, found.separation < -overlap_slop * ball.radius && !found.past_end);
    narrow().items.push_back(std::move(item));
}

void SimpleTrace::tested(const Ball& lower, const Ball& upper, const Touch& found) {
    lower_ = lower, upper_ = upper;
    TraceItem& item = narrow().add("closest").with("turn", ++turn_).with("ball", lower.number);
    item.with("other_ball", upper.number)
        .with("other_center", upper.position)
        .with("other_radius", upper.radius);
    explain_touch(item, lower.position, lower.radius, upper.position, upper.radius);
    finish_test(item, found, found.separation < -overlap_slop * std::min(lower.radius, upper.radius));
}

void SimpleTrace::finish_test(TraceItem& item, const Touch& found, bool overlaps) {
    item.with("center", lower_.position)
        .with("radius", lower_.radius)
        .with("point", found.point)
        .with("normal", found.normal)
        .with("separation", found.separation)
        .with("overlap", overlaps);
    overlapping_ += overlaps;
}

TraceItem& SimpleTrace::add_response(const Ball& ball, const Impact& impact, const Mixed& material,
                                     double closing) {
    const bool parting = closing <= 0;
    (impact.happened ? impacts_ : resting_) += !parting;
    TraceItem& item = stage().add("response").with("turn", turn_).with("ball", ball.number);
    item.with("answer", impact.happened ? "impact"
                        : parting       ? "parting: pushed out only"
                                        : "resting contact")
        .with("closing", closing)
        .with("speed", impact.speed)
        .with("restitution", impact.happened ? material.restitution : 0.0)
        .with("kick", material.kick)
        .with("friction", material.friction)
        .with("impulse", impact.impulse)
        .with("normal", impact.normal)
        .with("push_out", ball.position - lower_.position);
    return add_change(item, "", lower_, ball);
}

TraceItem& SimpleTrace::add_change(TraceItem& item, const std::string& prefix, const Ball& before,
                                   const Ball& after) {
    return item.with(prefix + "velocity_before", before.velocity)
        .with(prefix + "velocity", after.velocity)
        .with(prefix + "spin_before", before.spin)
        .with(prefix + "spin", after.spin)
        .with(prefix + "position_before", before.position)
        .with(prefix + "position", after.position);
}

void SimpleTrace::responded(const Ball& ball, PrimitiveIndex primitive, Vec2 surface_velocity,
                            const Impact& impact, const Mixed& material) {
    const TraceItem& seen = narrow().items.back();
    const double closing = -dot(lower_.velocity - surface_velocity, seen.get<Vec2>("normal"));
    TraceItem& item = add_response(ball, impact, material, closing);
    name_proxy(item, "", primitive)
        .with("surface_velocity", surface_velocity)
        .with("formula", "v' = v + (closing + max(e s, k)) n");
    const double out = impact.happened ? std::max(material.restitution * impact.speed, material.kick) : 0;
    if (closing > 0) item.with("filled", "|v' - v| = " + brief(closing) + " + " + brief(out) + " m/s");
}

void SimpleTrace::responded(const Ball& lower, const Ball& upper, const Impact& impact,
                            const Mixed& material) {
    const double closing = -dot(lower_.velocity - upper_.velocity, unit(lower_.position - upper_.position));
    TraceItem& item = add_response(lower, impact, material, closing).with("other_ball", upper.number);
    add_change(item, "other_", upper_, upper)
        .with("formula", "J = (s + max(e s, k)) / (1/m1 + 1/m2), v1' = v1 + J n / m1, v2' = v2 - J n / m2");
    if (closing > 0)
        item.with("filled", "J = " + brief(impact.impulse) + " N·s at s = " + brief(impact.speed) + " m/s");
}

void SimpleTrace::end_round() {
    narrow().says =
        of_round_ + counted(turn_, "pair") + ", " + std::to_string(overlapping_) + " with an overlap.";
    stage().says = overlapping_ == 0
                       ? "Nothing overlaps: there is nothing to answer, and no further iteration."
                       : counted(overlapping_, "overlap") + " answered: " + counted(impacts_, "impact") +
                             ", " + counted(resting_, "resting contact") + "; all are pushed out.";
}

void SimpleTrace::begin_sensors() {
    begin("sensors", "watch_sensors");
    stage().says = "No ball is at a sensor.";
}

void SimpleTrace::sensed(const Ball& ball, PrimitiveIndex primitive, double separation) {
    name_proxy(stage().add("sensor").with("ball", ball.number), "", primitive)
        .with("separation", separation)
        .with("inside", separation <= 0);
    stage().says =
        "Balls looked at, for their boxes overlap that of a sensor: " + std::to_string(stage().items.size()) +
        ".";
}

}  // namespace flipside::custom
