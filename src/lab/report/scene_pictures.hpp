#pragma once
/// The scenes of a sweep as they look while its windows are taken.

#include <span>
#include <vector>

#include "lab/report/page.hpp"
#include "lab/sweep/variants.hpp"

namespace flipside::lab::report {

/// One per scene, with the balls of its first variant at the variant's first window, run on the first engine
/// there is.
[[nodiscard]] std::vector<Picture> scene_pictures(std::span<const sweep::Variant> variants);
/// An SVG element: parts in the pose of the scene file, and these balls.
[[nodiscard]] std::string scene_svg(const Scene& scene, std::span<const Ball> balls);

}  // namespace flipside::lab::report
