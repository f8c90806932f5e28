/// What the mouse does in the edit mode.

#include <algorithm>
#include <cmath>

#include "app/window/editor/editor.hpp"

namespace flipside::app {

namespace {

constexpr double click_pixels = 5;  ///< a click may move by so much
constexpr double double_click_seconds = 0.4;
constexpr double close_pixels = 9;  ///< to the first corner of an outline

Vec2 metres_at(Vec2 pixel, const Pointing& pointing) {
    return pointing.camera.to_metres(pixel - Vec2{pointing.pane.x, pointing.pane.y});
}

bool is_left_button(const sf::Event& event) {
    return event.mouseButton.button == sf::Mouse::Left;
}

}  // namespace

bool Editor::process(const sf::Event& event, const Pointing& pointing) {
    switch (event.type) {
        case sf::Event::MouseButtonPressed: {
            const Vec2 at{double(event.mouseButton.x), double(event.mouseButton.y)};
            if (!pointing.pane.contains(at.x, at.y)) return false;
            if (is_left_button(event)) return press(at, pointing);
            if (draws()) finish_pen();
            return true;
        }
        case sf::Event::MouseMoved:
            mouse_pixel_ = {double(event.mouseMove.x), double(event.mouseMove.y)};
            move(mouse_pixel_, pointing);
            return drag_.has_value();
        case sf::Event::MouseButtonReleased:
            if (is_left_button(event))
                release({double(event.mouseButton.x), double(event.mouseButton.y)}, pointing);
            return false;
        case sf::Event::MouseLeft:
            in_pane_ = false;
            return false;
        case sf::Event::LostFocus:
            if (drag_) draft_->end_step();
            drag_.reset();
            pressed_ = false;
            return false;
        case sf::Event::KeyPressed:
            return press_key(event.key, pointing);
        default:
            return false;
    }
}

bool Editor::press(Vec2 pixel, const Pointing& pointing) {
    const bool twice = pointing.now - pressed_at_ < double_click_seconds &&
                       length(pixel - pressed_pixel_) < pointing.scale * click_pixels;
    mouse_pixel_ = pressed_pixel_ = pixel;
    pressed_at_ = pointing.now;
    pressed_ = true;
    ground_ = false;
    draft_->end_step();
    if (draws()) {
        if (twice && tool().points == 0)
            finish_pen();
        else
            put_point(pixel, pointing);
        return true;
    }
    const Vec2 at = metres_at(pixel, pointing), in_pane = pixel - Vec2{pointing.pane.x, pointing.pane.y};
    if (const auto handle = handle_at(in_pane, pointing.camera, pointing.scale)) {
        begin_drag(EditDrag::What::pull, pixel, pointing);
        drag_->handle = *handle;
        return true;
    }
    const auto turn = turn_handle(pointing.camera, pointing.scale);
    if (turn && length(turn->at - in_pane) < pointing.scale * close_pixels) {
        begin_drag(EditDrag::What::turn, pixel, pointing);
        return true;
    }
    if (const auto item = item_at(at, pointing.scale * click_pixels / pointing.camera.scale)) {
        if (pointing.adding) {
            select_one_more_or_less(*item);
            return true;
        }
        if (std::erase(selection_, *item) == 0) selection_.clear();
        selection_.push_back(*item);
        begin_drag(EditDrag::What::move, pixel, pointing);
        return true;
    }
    ground_ = true;
    return false;
}

void Editor::begin_drag(EditDrag::What what, Vec2 pixel, const Pointing& pointing) {
    drag_.emplace(what, *draft_->find(selected()));
    drag_->from = metres_at(pixel, pointing);
    drag_->pixel = pixel;
    std::vector<lab::Item> own = selection_;
    if (own.empty()) own.push_back(selected());
    drag_->ends = ends_but_of(own);
}

void Editor::move(Vec2 pixel, const Pointing& pointing) {
    in_pane_ = pointing.pane.contains(pixel.x, pixel.y);
    aim(pixel, pointing);
    if (!drag_) return;
    drag_->moved = drag_->moved || length(pixel - drag_->pixel) > pointing.scale * click_pixels;
    if (drag_->moved) drag_to(metres_at(pixel, pointing), pointing);
}

/// Where the next point of what is drawn would be.
void Editor::aim(Vec2 pixel, const Pointing& pointing) {
    const Vec2 at = metres_at(pixel, pointing);
    if (!draws()) {
        target_ = {at, lab::SnappedTo::nothing};
        return;
    }
    std::vector<Vec2> ends = ends_but_of({});
    if (pen_.size() > 2) ends.push_back(pen_.front());
    target_ = lab::snap(at, ends, pen_.empty() ? std::nullopt : std::optional(pen_.back()), rules(pointing));
}

void Editor::put_point(Vec2 pixel, const Pointing& pointing) {
    aim(pixel, pointing);
    const bool outline = tool().points == 0;
    if (outline && pen_.size() > 2 && target_.at == pen_.front()) {
        pen_.push_back(pen_.front());
        return finish_pen();
    }
    if (!pen_.empty() && pen_.back() == target_.at) return;
    pen_.push_back(target_.at);
    if (static_cast<int>(pen_.size()) == tool().points) finish_pen();
}

/// Makes a part of the points so far; of too few, nothing.
void Editor::finish_pen() {
    std::vector<Vec2> points = std::move(pen_);
    pen_.clear();
    const bool outline = tool().points == 0;
    const bool closed = outline && points.size() > 3 && points.front() == points.back();
    if (closed) points.pop_back();
    const std::size_t least = tool().name == "Polygon" ? 3
                              : outline                ? 2
                                                       : static_cast<std::size_t>(tool().points);
    if (points.size() < least) return;
    draft_->end_step();
    select(draft_->add(tool(), points));
    if (closed && tool().name == "Walls") {
        lab::Path path = path_of(selected());
        path.insert(path.end(), {"shape", "closed"});
        draft_->set(path, true);
    }
    draft_->end_step();
}

void Editor::release(Vec2 pixel, const Pointing& pointing) {
    const bool was_pressed = std::exchange(pressed_, false);
    const bool moved = length(pixel - pressed_pixel_) > pointing.scale * click_pixels;
    if (draws() && was_pressed && !pen_.empty() && moved) put_point(pixel, pointing);
    if (drag_) draft_->end_step();
    // A click on one of several picks that one; only a drag moves them all.
    if (drag_ && !drag_->moved) select(selected());
    drag_.reset();
    if (ground_ && was_pressed && !moved && !pointing.adding) selection_.clear();
}

void Editor::drag_to(Vec2 at, const Pointing& pointing) {
    const lab::SnapRules snapping = rules(pointing);
    lab::OrderedJson thing;
    switch (drag_->what) {
        case EditDrag::What::pull:
            thing = pulled_to(at, snapping);
            break;
        case EditDrag::What::turn:
            thing = turned_to(at, snapping.on);
            break;
        default: {
            std::vector<Vec2> own = lab::joints_of(drag_->before);
            if (own.empty()) own.push_back(lab::middle_of(drag_->before));
            draft_->revert_step();
            return draft_->move(selection_, lab::snap_move(at - drag_->from, own, drag_->ends, snapping));
        }
    }
    draft_->revert_step();
    draft_->replace(selected(), thing);
}

lab::OrderedJson Editor::turned_to(Vec2 at, bool snapping) const {
    const Vec2 about = lab::middle_of(drag_->before);
    double angle = angle_of(at - about) - angle_of(drag_->from - about);
    if (snapping) {
        // The direction that it shows comes to such an angle, or else what it is turned by does.
        const double shown = lab::direction_of(drag_->before).value_or(0);
        angle = lab::snap_angle(shown + angle) - shown;
    }
    return lab::turned(drag_->before, about, angle);
}

lab::OrderedJson Editor::pulled_to(Vec2 at, const lab::SnapRules& rules) {
    const lab::Handle& handle = drag_->handle;
    const Vec2 anchor = handle.anchor.value_or(Vec2{});
    switch (handle.role) {
        case lab::Role::radius: {
            // By half a pitch, so that diameters come in whole ones.
            const double half = 0.5 * rules.pitch, far = length(at - anchor);
            const double radius = rules.on ? std::max(half, half * std::round(far / half)) : far;
            return lab::pulled(drag_->before, handle, anchor + radius * unit(at - anchor, {1, 0}));
        }
        case lab::Role::raised:
        case lab::Role::direction:
            if (rules.on)
                at = anchor + length(at - anchor) * from_angle(lab::snap_angle(angle_of(at - anchor)));
            return lab::pulled(drag_->before, handle, at);
        case lab::Role::velocity: {
            if (!rules.on) return lab::pulled(drag_->before, handle, at);
            const double begin = lab::arrow_begin(drag_->before);
            const double far = rules.pitch * std::round((length(at - anchor) - begin) / rules.pitch);
            const Vec2 way = from_angle(lab::snap_angle(angle_of(at - anchor)));
            return lab::pulled(drag_->before, handle, anchor + (begin + far) * way);
        }
        case lab::Role::arc_bulge: {
            lab::OrderedJson arc = lab::pulled(drag_->before, handle, at);
            if (!rules.on) return arc;
            return lab::with_whole_sweep(arc, handle, lab::snap_degrees);
        }
        default:
            target_ = lab::snap(at, drag_->ends, handle.anchor, rules);
            return lab::pulled(drag_->before, handle, target_.at);
    }
}

}  // namespace flipside::app
