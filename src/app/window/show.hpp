#pragma once
/// What can be shown on top of the table, in the order of the panel and by the names of the command line.

#include <bitset>
#include <string_view>

namespace flipside::app {

enum class Show {
    hit_points,
    tracks,
    tangents,
    boxes,
    cells,
    pairs,
    contacts,
    velocity,
    sectors,
    lights,
    sleep,
    reticles
};

struct ShowSpec {
    std::string_view name;   ///< as on the command line
    std::string_view label;  ///< as in the panel
    std::string_view about;
};

inline constexpr ShowSpec show_specs[] = {
    {"hit-points", "Hit points", "A dot where a ball hit something; fades within half a second"},
    {"tracks", "Tracks", "Where each ball has been during the last second"},
    {"tangents", "Tangents", "Arrows at the ends of segments and arcs, along the way on"},
    {"boxes", "Boxes", "The bounding boxes (AABBs) that the engine tests first"},
    {"cells", "Cells", "The cells of the broad phase, with the number of things in each"},
    {"pairs", "Pairs", "What the broad phase found near enough to test exactly"},
    {"contacts", "Contacts", "Touching pairs now: point and normal"},
    {"velocity", "Velocity", "Where each ball will be in a tenth of a second if nothing stops it"},
    {"sectors", "Sectors", "Lines from an arc's centre to its ends"},
    {"lights", "Lights", "Parts are lit for a tenth of a second after a hit"},
    {"sleep", "Sleep", "Which balls the engine has put to sleep"},
    {"reticles", "Reticles",
     "A spinning mark at each hit: faster hits spin faster, hits between balls are squares"}};
inline constexpr std::size_t show_count = std::size(show_specs);

using Shows = std::bitset<show_count>;

[[nodiscard]] inline bool has(const Shows& shows, Show what) {
    return shows[static_cast<std::size_t>(what)];
}

}  // namespace flipside::app
