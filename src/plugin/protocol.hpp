#pragma once
/// What the two processes say to each other: a header, then so many bytes. The program asks, the engine's
/// process answers, one answer for each question; its first answer, the description, comes unasked.

#include <cstdint>

namespace flipside::plugin {

enum class Ask : std::uint32_t {
    make,  ///< a scene (handover.hpp), the settings, and what an earlier world saved
    step,  ///< controls, motions, time, dt
    save,  ///< controls
};

enum class Answer : std::uint32_t {
    done,
    refused,       ///< text: the engine says that it cannot
    broken,        ///< text: what the engine did against the contract
    not_followed,  ///< a control that the engine does not know; no step was made
};

struct Header {
    std::uint32_t kind = 0;  ///< Ask or Answer
    std::uint32_t magic = 0x464c4950;
    std::uint64_t size = 0;  ///< bytes that follow
};

/// No answer is longer: a million balls, their events and contacts take a tenth of it.
inline constexpr std::uint64_t longest_answer = std::uint64_t{2} << 30U;

/// The first argument of the program where it is to be an engine's process; the second one is the library.
inline constexpr const char* process_command = "engine-process";
/// The socket's number there.
inline constexpr int process_socket = 3;

}  // namespace flipside::plugin
