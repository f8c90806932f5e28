#include "lab/process/build_commit.hpp"

#include "build_facts.hpp"

namespace flipside::lab {

std::string build_commit() {
    return report::facts::commit;
}

}  // namespace flipside::lab
