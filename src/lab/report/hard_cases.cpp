#include <algorithm>
#include <map>

#include "lab/cases/case.hpp"
#include "lab/report/chapter.hpp"
#include "lab/report/contender.hpp"
#include "world/input_error.hpp"
#include "world/json_file.hpp"

namespace flipside::lab::report {

namespace {

namespace fs = std::filesystem;

std::string answers_file(const Contender& contender) {
    return "cases-" + contender.name + ".json";
}

Measurement answers_measurement(const Contender& contender, const Effort& effort) {
    const auto measure = [=](const Watch& watch) {
        std::vector<CaseRun> runs;
        const auto chosen = find_cases(effort.cases);
        const auto share = [&] {
            return static_cast<double>(runs.size()) / static_cast<double>(chosen.size());
        };
        const CaseInput input{{&engine_named(contender.engine), settings_of(contender, Scene{})},
                              default_step,
                              effort.quick_cases,
                              [&] { watch(share()); }};
        for (const Case* one : chosen) runs.push_back({one, run_case(*one, input)});
        return to_json(runs, input);
    };
    return measurement_of_file(answers_file(contender), effort.case_seconds, measure);
}

/// The file of a contender, as far as it is one.
Json read_cases(const Data& data, const std::string& name) {
    const fs::path file = data.path(name);
    Json json = parse_json(data.read(name), file.string());
    if (!json.is_object() || json.value("format", "") != "flipside-cases/1" || !json.contains("cases"))
        throw InputError(file.string(), "/format", "is no \"flipside-cases/1\"");
    return json;
}

std::string number_or_dash(const Json& value) {
    return value.is_number() ? short_number(value.get<double>()) : "–";
}

/// A contender's answer: its error where an answer is known, else what was measured.
Table::Cell cell_of(const Json& row) {
    const std::string verdict = row.at("verdict");
    const std::string value = number_or_dash(row.at(row.at("error").is_number() ? "error" : "measured"));
    const std::string kind = verdict == "pass" ? "good" : verdict == "fail" ? "bad" : "";
    return {verdict == "measured" ? value : value + ", " + verdict, true, kind};
}

Table::Cell verdict_of(const Json& one) {
    const std::string verdict = one.at("verdict"), reason = one.at("reason");
    const std::string kind = verdict == "pass" ? "good" : verdict == "fail" ? "bad" : "";
    return {verdict + (reason.empty() ? "" : ": " + reason), false, kind};
}

/// The entry of `list` whose `key` is `value`; null where there is none.
const Json* entry(const Json& list, const char* key, const Json& value) {
    const auto at = std::ranges::find_if(list, [&](const Json& one) { return one.at(key) == value; });
    return at == list.end() ? nullptr : &*at;
}

struct Answers {
    std::vector<Contender> contenders;
    std::vector<Json> files;

    /// One column per contender after those of the row itself.
    [[nodiscard]] std::vector<std::string> columns(std::vector<std::string> first) const {
        for (const Contender& contender : contenders) first.push_back(contender.name);
        return first;
    }
};

Table verdict_table(const Answers& answers) {
    Table table{"cases",
                "Hard cases: verdicts",
                answers.columns({"Case", "What it shows"}),
                {},
                "An event-ordered solver passes or fails at the exact tolerance of each case; a solver that "
                "steps through time "
                "is measured, and fails only where a ball is lost or is no number any more."};
    for (const Json& one : answers.files.front().at("cases")) {
        std::vector<Table::Cell> row{
            {std::to_string(one.at("number").get<int>()) + " " + one.at("title").get<std::string>()},
            {one.at("about")}};
        for (const Json& file : answers.files) {
            const Json* const same = entry(file.at("cases"), "name", one.at("name"));
            row.push_back(same != nullptr ? verdict_of(*same) : Table::Cell{"–"});
        }
        table.rows.push_back(row);
    }
    return table;
}

/// The quantities of a case in their order, of all contenders: one that stopped early has not all of them.
std::vector<const Json*> quantities(const Answers& answers, const Json& name) {
    std::vector<const Json*> rows;
    for (const Json& file : answers.files) {
        const Json* const one = entry(file.at("cases"), "name", name);
        if (one == nullptr) continue;
        for (const Json& row : one->at("rows"))
            if (std::ranges::none_of(
                    rows, [&](const Json* known) { return known->at("quantity") == row.at("quantity"); }))
                rows.push_back(&row);
    }
    return rows;
}

Table quantity_table(const Answers& answers) {
    Table table{"case-quantities",
                "Hard cases: errors",
                answers.columns({"Case", "Quantity", "Expected", "Tolerance"}),
                {},
                "The error of every quantity, in its own unit, beside what was expected; where no exact "
                "answer is known, the "
                "value itself. A dash means that the run did not get there."};
    for (const Json& one : answers.files.front().at("cases")) {
        for (const Json* quantity : quantities(answers, one.at("name"))) {
            const std::string unit = quantity->at("unit");
            std::vector<Table::Cell> row{
                {one.at("title")},
                {quantity->at("quantity").get<std::string>() + (unit.empty() ? "" : ", " + unit)},
                {number_or_dash(quantity->at("expected")), true},
                {number_or_dash(quantity->at("tolerance")), true}};
            for (const Json& file : answers.files) {
                const Json* const same = entry(file.at("cases"), "name", one.at("name"));
                const Json* const found =
                    same != nullptr ? entry(same->at("rows"), "quantity", quantity->at("quantity")) : nullptr;
                row.push_back(found != nullptr ? cell_of(*found) : Table::Cell{"–", true});
            }
            table.rows.push_back(row);
        }
    }
    return table;
}

/// How often each verdict, contender by contender.
std::vector<std::string> findings_of(const Answers& answers) {
    std::string text;
    for (std::size_t i = 0; i < answers.files.size(); ++i) {
        std::map<std::string, std::size_t> counts;
        for (const Json& one : answers.files[i].at("cases")) ++counts[one.at("verdict")];
        text += (i == 0 ? "" : "; ") + answers.contenders[i].name + ":";
        bool is_first = true;
        for (const auto& [verdict, count] : counts) {
            text += (is_first ? " " : ", ") + std::to_string(count) + " " + verdict;
            is_first = false;
        }
    }
    return {"Of " + std::to_string(answers.files.front().at("cases").size()) +
            " hard cases with a known answer, each at its own tolerance: " + text + "."};
}

Content show_hard_cases(const Data& data) {
    Answers answers{contenders(), {}};
    for (const Contender& contender : answers.contenders)
        answers.files.push_back(read_cases(data, answers_file(contender)));
    try {
        return {{}, {verdict_table(answers), quantity_table(answers)}, findings_of(answers), {}};
    } catch (const Json::exception& error) {
        throw InputError(data.path("cases-*.json").string(), "", error.what());
    }
}

}  // namespace

Chapter hard_case_chapter(const Effort& effort) {
    Chapter chapter{
        "cases",
        "Hard cases",
        "Experiments whose right answer is known, at " + step_text(default_step) +
            " a step. The command flipside cases runs them one by one, on any engine at any setting.",
        {},
        show_hard_cases};
    for (const Contender& contender : contenders())
        chapter.measurements.push_back(answers_measurement(contender, effort));
    return chapter;
}

}  // namespace flipside::lab::report
