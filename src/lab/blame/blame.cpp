#include "lab/blame/blame.hpp"

#include <numbers>

#include "lab/files/csv.hpp"
#include "world/printable.hpp"
#include "world/trace.hpp"

namespace flipside::lab {

std::string_view stage_of(Fault fault) {
    switch (fault) {
        case Fault::drift:
            return "integration";
        case Fault::unpaired:
            return "broad phase";
        case Fault::missed:
        case Fault::invented:
        case Fault::normal:
            return "narrow phase";
        case Fault::tunnelled:
            return "continuous collision";
        case Fault::let_through:
            return "gate";
        case Fault::late:
        case Fault::early:
            return "time of impact";
        case Fault::impulse:
        case Fault::friction:
            return "response";
        case Fault::resting:
            return "resting contact";
        case Fault::motion:
            return "motion of parts";
        case Fault::stopped:
            return "none";
        case Fault::unknown:
            break;
    }
    return "unknown";
}

std::string in_words(Fault fault, double amount) {
    const auto with = [&](const char* before, double number, const char* unit) {
        return before + brief(number) + unit;
    };
    switch (fault) {
        case Fault::drift:
            return with("drift in flight of ", amount, " m");
        case Fault::missed:
            return with("contact missed at ", amount, " m/s");
        case Fault::unpaired:
            return with("contact missed, its pair not found, at ", amount, " m/s");
        case Fault::tunnelled:
            return with("tunnelled at ", amount, " m/s");
        case Fault::let_through:
            return with("let through at ", amount, " m/s");
        case Fault::invented:
            return with("contact invented at ", amount, " m/s");
        case Fault::late:
            return with("contact late by ", amount, " s");
        case Fault::early:
            return with("contact early by ", amount, " s");
        case Fault::normal:
            return with("normal off by ", amount * 180 / std::numbers::pi, " degrees");
        case Fault::impulse:
            return with("impulse off by ", amount, " m/s");
        case Fault::friction:
            return with("friction off by ", amount, " m/s");
        case Fault::resting:
            return with("resting contact off by ", amount, " m");
        case Fault::motion:
            return with("part mistimed by ", amount, " rad");
        case Fault::stopped:
            return "the run stopped";
        case Fault::unknown:
            break;
    }
    return "unknown";
}

std::string in_words(const Blame& blame, const Scene& scene) {
    std::string words = in_words(blame.fault, blame.amount);
    if (blame.other) {
        Event met;
        met.other = *blame.other;
        words += " at " + blame.kind;
        words += blame.other->is_ball ? " " + std::to_string(blame.other->index)
                                      : " '" + printable(name_of_other(met, scene)) + "'";
    }
    words += ", ball " + std::to_string(blame.ball) + ", " + brief(blame.time) + " s";
    return words + " (" + std::string(stage_of(blame.fault)) + ")";
}

}  // namespace flipside::lab
