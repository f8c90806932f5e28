#include "plugin/library.hpp"

#include <algorithm>
#include <cstring>
#include <ctime>
#include <stdexcept>
#include <utility>

#include <dlfcn.h>
#include <unistd.h>

namespace flipside::plugin {

namespace {

/// Of events and contacts. A pair of balls rarely has more than a few.
constexpr std::size_t most_listed = 20'000'000;
constexpr std::size_t most_saved = std::size_t{1} << 30U;

double process_seconds() {
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Least CPU time between two readings in a row, s.
double cost_of_two_readings() {
    static const double least = [] {
        double shortest = 1;
        for (int i = 0; i < 1000; ++i) {
            const double began = process_seconds();
            shortest = std::min(shortest, process_seconds() - began);
        }
        return shortest;
    }();
    return least;
}

/// An engine that forks comes back from its call twice. The copy has no business here.
void end_copies() {
    static const pid_t original = getpid();
    if (getpid() != original) _exit(0);
}

template <class Call>
auto guarded(const char* function, Call&& call) {
    end_copies();
    try {
        const auto result = call();
        end_copies();
        return result;
    } catch (...) {
        throw ForeignWorld::Broken{std::string("lets an exception out of ") + function};
    }
}

}  // namespace

const flipside_engine& load_library(const char* path) {
    void* const library = dlopen(path, RTLD_NOW | RTLD_LOCAL);
    if (!library) throw std::invalid_argument(std::string("cannot be loaded: ") + dlerror());
    void* const symbol = dlsym(library, FLIPSIDE_ENTRY);
    if (!symbol) throw std::invalid_argument("does not export " FLIPSIDE_ENTRY ", so it is no engine");
    using Entry = const flipside_engine*();
    const flipside_engine* const found = reinterpret_cast<Entry*>(symbol)();
    if (!found) throw std::invalid_argument(FLIPSIDE_ENTRY "() returns null");
    if (found->version != FLIPSIDE_ENGINE_VERSION)
        throw std::invalid_argument("is of version " + std::to_string(found->version) +
                                    " of the interface; allowed is " +
                                    std::to_string(FLIPSIDE_ENGINE_VERSION));
    if (found->size < offsetof(flipside_engine, destroy))
        throw std::invalid_argument("says that its flipside_engine has " + std::to_string(found->size) +
                                    " bytes; allowed are at least " +
                                    std::to_string(offsetof(flipside_engine, destroy)));
    // What a later version adds is unknown here, and what an earlier one had not is null.
    static flipside_engine engine;
    std::memcpy(&engine, found, std::min<std::size_t>(found->size, sizeof engine));
    if (!engine.make || !engine.step || !engine.balls)
        throw std::invalid_argument("has no make, step or balls, which are mandatory");
    return engine;
}

ForeignWorld::ForeignWorld(const flipside_engine& engine, const flipside_scene& scene, const double* settings)
    : engine_(engine) {
    std::fill_n(why_.data(), why_.size(), '\0');
    world_ = guarded("make", [&] { return engine_.make(&scene, settings, why_.data()); });
    if (!world_) throw Refused{reason()};
}

ForeignWorld::~ForeignWorld() {
    if (engine_.destroy) engine_.destroy(world_);
    end_copies();
}

std::string ForeignWorld::reason() {
    const std::string text(why_.data(), strnlen(why_.data(), why_.size()));
    return text.empty() ? "it does not say why" : text;
}

template <class Call>
auto ForeignWorld::timed(Call&& call) {
    const double cost = cost_of_two_readings();
    const double began = process_seconds();
    const auto result = call();
    cpu_seconds_ += std::max(0.0, process_seconds() - began - cost);
    return result;
}

double ForeignWorld::take_cpu_seconds() {
    return std::exchange(cpu_seconds_, 0);
}

void ForeignWorld::step(const flipside_step& step) {
    std::fill_n(why_.data(), why_.size(), '\0');
    if (timed([&] { return guarded("step", [&] { return engine_.step(world_, &step, why_.data()); }); }) != 0)
        throw Refused{reason()};
}

std::span<const flipside_ball_state> ForeignWorld::balls(std::size_t expected) {
    balls_.resize(expected);
    const std::uint32_t count = timed([&] {
        return guarded("balls", [&] {
            return engine_.balls(world_, balls_.data(), static_cast<std::uint32_t>(expected));
        });
    });
    if (count != expected)
        throw Broken{"says that there are " + std::to_string(count) + " balls; there are " +
                     std::to_string(expected)};
    return {balls_.data(), expected};
}

template <class T>
std::span<const T> ForeignWorld::all(std::uint32_t (*get)(flipside_world*, T*, std::uint32_t),
                                     GuardedArray<T>& list, const char* what) {
    if (!get) return {};
    for (std::size_t capacity = std::max<std::size_t>(list.size(), 64);;) {
        list.resize(capacity);
        const std::uint32_t count = timed([&] {
            return guarded(what,
                           [&] { return get(world_, list.data(), static_cast<std::uint32_t>(capacity)); });
        });
        if (count <= capacity) return {list.data(), count};
        if (count > most_listed)
            throw Broken{"says that there are " + std::to_string(count) + " " + what + "; the most are " +
                         std::to_string(most_listed)};
        capacity = count;
    }
}

std::span<const flipside_event> ForeignWorld::events() {
    return all(engine_.events, events_, "events");
}

std::span<const flipside_contact> ForeignWorld::contacts() {
    return all(engine_.contacts, contacts_, "contacts");
}

bool ForeignWorld::control(const flipside_control& control) {
    return engine_.control && guarded("control", [&] { return engine_.control(world_, &control); }) == 0;
}

std::span<const std::byte> ForeignWorld::save() {
    for (std::size_t capacity = saved_.size();;) {
        saved_.resize(capacity);
        const std::uint64_t size =
            guarded("save", [&] { return engine_.save(world_, saved_.data(), capacity); });
        if (size <= capacity) return {saved_.data(), static_cast<std::size_t>(size)};
        if (size > most_saved)
            throw Broken{"wants to save " + std::to_string(size) + " bytes; the most are " +
                         std::to_string(most_saved)};
        capacity = static_cast<std::size_t>(size);
    }
}

void ForeignWorld::restore(std::span<const std::byte> bytes) {
    if (guarded("restore", [&] { return engine_.restore(world_, bytes.data(), bytes.size()); }) != 0)
        throw Broken{"does not take back what it has saved"};
}

}  // namespace flipside::plugin
