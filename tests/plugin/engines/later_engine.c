/* An engine for a version of the interface that there is not yet. */

#include "flipside/engine.h"

const flipside_engine* flipside_engine_entry(void) {
    static const flipside_engine engine = {.size = sizeof engine, .version = FLIPSIDE_ENGINE_VERSION + 1};
    return &engine;
}
