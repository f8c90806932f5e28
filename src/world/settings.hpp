#pragma once
/// Settings of an engine, described once. The command line, the panels and the report all read this.

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace flipside {

enum class SettingType { real, integer, toggle, choice };

/// A former value of a setting, with advice for users of it.
struct RetiredChoice {
    std::string_view name, advice;
};

/// That another setting of the engine has one of these values, as text.
struct Condition {
    std::string_view setting{};  ///< "": always met
    std::span<const std::string_view> values{};
};

struct SettingSpec {
    std::string_view name;
    SettingType type = SettingType::real;
    std::string_view unit{};  ///< "" where it has none
    double initial = 0;       ///< a toggle's 0 or 1, a choice's index
    double min = 0, max = 0;  ///< of reals and integers, inclusive
    std::span<const std::string_view> choices{};
    std::span<const RetiredChoice> retired{};
    std::string_view about;  ///< one line: meaning, and what too small or too large does
    Condition acts_with{};   ///< without it the setting changes nothing
    bool everyday = false;   ///< among the few that are shown first
};

/// The values of one engine's settings, always valid.
class Settings {
  public:
    /// Every setting at its default. `specs` must outlive this object (engines keep theirs for ever).
    explicit Settings(std::span<const SettingSpec> specs);

    /// Sets from text as on the command line ("4", "0.5", "on", "quadtree").
    /// Throws InputError that names what is allowed.
    void set(std::string_view name, std::string_view value);
    /// Sets from a number (toggle: 0 or 1, choice: index); throws like the other.
    void set(std::string_view name, double value);

    [[nodiscard]] double real(std::string_view name) const;
    [[nodiscard]] int integer(std::string_view name) const;
    [[nodiscard]] bool toggle(std::string_view name) const;
    [[nodiscard]] std::string_view choice(std::string_view name) const;
    /// The value as text, such that set(name, text(name)) changes nothing.
    [[nodiscard]] std::string text(std::string_view name) const;
    [[nodiscard]] std::span<const SettingSpec> specs() const { return specs_; }
    /// Why the setting changes nothing at present ("only with solver simple"); "" where it acts.
    [[nodiscard]] std::string idle(std::string_view name) const;

    friend bool operator==(const Settings& a, const Settings& b) {
        return a.specs_.data() == b.specs_.data() && a.values_ == b.values_;
    }

  private:
    [[nodiscard]] std::size_t index(std::string_view name) const;

    std::span<const SettingSpec> specs_;
    std::vector<double> values_;
};

}  // namespace flipside
