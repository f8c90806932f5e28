/// The tests, and the process of an engine where that is what they start.

#include <gtest/gtest.h>

#include "plugin/worker.hpp"

int main(int argc, char** argv) {
    if (flipside::plugin::is_engine_process(argc, argv)) flipside::plugin::run_engine_process(argv[2]);
    testing::InitGoogleTest(&argc, argv);
    return RUN_ALL_TESTS();
}
