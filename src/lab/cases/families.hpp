#pragma once
/// The experiments behind the cases, one file per family.

#include "lab/cases/experiment.hpp"

namespace flipside::lab {

// bounces.cpp
void zeno_drop(Experiment& experiment);
void elastic_drop(Experiment& experiment);

// chains.cpp
void galperin(Experiment& experiment);

}  // namespace flipside::lab
