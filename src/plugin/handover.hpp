#pragma once
/// A scene as it is handed to a foreign engine: arrays of the interface's own structs, made here, sent to the
/// engine's process, and put together there.

#include <string>
#include <vector>

#include "flipside/engine.h"
#include "plugin/bytes.hpp"
#include "world/surface.hpp"
#include "world/table.hpp"

namespace flipside::plugin {

[[nodiscard]] flipside_vec as_c(Vec2 v);
[[nodiscard]] flipside_ball as_c(const Ball& ball);

/// How the moving parts move from now on, in their order.
void note_motions(const Table& table, std::vector<flipside_motion>& motions);

class Handover {
  public:
    Handover() = default;
    /// A scene and how it stands now. `primitives` is its surface.
    Handover(const Table& table, const std::vector<Primitive>& primitives, std::span<const Ball> balls);

    void write(Writer& out) const;
    void read(Reader& in);
    /// Valid as long as this is, and is not written to. `json` must live as long.
    [[nodiscard]] flipside_scene view(const std::string& json);

  private:
    void add(const Primitive& primitive);

    std::string name_;
    flipside_scene numbers_{};  ///< those that are no arrays
    std::vector<flipside_material> materials_;
    std::vector<flipside_ball> balls_;
    std::vector<flipside_part> parts_;  ///< without their names
    std::vector<std::string> part_names_;
    std::vector<flipside_primitive> primitives_;
    std::vector<flipside_vec> points_;
    std::vector<flipside_blocked> blocked_;
};

}  // namespace flipside::plugin
