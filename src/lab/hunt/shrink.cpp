#include <cmath>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "lab/hunt/mutate.hpp"
#include "lab/hunt/round.hpp"
#include "world/scene_file.hpp"

namespace flipside::lab::hunt {

namespace {

/// Tries smaller scenes, and takes those that are bad enough.
class Shrinker {
  public:
    Shrinker(const Request& request, const Found& found, const std::function<void()>& watch)
        : request_(request), watch_(watch), best_(found), least_(keep * found.measured.value) {}

    [[nodiscard]] Found result() {
        if (best_.measured.value <= 0) return best_;
        // Each pass takes something away or rounds something, or is the last.
        for (bool smaller = true; smaller;) {
            smaller = drop(&Scene::balls, 0);
            smaller |= drop(&Scene::parts, request_.goal == Goal::escape ? 1 : 0);  // which is the box
            smaller |= plain();
        }
        for (const int digits : {6, 4, 3, 2, 1}) round_to(digits);
        return best_;
    }

  private:
    bool take(const Scene& scene) {
        watch_();
        const auto smaller = written(scene);
        if (!smaller || smaller->text == best_.text) return false;
        Measured measured = measure(request_, smaller->scene);
        if (!(measured.value >= least_)) return false;
        best_ = {smaller->text, std::move(measured), smaller->scene.balls.size(),
                 smaller->scene.parts.size()};
        return true;
    }
    [[nodiscard]] Scene scene() const { return parse_scene(best_.text, "a scene of the hunt"); }

    template <class T>
    bool drop(std::vector<T> Scene::*list, std::size_t first) {
        bool dropped = false;
        for (std::size_t i = (scene().*list).size(); i-- > first;) {
            Scene smaller = scene();
            if (i >= (smaller.*list).size()) continue;
            (smaller.*list).erase((smaller.*list).begin() + static_cast<std::ptrdiff_t>(i));
            dropped |= take(smaller);
        }
        return dropped;
    }
    /// Whatever can be as in any simple scene.
    bool plain() {
        bool taken = false;
        const auto change = [&](auto&& how) {
            Scene other = scene();
            how(other);
            taken |= take(other);
        };
        for (std::size_t i = 0; i < scene().parts.size(); ++i)
            if (!std::holds_alternative<motion::Still>(scene().parts[i].motion))
                change([i](Scene& s) { s.parts[i].motion = motion::Still{}; });
        for (std::size_t i = 0; i < scene().materials.size(); ++i) {
            if (scene().materials[i].friction != 0) change([i](Scene& s) { s.materials[i].friction = 0; });
            if (scene().materials[i].kick != 0) change([i](Scene& s) { s.materials[i].kick = 0; });
        }
        for (std::size_t i = 0; i < scene().balls.size(); ++i)
            if (scene().balls[i].spin != 0) change([i](Scene& s) { s.balls[i].spin = 0; });
        if (scene().damping != 0) change([](Scene& s) { s.damping = 0; });
        return taken;
    }

    /// All numbers at once, else one by one.
    void round_to(int digits) {
        nlohmann::json json = nlohmann::json::parse(best_.text);
        std::vector<nlohmann::json*> numbers;
        collect(json, numbers);
        const nlohmann::json before = json;
        for (nlohmann::json* number : numbers) *number = rounded(*number, digits);
        if (take_text(json)) return;
        json = before;
        numbers.clear();
        collect(json, numbers);
        for (nlohmann::json* number : numbers) {
            const nlohmann::json exact = *number;
            *number = rounded(exact, digits);
            if (*number != exact && !take_text(json)) *number = exact;
        }
    }
    bool take_text(const nlohmann::json& json) {
        try {
            return take(parse_scene(json.dump(), "a scene of the hunt"));
        } catch (const std::runtime_error&) {
            return false;
        }
    }
    static void collect(nlohmann::json& json, std::vector<nlohmann::json*>& numbers) {
        if (json.is_number_float()) numbers.push_back(&json);
        if (json.is_structured())
            for (nlohmann::json& one : json) collect(one, numbers);
    }
    static double rounded(double value, int digits) {
        char text[40];
        std::snprintf(text, sizeof text, "%.*g", digits, value);
        return std::strtod(text, nullptr);
    }

    const Request& request_;
    const std::function<void()>& watch_;
    Found best_;
    double least_;
};

}  // namespace

Found shrunk(const Request& request, const Found& found, const std::function<void()>& watch) {
    return Shrinker(request, found, watch).result();
}

}  // namespace flipside::lab::hunt
