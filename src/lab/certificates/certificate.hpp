#pragma once
/// Certificates: a run of the exact engine, written down so that a program which shares no code with it can
/// check every path, every impact, and that nothing came earlier (assets/certificate.schema.json,
/// tools/certify_check).

#include <string>

#include "lab/session/session.hpp"
#include "lab/session/timeline.hpp"

namespace flipside::lab {

struct Certified {
    std::string json;
    double seconds = 0;  ///< how much of what was asked for is in it
    std::string ends;    ///< why it ends earlier; "" where it does not
};

/// Runs a session of the reference engine along the timeline. It ends before the first step that the engine
/// refuses, and before the first of which its twin, if it has one, leaves nothing to claim. Throws Refusal
/// where that is the first step of all.
[[nodiscard]] Certified certify(Session& session, const Timeline& timeline, const Script& script);

}  // namespace flipside::lab
