#pragma once
/// Statements about figures: comparisons, joined by && and ||, as "one.y0 > 0 && abs(one.x0 - two.x0) <
/// 1e-9".

#include <map>
#include <set>
#include <stdexcept>
#include <string>

namespace flipside::lab {

/// By name: "NAME.pair_tests".
using Figures = std::map<std::string, double, std::less<>>;

/// Of which those names are made.
inline constexpr const char* figure_letters =
    "0123456789_.abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";

/// Says what is wrong with a statement.
class BadStatement : public std::runtime_error {
    using std::runtime_error::runtime_error;
};

struct Judgement {
    bool holds = false;
    std::set<std::string> figures;  ///< those in it
};

/// Every comparison in it must be of at least one figure, and its sides must be finite, or BadStatement is
/// thrown. Only a figure may be infinite: of that nothing holds.
[[nodiscard]] Judgement judge(const std::string& statement, const Figures& figures);

}  // namespace flipside::lab
