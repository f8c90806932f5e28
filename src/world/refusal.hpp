#pragma once
/// Thrown by an engine that cannot compute a step exactly. what() is one line: the engine, the ball, part and
/// time, and the reason. The program ends with exit code 1.

#include <stdexcept>

namespace flipside {

/// Thrown by World::step, and by Engine::make where the engine's own process ends. The world is then as it
/// was before that step: it can be read and saved, so another engine can go on from there; another step of
/// the same world is refused again.
class Refusal : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// A search has passed its bound of steps, which is far above what any path of a real table needs. Whoever
/// knows ball and part throws a Refusal that names them in its place (refuse_search in limits.hpp).
class EndlessSearch : public Refusal {
  public:
    EndlessSearch() : Refusal("a search has passed its bound of steps") {}
};

}  // namespace flipside
