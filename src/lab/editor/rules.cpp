#include "lab/editor/rules.hpp"

namespace flipside::lab {

OrderedJson with_name(const OrderedJson& rules, const std::string& before, const std::string& after) {
    OrderedJson result = rules;
    if (rules.contains("score")) {
        OrderedJson scores = OrderedJson::object();
        for (const auto& score : rules.at("score").items())
            if (score.key() != before)
                scores[score.key()] = score.value();
            else if (!after.empty())
                scores[after] = score.value();
        result["score"] = scores;
    }
    for (const char* kind : {"targets", "lanes"}) {
        if (!rules.contains(kind)) continue;
        OrderedJson groups = OrderedJson::array();
        for (OrderedJson group : rules.at(kind)) {
            OrderedJson parts = OrderedJson::array();
            for (const OrderedJson& part : group.at("parts"))
                if (part != before)
                    parts.push_back(part);
                else if (!after.empty())
                    parts.push_back(after);
            group["parts"] = parts;
            if (!parts.empty()) groups.push_back(group);
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
