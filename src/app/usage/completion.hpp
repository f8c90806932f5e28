#pragma once
/// Scripts by which shells complete the command line. Names of scenes, engines, settings, lessons and cases
/// they ask the program for, so what is added to the assets is completed too.

#include <string>

#include "app/usage/description.hpp"

namespace flipside::app {

[[nodiscard]] std::string bash_completion(const ProgramDescription& program);

}  // namespace flipside::app
