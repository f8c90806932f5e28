#pragma once
/// The other side of process.hpp: what this program is where it runs a foreign engine.

namespace flipside::plugin {

/// Whether the program was started to be an engine's process.
[[nodiscard]] bool is_engine_process(int argc, char** argv);
/// Loads the library and answers requests until the other end is closed. Never returns.
[[noreturn]] void run_engine_process(const char* library);

}  // namespace flipside::plugin
