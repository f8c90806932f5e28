#pragma once
/// Where the source and the built programs and libraries are. They are defined in a unit of their own in
/// every test program (flipside_places() in cmake/flipside.cmake), so that all other units compile to the
/// same in every checkout; what a test program does not give is missing when it is linked.

#include <string>

namespace flipside::test {

extern const char* const source_dir;

/// A file of the source: source("assets/scenes/drop.json").
inline std::string source(const std::string& path) {
    return source_dir + ("/" + path);
}

// Programs.
extern const char *const flipside_program, *const certificate_checker, *const tiny_report;
// Libraries to preload.
extern const char *const fault_library, *const fake_gamepad_library;
// Foreign engines.
extern const char *const engine_in_c, *const chipmunk_engine;
extern const char *const naughty_engine, *const keeper_engine, *const not_an_engine, *const later_engine,
                                                                                         *const mute_engine;

}  // namespace flipside::test
