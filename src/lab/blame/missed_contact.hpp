#pragma once
/// Why a contact that was due was not made: what the engine's states, and a repetition of its step with a
/// trace, give evidence of.

#include "lab/blame/blame.hpp"
#include "world/world.hpp"

namespace flipside::lab {

struct MissedContact {
    const Scene& scene;
    const Event& due;             ///< the impact that should have been
    const State &before, &after;  ///< the engine's, around it
};

/// let_through: it is a gate that the engine holds open. tunnelled: before the step the ball does not touch
/// what it should have met, and after it neither, or it recedes from it already; so only a continuous test
/// could have found it in time. Otherwise the ball lies in it and comes closer: unpaired where the broad
/// phase of that step, made again from the state before by `own`, does not list the pair, else missed.
/// Engines whose trace has no list of pairs, and a null `own`, are taken to have offered it.
[[nodiscard]] Fault why_missed(const MissedContact& contact, World* own);

}  // namespace flipside::lab
