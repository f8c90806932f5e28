#pragma once
/// A stream into a text.

#include <sstream>

namespace flipside::lab {

/// Where memory is short it throws; std::ostringstream drops what did not fit and says nothing.
class TextStream : public std::ostringstream {
  public:
    TextStream() { exceptions(std::ios::badbit); }
};

}  // namespace flipside::lab
