#pragma once
/// Memory that a foreign engine writes to: it ends where a page begins that nobody may touch, so who writes
/// beyond its end is stopped at that very write.

#include <algorithm>
#include <cstddef>
#include <new>
#include <type_traits>

#include <sys/mman.h>
#include <unistd.h>

namespace flipside::plugin {

template <class T>
requires std::is_trivially_copyable_v<T>
class GuardedArray {
  public:
    explicit GuardedArray(std::size_t count = 0) { resize(count); }
    GuardedArray(const GuardedArray&) = delete;
    GuardedArray(GuardedArray&&) = delete;
    GuardedArray& operator=(const GuardedArray&) = delete;
    GuardedArray& operator=(GuardedArray&&) = delete;
    ~GuardedArray() { release(); }

    /// All zero where it grows; what was there is lost then.
    void resize(std::size_t count) {
        const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
        const std::size_t needed = (count * sizeof(T) + page - 1) / page * page + page;
        if (needed > mapped_) {
            release();
            void* const memory =
                mmap(nullptr, needed, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
            if (memory == MAP_FAILED) throw std::bad_alloc();
            memory_ = static_cast<std::byte*>(memory);
            mapped_ = needed;
            mprotect(memory_ + mapped_ - page, page, PROT_NONE);
        }
        count_ = count;
        data_ = reinterpret_cast<T*>(memory_ + mapped_ - page) - count;
    }
    [[nodiscard]] T* data() { return data_; }
    [[nodiscard]] std::size_t size() const { return count_; }

  private:
    void release() {
        if (memory_) munmap(memory_, mapped_);
        memory_ = nullptr;
        mapped_ = 0;
    }

    std::byte* memory_ = nullptr;
    std::size_t mapped_ = 0, count_ = 0;
    T* data_ = nullptr;
};

}  // namespace flipside::plugin
