#pragma once
/// Changes inputs so that most stay files that are read, with the numbers on which collision code breaks.

#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace flipside::fuzz {

class Mutator {
  public:
    explicit Mutator(std::uint64_t seed) : random_(seed) {}

    /// A changed JSON document, or a changed table where the text is none. Empty: change the bytes instead.
    [[nodiscard]] std::string mutate(std::string_view text);
    /// The first document with one value of the second; empty where one of them is no JSON.
    [[nodiscard]] std::string cross(std::string_view first, std::string_view second);

  private:
    using Json = nlohmann::json;
    /// All values of a document, its numbers, and the pairs of numbers that may be points.
    struct Values {
        std::vector<Json*> all, numbers, points, containers;
    };

    [[nodiscard]] std::size_t below(std::size_t limit) { return random_() % limit; }
    template <class List>
    [[nodiscard]] auto& any_of(List& list) {
        return list[below(list.size())];
    }

    void change(Json& document);
    void change_number(Json& number, const Values& values);
    void change_container(Json& container, const Values& values);
    void change_object(Json& object, const Values& values);
    void change_array(Json& array, const Values& values);
    void move_to_touch(Json& document, const Values& values);
    [[nodiscard]] double near(double value);
    [[nodiscard]] std::string change_table(std::string_view text);

    std::mt19937_64 random_;
};

}  // namespace flipside::fuzz
