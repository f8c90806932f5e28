#include "app/window/game_end.hpp"

#include <algorithm>
#include <cmath>

#include "app/window/contender_colour.hpp"
#include "app/window/kept.hpp"
#include "app/window/words.hpp"

namespace flipside::app {

namespace {

bool plays_on(const Run& run) {
    return !run.halt() && !run.session().game().over();
}

/// The first place at which two of the games went different ways.
std::string parted_in_words(const Stage& stage) {
    const Divergence* first = nullptr;
    for (const Divergence& divergence : stage.divergences())
        if (const auto& parting = divergence.first_parting();
            parting && (first == nullptr || parting->time < first->first_parting()->time))
            first = &divergence;
    if (first == nullptr) return "The games never parted";
    return "Parted at " + with_unit(first->first_parting()->time, 2, "s") + " on " +
           name_of_parting(*first->first_parting(), stage.scene());
}

}  // namespace

bool is_over(const Stage& stage) {
    if (!stage.scene().rules || std::ranges::any_of(stage.runs(), plays_on)) return false;
    return std::ranges::any_of(stage.runs(), [](const Run& run) { return run.session().game().over(); });
}

bool is_game_under_way(const Stage& stage) {
    const auto has_begun = [](const Run& run) { return run.session().totals().launched > 0; };
    return stage.scene().rules && !is_over(stage) && std::ranges::any_of(stage.runs(), has_begun);
}

GameEnd end_of(const Stage& stage) {
    GameEnd end;
    long most = 0;
    for (const Run& run : stage.runs()) most = std::max(most, run.session().game().score());
    const bool several = stage.runs().size() > 1;
    for (const Run& run : stage.runs()) {
        const long points = run.session().game().score();
        end.scores.push_back({run.name(), colour_of(run), points, several && points == most});
    }
    if (several) end.parted = parted_in_words(stage);
    return end;
}

void enter_scores(const Stage& stage, HighScores& scores, GameEnd& end) {
    if (!stage.gravity()) return;
    for (std::size_t i = 0; i < end.scores.size(); ++i) {
        const Run& run = stage.runs()[i];
        if (run.halt() || !run.played_by_hand()) continue;
        const HighScore score{kept_name(stage.scene_name()), std::string(run.engine().name),
                              end.scores[i].points, today()};
        end.scores[i].enters = scores.enter(score) > 0;
    }
}

namespace {

class EndCard {
  public:
    EndCard(Canvas& canvas, const GameEnd& end)
        : canvas_(canvas), end_(end), shown_(std::min<std::size_t>(3, end.high.size())) {}

    void draw(const Layout& layout) {
        const Rect& first = layout.panes.front();
        const Rect& last = layout.panes.back();
        const double left = first.x, right = std::max(first.x + first.width, last.x + last.width);
        const double top = first.y, bottom = last.y + last.height;
        width_ = std::min(canvas_.scaled(400), right - left - canvas_.scaled(16));
        // In a low window what this game came to goes before those of other days.
        if (height_of() > bottom - top) shown_ = 0;
        const double height = height_of();
        at_ = {std::round(0.5 * (left + right - width_)), std::round(0.5 * (top + bottom - height))};
        draw_ground(height);
        at_ += Vec2{pad(), pad()};
        width_ -= 2 * pad();
        line("Game over", Type::title, colour::lit);
        at_.y += gap();
        for (const GameEnd::Score& score : end_.scores) draw_score(score);
        if (!end_.parted.empty()) {
            at_.y += gap();
            line(end_.parted, Type::small, colour::text);
        }
        draw_high_scores();
        rule();
        line("Space plays again", Type::large, colour::text);
    }

  private:
    [[nodiscard]] double pad() const { return canvas_.scaled(18); }
    [[nodiscard]] double gap() const { return canvas_.scaled(8); }
    [[nodiscard]] double height(Type type) const { return canvas_.lettering().line_height(type); }
    [[nodiscard]] double height_of() const {
        const auto count = [](std::size_t n) { return static_cast<double>(n); };
        double sum = 2 * pad() + height(Type::title) + gap() + count(end_.scores.size()) * row();
        if (!end_.parted.empty()) sum += gap() + height(Type::small);
        if (shown_ > 0) sum += rule_height() + (count(shown_) + 1) * height(Type::small);
        return sum + rule_height() + height(Type::large);
    }
    [[nodiscard]] double row() const { return height(Type::large) + canvas_.scaled(6); }
    [[nodiscard]] double rule_height() const { return 2 * gap() + canvas_.scaled(1); }

    void draw_ground(double height) {
        const double border = canvas_.scaled(1);
        canvas_.rectangle(at_ - Vec2{border, border}, at_ + Vec2{width_ + border, height + border},
                          colour::rule);
        canvas_.rectangle(at_, at_ + Vec2{width_, height}, with_alpha(colour::around, 0.96));
    }
    void line(const std::string& words, Type type, sf::Color color) {
        canvas_.text(at_ + Vec2{0.5 * width_, 0}, canvas_.lettering().cut(words, type, width_), type, color,
                     Align::center);
        at_.y += height(type);
    }
    void rule() {
        at_.y += gap();
        canvas_.rectangle(at_, at_ + Vec2{width_, canvas_.scaled(1)}, colour::rule);
        at_.y += gap() + canvas_.scaled(1);
    }
    void draw_score(const GameEnd::Score& score) {
        const double inset = canvas_.scaled(10);
        if (score.best)
            canvas_.rectangle(at_, at_ + Vec2{width_, row() - canvas_.scaled(2)},
                              with_alpha(score.color, 0.16));
        canvas_.rectangle(at_, at_ + Vec2{canvas_.scaled(3), row() - canvas_.scaled(2)}, score.color);
        const std::string points = points_in_words(score.points);
        const double y = canvas_.scaled(2), taken = canvas_.lettering().width(points, Type::large);
        const std::string name = canvas_.lettering().cut(score.name, Type::large, width_ - taken - 3 * inset);
        canvas_.text(at_ + Vec2{inset, y}, name, Type::large, score.color);
        canvas_.text(at_ + Vec2{width_ - inset, y}, points, Type::large,
                     score.best || end_.scores.size() == 1 ? colour::lit : colour::text, Align::right);
        at_.y += row();
    }
    void draw_high_scores() {
        if (shown_ == 0) return;
        rule();
        const bool enters = std::ranges::any_of(end_.scores, &GameEnd::Score::enters);
        line(enters ? "New high score" : "High scores", Type::small, enters ? colour::lit : colour::quiet);
        for (std::size_t i = 0; i < shown_; ++i) {
            const HighScore& high = end_.high[i];
            const bool own = std::ranges::any_of(end_.scores, [&](const GameEnd::Score& score) {
                return score.enters && score.points == high.score;
            });
            const sf::Color color = own ? colour::lit : colour::text;
            const double inset = canvas_.scaled(10);
            canvas_.text(at_ + Vec2{inset, 0}, std::to_string(i + 1) + "   " + high.date, Type::small,
                         own ? colour::lit : colour::quiet);
            canvas_.text(at_ + Vec2{0.5 * width_, 0}, high.engine, Type::small, color);
            canvas_.text(at_ + Vec2{width_ - inset, 0}, points_in_words(high.score), Type::small, color,
                         Align::right);
            at_.y += height(Type::small);
        }
    }

    Canvas& canvas_;
    const GameEnd& end_;
    std::size_t shown_;  ///< high scores
    Vec2 at_;
    double width_ = 0;
};

}  // namespace

void draw_game_end(Canvas& canvas, const Layout& layout, const GameEnd& end) {
    EndCard(canvas, end).draw(layout);
}

}  // namespace flipside::app
