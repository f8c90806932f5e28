#pragma once
/// What of the contract of flipside/engine.h a library meets, marked as a teacher marks work: every item has
/// points, a hundred in all, and says in a sentence why it has got them.
///
/// As JSON (assets/conformance.schema.json):
///
///     {"format": "flipside-conformance/1", "file": "...", "engine": "spring", "library": "", "passed": true,
///      "points": 74, "of": 100,
///      "items": [{"name": "free fall", "asks": "...", "mandatory": true, "verdict": "pass", "points": 10,
///                 "of": 10, "says": "..."}]}

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace flipside::lab {

enum class Grade {
    pass,
    part,        ///< within the bound, but not as good as it can be
    fail,        ///< wrong, or mandatory and not there
    not_offered  ///< not declared, and so refused by name where it is needed: no points, no blame
};
[[nodiscard]] std::string_view name_of(Grade grade);

struct Mark {
    std::string name;
    std::string asks;  ///< one sentence
    bool mandatory = false;
    Grade grade = Grade::fail;
    int points = 0, of = 0;
    std::string says;  ///< one line, printable
};

struct Conformance {
    std::string file, engine, library;
    std::vector<Mark> marks;

    [[nodiscard]] int points() const;
    [[nodiscard]] int of() const;
    /// No item failed: all that is mandatory is there, and what is declared is right.
    [[nodiscard]] bool passed() const;
};

/// Loads the library and asks it everything. `watch` gets the share done. Throws InputError where there is no
/// such file.
[[nodiscard]] Conformance check_conformance(const std::filesystem::path& file,
                                            const std::function<void(double)>& watch = {});
[[nodiscard]] std::string to_json(const Conformance& conformance);

}  // namespace flipside::lab
