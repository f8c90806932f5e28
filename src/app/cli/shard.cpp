#include "app/cli/shard.hpp"

#include <sstream>

#include "world/input_error.hpp"

namespace flipside::app {

lab::sweep::Shard parse_shard(const std::string& text) {
    lab::sweep::Shard shard;
    char slash = 0, rest = 0;
    std::istringstream in(text);
    const bool read = in >> shard.index >> slash >> shard.count && slash == '/' && !(in >> rest);
    if (!read || text.find('-') != std::string::npos || shard.index < 1 || shard.index > shard.count ||
        shard.count > 1'000'000)
        throw InputError("--shard '" + text + "' is not allowed; it takes K/N, the K-th of N parts, as 2/4");
    return shard;
}

}  // namespace flipside::app
