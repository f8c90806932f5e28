#include "lab/process/allocations.hpp"

#include <atomic>
#include <cstdlib>
#include <new>

/// The program-wide operator new (C++20 [new.delete]), replaced by one that counts. The standard library's
/// array forms call these. So does its nothrow form, but not the address sanitizer's, which would hand out
/// memory of its own to be deleted here.

namespace {

std::atomic<std::uint64_t> count{0};

void* counted(void* memory) {
    count.fetch_add(1, std::memory_order_relaxed);
    if (memory != nullptr) return memory;
    if (const auto handler = std::get_new_handler(); handler != nullptr) handler();
    throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) {
    return counted(std::malloc(size == 0 ? 1 : size));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    const auto align = static_cast<std::size_t>(alignment);
    return counted(std::aligned_alloc(align, (size + align - 1) / align * align));
}
/// Ends the program where there is no memory (at the latest std::terminate does): valijson asks in this way,
/// and writes through what it gets without looking.
// NOLINTNEXTLINE(bugprone-exception-escape)
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return ::operator new(size);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}

namespace flipside::lab {

std::uint64_t allocations() {
    return count.load(std::memory_order_relaxed);
}

}  // namespace flipside::lab
