#pragma once
/// What the rules have to tell, in words on the table. Balls roll over them.

#include <optional>
#include <string>

#include "app/window/canvas.hpp"
#include "app/window/layout.hpp"
#include "lab/game/game.hpp"

namespace flipside::app {

struct CaptionWords {
    std::string title, detail;  ///< a few words, and what comes of it or is to be done; may be ""
    bool warns = false;
    double strength = 1;  ///< 0…1, falls as it goes
};

/// What is to be read at that time, s: of the last captions the one of highest rank that is still on show.
[[nodiscard]] std::optional<CaptionWords> caption_of(const lab::Game& game, double time);

/// Into a pane of that size, one below the other.
class CaptionWriter {
  public:
    CaptionWriter(Canvas& canvas, const Rect& pane) : canvas_(canvas), pane_(pane), y_(0.5 * pane.height) {}

    void write(const CaptionWords& words, sf::Color color);

  private:
    Canvas& canvas_;
    Rect pane_;
    double y_;
};

}  // namespace flipside::app
