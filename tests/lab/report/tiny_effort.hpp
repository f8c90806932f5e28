#pragma once
/// A report that takes seconds: everything is measured, of everything a little.

#include "lab/report/effort.hpp"

namespace flipside::lab::report {

inline Effort tiny_effort() {
    return {"tiny", 0.05, 100, 9, 0.2, 0.7, 10, 0.2, {10, 20}, 0.1, 5};
}

}  // namespace flipside::lab::report
