#include "lab/contenders/recommended.hpp"

#include <algorithm>

#include "lab/contenders/engines.hpp"
#include "world/input_error.hpp"
#include "world/json_file.hpp"

namespace flipside::lab {

void require_known_engines(const Scene& scene) {
    std::vector<std::string_view> allowed{"run"};
    for (const Engine* engine : engines()) allowed.push_back(engine->name);
    for (const auto& [name, settings] : scene.recommend)
        if (std::ranges::find(allowed, name) == allowed.end())
            throw InputError(scene.place + "/recommend/" + pointer_token(name) + ": " + in_quotes(name) +
                             " is no engine; allowed: " +
                             names_of(allowed, [](std::string_view one) { return std::string(one); }));
}

}  // namespace flipside::lab
