#pragma once
/// What must hold for every input of a fuzz target. A violation ends the program by abort(), so that
/// libFuzzer keeps the input.

#include <string>
#include <string_view>

#include "lab/process/failure.hpp"
#include "world/input_error.hpp"
#include "world/refusal.hpp"

namespace flipside::fuzz {

/// What is under test from now on (an engine), for the sentence of a violation.
void set_subject(const char* name);

/// Prints the sentence and aborts.
[[noreturn]] void report_violation(const std::string& what);

inline void require(bool holds, const char* what) {
    if (!holds) report_violation(what);
}

/// An error message goes to a terminal as one line: no control characters, and no empty ones.
void require_printable(const std::string& message);

/// Runs `act`. False if it threw one of the exceptions that the program turns into an exit code; their
/// messages must be printable. Any other exception ends the program.
[[nodiscard]] bool accepted(auto&& act) {
    try {
        act();
        return true;
    } catch (const InputError& error) {
        require_printable(error.what());
    } catch (const Refusal& error) {
        require_printable(error.what());
    } catch (const lab::Failure& error) {
        require_printable(error.what());
    }
    return false;
}

/// Aborts when it lives for more than `seconds` of CPU time, even in a loop without end. One at a time.
class CpuLimit {
  public:
    explicit CpuLimit(double seconds);
    ~CpuLimit();
    CpuLimit(const CpuLimit&) = delete;
    CpuLimit& operator=(const CpuLimit&) = delete;
};

/// Of one step, or of reading one file. Coverage and sanitizers make code about five times slower.
#ifdef FLIPSIDE_FUZZ_INSTRUMENTED
inline constexpr double longest_answer = 10;
#else
inline constexpr double longest_answer = 2;
#endif

/// A checksum of the input: what a target varies beside it (the broad phase, the precision) follows from
/// this.
[[nodiscard]] unsigned variation_of(std::string_view input);

}  // namespace flipside::fuzz
