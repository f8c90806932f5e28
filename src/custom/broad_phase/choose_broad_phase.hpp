#pragma once
/// The broad phase that the settings name, or for "auto" the one that suits the scene.

#include <string_view>

#include "custom/broad_phase/broad_phase.hpp"
#include "world/scene.hpp"
#include "world/settings.hpp"

namespace flipside::custom {

[[nodiscard]] std::unique_ptr<BroadPhase> make_broad_phase(const Scene& scene, std::vector<Proxy> still,
                                                           const Settings& settings);

/// What "auto" stands for, as the setting would name it.
[[nodiscard]] std::string_view choose_broad_phase(const Scene& scene, std::size_t still_pieces);

}  // namespace flipside::custom
