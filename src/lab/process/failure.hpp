#pragma once
/// A request was valid but could not be done. what() is one line for stderr.
/// The program ends with exit code 1.

#include <stdexcept>

namespace flipside::lab {

class Failure : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

}  // namespace flipside::lab
