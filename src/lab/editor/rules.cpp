#include "lab/editor/rules.hpp"

namespace flipside::lab {

namespace {

/// Of an object with a value for each part.
OrderedJson with_key(const OrderedJson& by_part, const std::string& before, const std::string& after) {
    OrderedJson result = OrderedJson::object();
    for (const auto& one : by_part.items())
        if (one.key() != before)
            result[one.key()] = one.value();
        else if (!after.empty())
            result[after] = one.value();
    return result;
}

/// Of a list of parts.
OrderedJson with_part(const OrderedJson& parts, const std::string& before, const std::string& after) {
    OrderedJson result = OrderedJson::array();
    for (const OrderedJson& part : parts)
        if (part != before)
            result.push_back(part);
        else if (!after.empty())
            result.push_back(after);
    return result;
}

}  // namespace

OrderedJson with_name(const OrderedJson& rules, const std::string& before, const std::string& after) {
    OrderedJson result = rules;
    if (rules.contains("score")) result["score"] = with_key(rules.at("score"), before, after);
    if (rules.contains("end_bonus"))
        result["end_bonus"]["points"] = with_key(rules.at("end_bonus").at("points"), before, after);
    if (rules.contains("skill_shot")) {
        OrderedJson& parts = result["skill_shot"]["parts"];
        parts = with_part(parts, before, after);
        if (parts.empty()) result.erase("skill_shot");
    }
    for (const char* kind : {"targets", "lanes"}) {
        if (!rules.contains(kind)) continue;
        OrderedJson groups = OrderedJson::array();
        for (OrderedJson group : rules.at(kind)) {
            group["parts"] = with_part(group.at("parts"), before, after);
            if (!group["parts"].empty()) groups.push_back(group);
        }
        result[kind] = groups;
    }
    if (!rules.contains("spinners")) return result;
    OrderedJson spinners = OrderedJson::array();
    for (OrderedJson spinner : rules.at("spinners")) {
        if (spinner.at("part") == before) {
            if (after.empty()) continue;
            spinner["part"] = after;
        }
        spinners.push_back(spinner);
    }
    result["spinners"] = spinners;
    return result;
}

}  // namespace flipside::lab
