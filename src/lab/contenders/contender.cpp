#include "lab/contenders/contender.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "lab/contenders/engines.hpp"
#include "lab/contenders/recommended.hpp"
#include "lab/files/plain_name.hpp"
#include "world/input_error.hpp"
#include "world/number_text.hpp"

namespace flipside::lab {

namespace {

constexpr std::string_view contender_form = "NAME=ENGINE[,dt=1/240][,K=V]...";

std::pair<std::string, std::string> at_equals(const std::string& part, const std::string& whole) {
    const std::size_t equals = part.find('=');
    if (equals == std::string::npos || equals == 0)
        throw InputError("contender '" + whole + "': '" + part + "' is not of the form " +
                         std::string(contender_form));
    return {part.substr(0, equals), part.substr(equals + 1)};
}

ContenderRequest parse_contender(const std::string& text) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, ',');) parts.push_back(part);
    if (text.empty() || text.back() == ',')
        throw InputError("contender '" + text + "' is not of the form " + std::string(contender_form));
    const auto [name, engine] = at_equals(parts.front(), text);
    if (!is_plain_name(name))
        throw InputError("contender '" + text + "': '" + name + "' is no name; allowed are " +
                         std::string(plain_name_rule));
    ContenderRequest request{name, &engine_named(engine), {}, {}};
    try {
        Settings settings(request.engine->settings);
        std::set<std::string> given;
        for (std::size_t i = 1; i < parts.size(); ++i) {
            const auto [key, value] = at_equals(parts[i], text);
            if (!given.insert(key).second) throw InputError("'" + key + "' is given twice; allowed is once");
            if (key == "dt") {
                request.dt = parse_step(value);
                continue;
            }
            settings.set(key, value);
            request.set.emplace_back(key, value);
        }
    } catch (const InputError& error) {
        throw InputError("contender '" + name + "': " + error.what());
    }
    return request;
}

}  // namespace

ContenderRequest plain_contender(const Engine& engine) {
    return {std::string(engine.name), &engine, {}, {}};
}

std::vector<ContenderRequest> parse_contenders(std::span<const std::string> texts) {
    std::vector<ContenderRequest> requests;
    for (const std::string& text : texts) {
        requests.push_back(parse_contender(text));
        const std::string& name = requests.back().name;
        if (std::ranges::count(requests, name, &ContenderRequest::name) > 1)
            throw InputError("contender '" + name + "' is there twice; each needs a name of its own");
    }
    return requests;
}

Contender contender_for(const ContenderRequest& request, const Scene& scene, double dt,
                        std::span<const SettingChange> changes) {
    require_known_engines(scene);
    Settings settings = settings_for(*request.engine, scene, changes);
    for (const auto& [name, value] : request.set) settings.set(name, value);
    return {request.engine, std::move(settings), request.name, request.dt.value_or(dt)};
}

std::string text_of(const Contender& contender, const Scene& scene) {
    std::string text =
        contender.name + '=' + std::string(contender.engine->name) + ",dt=" + number_text(contender.dt);
    const Settings recommended = settings_for(*contender.engine, scene);
    for (const SettingSpec& spec : contender.settings.specs())
        if (contender.settings.text(spec.name) != recommended.text(spec.name))
            text += ',' + std::string(spec.name) + '=' + contender.settings.text(spec.name);
    return text;
}

std::string free_name(const std::string& name, std::span<const ContenderRequest> taken) {
    std::string free = name;
    for (int i = 2; std::ranges::count(taken, free, &ContenderRequest::name) > 0; ++i)
        free = name + "-" + std::to_string(i);
    return free;
}

double common_step(std::span<const Contender> contenders) {
    const double longest = std::ranges::max_element(contenders, {}, &Contender::dt)->dt;
    for (const Contender& contender : contenders) {
        const double ratio = longest / contender.dt;
        if (std::abs(ratio - std::round(ratio)) > 1e-9 * ratio)
            throw InputError("contender '" + contender.name + "': its step of " +
                             std::to_string(contender.dt) + " s does not divide the longest one, " +
                             std::to_string(longest) + " s, so that they would not meet");
    }
    return longest;
}

}  // namespace flipside::lab
