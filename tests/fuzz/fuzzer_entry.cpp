/// The entry points that libFuzzer calls by their names.

#include <cstddef>
#include <cstdint>
#include <string>

#include "fuzz/mutator.hpp"
#include "fuzz/target.hpp"

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    flipside::fuzz::run_input({reinterpret_cast<const char*>(data), size});
    return 0;
}

namespace {

/// Copies `text` into libFuzzer's buffer; false where it does not fit.
bool put(const std::string& text, std::uint8_t* data, std::size_t max_size) {
    if (text.empty() || text.size() > max_size) return false;
    text.copy(reinterpret_cast<char*>(data), text.size());
    return true;
}

}  // namespace

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t max_size,
                                               unsigned seed) {
    flipside::fuzz::Mutator mutator(seed);
    const std::string text = mutator.mutate({reinterpret_cast<const char*>(data), size});
    // An empty answer: the bytes themselves are to be changed.
    return put(text, data, max_size) ? text.size() : LLVMFuzzerMutate(data, size, max_size);
}

extern "C" std::size_t LLVMFuzzerCustomCrossOver(const std::uint8_t* first, std::size_t first_size,
                                                 const std::uint8_t* second, std::size_t second_size,
                                                 std::uint8_t* out, std::size_t max_size, unsigned seed) {
    flipside::fuzz::Mutator mutator(seed);
    const std::string text = mutator.cross({reinterpret_cast<const char*>(first), first_size},
                                           {reinterpret_cast<const char*>(second), second_size});
    return put(text, out, max_size) ? text.size() : 0;
}
