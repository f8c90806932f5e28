#include "app/window/playfield/captions.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "app/window/theme.hpp"
#include "app/window/words.hpp"

namespace flipside::app {

namespace {

using lab::Caption, lab::CaptionKind;

constexpr double short_seconds = 1.4, long_seconds = 2.6, fade_seconds = 0.3;
constexpr double count_seconds = 0.4;  ///< of each time that the bonus is counted

double seconds_of(CaptionKind kind) {
    return kind < CaptionKind::lanes_complete ? short_seconds : long_seconds;
}

std::string of_all(const char* what, const Caption& caption) {
    return what + std::to_string(caption.value) + " of " + std::to_string(caption.of);
}

/// Counts up, once for each time that it is paid.
CaptionWords bonus(const Caption& caption, double age) {
    const long counted = std::clamp(1 + static_cast<long>(age / count_seconds), 1L, caption.of);
    return {"Bonus " + points_in_words(counted * caption.value),
            points_in_words(caption.value) + " × " + std::to_string(counted)};
}

CaptionWords words_of(const Caption& caption, double age) {
    const std::string paid = "+" + points_in_words(caption.value);
    switch (caption.kind) {
        case CaptionKind::lane:
            return {of_all("Lanes ", caption), ""};
        case CaptionKind::target:
            return {of_all("Targets ", caption), ""};
        case CaptionKind::ball_search:
            return {"Ball search", "the table shakes it loose"};
        case CaptionKind::lanes_complete:
            return {"Lanes lit", paid + (caption.of > 1 ? "  ·  bonus × " + std::to_string(caption.of) : "")};
        case CaptionKind::bank_complete:
            return {"Targets down",
                    paid + (caption.of == 1  ? "  ·  one bank to multiball"
                            : caption.of > 1 ? "  ·  " + std::to_string(caption.of) + " banks to multiball"
                                             : "")};
        case CaptionKind::skill_shot:
            return {"Skill shot", paid};
        case CaptionKind::jackpot:
            return {"Jackpot", paid};
        case CaptionKind::multiball:
            return {"Multiball", std::to_string(caption.value) + " balls"};
        case CaptionKind::ball_saved:
            return {"Ball saved", caption.value > 0 ? "it is yours to launch again" : "here it comes again"};
        case CaptionKind::tilt_warning:
            return {"Careful", "one more nudge tilts the table", true};
        case CaptionKind::bonus:
            return bonus(caption, age);
        case CaptionKind::tilt:
            break;
    }
    return {"Tilt", "until this ball is lost", true};
}

/// A dark plate with round ends behind the letters, which fades outwards: the ground does not shine through.
void draw_plate(Canvas& canvas, Vec2 middle, double width, double height, double strength) {
    constexpr int layers = 5;
    for (int i = 0; i < layers; ++i) {
        const double radius = 0.5 * height + canvas.scaled(3) * (i - 1), half = 0.5 * (width - height);
        const Vec2 left = middle - Vec2{half, 0}, right = middle + Vec2{half, 0};
        std::vector<Vec2> rim;
        constexpr int corners = 12;
        for (int k = 0; k <= corners; ++k)
            rim.push_back(right + radius * from_angle(std::numbers::pi * (double(k) / corners - 0.5)));
        for (int k = 0; k <= corners; ++k)
            rim.push_back(left + radius * from_angle(std::numbers::pi * (double(k) / corners + 0.5)));
        canvas.fill(rim, with_alpha(colour::around, 0.35 * strength));
    }
}

}  // namespace

std::optional<CaptionWords> caption_of(const lab::Game& game, double time) {
    const Caption* shown = nullptr;
    for (const Caption& caption : game.captions()) {
        const double age = time - caption.time;
        if (age < 0 || age >= seconds_of(caption.kind)) continue;
        if (shown == nullptr || caption.kind >= shown->kind) shown = &caption;
    }
    if (game.tilted()) return words_of({CaptionKind::tilt}, 0);
    if (shown == nullptr || shown->kind == CaptionKind::tilt) return std::nullopt;
    const double age = time - shown->time;
    CaptionWords words = words_of(*shown, age);
    words.strength = std::clamp((seconds_of(shown->kind) - age) / fade_seconds, 0.0, 1.0);
    return words;
}

void CaptionWriter::write(const CaptionWords& words, sf::Color color) {
    const Lettering& lettering = canvas_.lettering();
    const double room = 0.94 * pane_.width;
    const Type type = lettering.width(words.title, Type::title) <= room ? Type::title : Type::large;
    const std::vector<std::string> titles = lettering.lines(words.title, type, room);
    const std::vector<std::string> details = lettering.lines(words.detail, Type::small, room);
    double width = 0;
    for (const std::string& line : titles) width = std::max(width, lettering.width(line, type));
    for (const std::string& line : details) width = std::max(width, lettering.width(line, Type::small));
    const double title = lettering.line_height(type), detail = lettering.line_height(Type::small);
    const double height =
        title * static_cast<double>(titles.size()) + detail * static_cast<double>(details.size());
    if (y_ + title > pane_.height) return;  // half a line says nothing
    Vec2 at{std::round(0.5 * pane_.width), std::round(y_)};
    draw_plate(canvas_, at + Vec2{0, 0.5 * height}, width + height, height, words.strength);
    for (const std::string& line : titles) {
        canvas_.text(at, line, type, with_alpha(words.warns ? colour::warning : color, words.strength),
                     Align::center);
        at.y += title;
    }
    for (const std::string& line : details) {
        canvas_.text(at, line, Type::small, with_alpha(colour::text, words.strength), Align::center);
        at.y += detail;
    }
    y_ += height + canvas_.scaled(12);
}

}  // namespace flipside::app
