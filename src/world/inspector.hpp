#pragma once
/// Debug drawing: the engine calls this interface, and its implementation draws what it is interested in.
/// Engines know no screen.

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
    virtual void box(Topic, const Box&) {}
    virtual void cell(const Box&, int /*count*/) {}
    /// A line between the two.
    virtual void pair(Vec2, Vec2) {}
    virtual void contact(const Contact&) {}
    virtual void segment(Topic, Vec2 /*a*/, Vec2 /*b*/) {}
    virtual void circle(Topic, Vec2 /*center*/, double /*radius*/) {}
    virtual void text(Topic, Vec2 /*at*/, std::string_view) {}
};

}  // namespace flipside
