#pragma once
/// Runs the claims of a lesson and reports whether they are true.

#include <string>
#include <vector>

#include "lab/lessons/lesson.hpp"
#include "lab/lessons/statement.hpp"

namespace flipside::lab {

struct Verified {
    std::string statement;  ///< one of Claim::holds
    bool holds = false;
    std::vector<std::string> measured;  ///< each figure in it: "one.y0 = -1 m"
};

/// Makes the runs; exact engines that refuse throw Refusal.
[[nodiscard]] Figures measure(const Claim& claim);
/// One for each of what must hold. Throws InputError for what is no statement about the figures; `file` is
/// named then.
[[nodiscard]] std::vector<Verified> verify(const Claim& claim, const Figures& figures,
                                           const std::string& file);

}  // namespace flipside::lab
