#pragma once
/// A library that implements flipside/engine.h, loaded into this process.

#include <cstddef>
#include <span>
#include <string>

#include "flipside/engine.h"
#include "plugin/guarded_array.hpp"

namespace flipside::plugin {

/// The engine of a library. Throws std::invalid_argument that says why there is none.
[[nodiscard]] const flipside_engine& load_library(const char* path);

/// A world of a foreign engine, called as the interface has it. What it does wrong is thrown as Broken, what
/// it refuses as Refused.
class ForeignWorld {
  public:
    struct Refused {
        std::string why;
    };
    struct Broken {
        std::string what;
    };

    ForeignWorld(const flipside_engine& engine, const flipside_scene& scene, const double* settings);
    ForeignWorld(const ForeignWorld&) = delete;
    ForeignWorld(ForeignWorld&&) = delete;
    ForeignWorld& operator=(const ForeignWorld&) = delete;
    ForeignWorld& operator=(ForeignWorld&&) = delete;
    ~ForeignWorld();

    void step(const flipside_step& step);
    /// The number that there must be.
    [[nodiscard]] std::span<const flipside_ball_state> balls(std::size_t expected);
    /// Empty where the engine does not say.
    [[nodiscard]] std::span<const flipside_event> events();
    [[nodiscard]] std::span<const flipside_contact> contacts();
    /// False where the engine does not follow.
    [[nodiscard]] bool control(const flipside_control& control);
    [[nodiscard]] std::span<const std::byte> save();
    void restore(std::span<const std::byte> bytes);

    /// CPU time of the whole process in the functions that make a step, since the last call of this, s.
    [[nodiscard]] double take_cpu_seconds();

  private:
    template <class Call>
    auto timed(Call&& call);
    template <class T>
    std::span<const T> all(std::uint32_t (*get)(flipside_world*, T*, std::uint32_t), GuardedArray<T>& list,
                           const char* what);
    [[nodiscard]] std::string reason();

    const flipside_engine& engine_;
    GuardedArray<char> why_{FLIPSIDE_WHY};
    GuardedArray<flipside_ball_state> balls_;
    GuardedArray<flipside_event> events_;
    GuardedArray<flipside_contact> contacts_;
    GuardedArray<std::byte> saved_;
    flipside_world* world_ = nullptr;
    double cpu_seconds_ = 0;
};

}  // namespace flipside::plugin
