#pragma once
/// Debug drawing: the engine calls this interface, and its implementation draws. Engines know no screen.

#include <string_view>

#include "world/events.hpp"

namespace flipside {

enum class Topic {
    boxes,     ///< bounds of balls and parts
    cells,     ///< cells of the broad phase, with the number of proxies in each
    pairs,     ///< candidates that the broad phase found
    contacts,  ///< touching pairs: point, normal, depth
    sleep,     ///< sleeping balls
};
inline constexpr std::string_view topic_names[] = {"boxes", "cells", "pairs", "contacts", "sleep"};

class Inspector {
  public:
    virtual ~Inspector() = default;
    /// Whether this topic is shown; engines need not draw the others.
    [[nodiscard]] virtual bool wants(Topic topic) const = 0;
    virtual void box(Topic topic, const Box& box) = 0;
    virtual void cell(const Box& box, int count) = 0;
    virtual void pair(Vec2 a, Vec2 b) = 0;
    virtual void contact(const Contact& contact) = 0;
    virtual void segment(Topic topic, Vec2 a, Vec2 b) = 0;
    virtual void circle(Topic topic, Vec2 center, double radius) = 0;
    virtual void text(Topic topic, Vec2 at, std::string_view words) = 0;
};

}  // namespace flipside
