#pragma once
/// A fuzz target is a program that runs one input. Built with libFuzzer it searches for inputs that break
/// what oracle.hpp requires; built as a test (replay.cpp) it runs the inputs of tests/fuzz/corpus and
/// tests/fuzz/regressions.

#include <string_view>

namespace flipside::fuzz {

/// Each target defines it. Returns when all is well with this input, valid or not.
void run_input(std::string_view input);

}  // namespace flipside::fuzz
