#pragma once
/// What the user gave is wrong. what() is one printable line for stderr: where, what is wrong, what is
/// allowed. The program ends with exit code 2.

#include <stdexcept>
#include <string>

#include "world/printable.hpp"

namespace flipside {

class InputError : public std::runtime_error {
  public:
    explicit InputError(const std::string& problem) : std::runtime_error(printable(problem)) {}
    /// "FILE: /json/pointer: problem"; an empty pointer names the whole file.
    InputError(const std::string& file, const std::string& pointer, const std::string& problem)
        : InputError(file + ": " + (pointer.empty() ? "" : pointer + ": ") + problem) {}
};

}  // namespace flipside
