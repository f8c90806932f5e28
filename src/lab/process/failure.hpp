#pragma once
/// What was asked for could not be done, though the question was right. what() is one line for stderr.
/// The program ends with exit code 1.

#include <stdexcept>

namespace flipside::lab {

class Failure : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace flipside::lab
