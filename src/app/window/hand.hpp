#pragma once
/// The mouse on what lies on the table: a click picks a ball or part, dragging a ball throws it, a click with
/// Shift or Ctrl adds a ball.

#include <optional>

#include <SFML/Window/Event.hpp>

#include "app/window/camera.hpp"
#include "app/window/layout.hpp"
#include "app/window/stage.hpp"
#include "app/window/table_view.hpp"

namespace flipside::app {

class Hand {
  public:
    /// m/s of a throw for each metre that the ball is pulled back.
    static constexpr double stiffness = 10;

    /// What becomes of an event of the mouse.
    enum class Took {
        nothing,  ///< whatever else the mouse does may follow
        it,       ///< no other part of the window may handle it
        no_room   ///< the same; no ball could be added there
    };
    Took process(const sf::Event& event, bool adds, const Layout& layout, const Camera& camera, Stage& stage);

    [[nodiscard]] const std::optional<Other>& picked() const { return picked_; }
    /// Picks the ball, or the part, after the one that is; the first after the last.
    void pick_next_ball(const Stage& stage);
    void pick_next_part(const Stage& stage);
    /// While a ball is pulled back; time is to stand still then.
    [[nodiscard]] std::optional<Sling> sling(const Camera& camera, const Stage& stage) const;
    [[nodiscard]] bool slings() const { return pressed_ && pulled_; }
    /// Where on the table a picked part is, m.
    [[nodiscard]] const Box& extent() const { return extent_; }
    /// Of the sling, or else of what is picked; false where there is neither.
    bool let_go();
    /// Takes the picked ball off the table; false where none is picked, or there is none any more.
    bool remove(Stage& stage);

  private:
    struct Pressed {
        std::size_t pane = 0;
        Rect place;
        std::optional<Other> on;
        Vec2 at;  ///< px, of the window
    };

    void pick(std::optional<Other> what, const Stage& stage);
    void press(Vec2 at, const Layout& layout, const Camera& camera, const Stage& stage);
    Took add(Vec2 at, const Layout& layout, const Camera& camera, Stage& stage) const;
    void release(const Camera& camera, Stage& stage);

    std::optional<Pressed> pressed_;
    Vec2 mouse_;           ///< px, of the window
    bool moved_ = false;   ///< since the press, by more than a click does
    bool pulled_ = false;  ///< moved with a ball
    std::optional<Other> picked_;
    Box extent_;
};

}  // namespace flipside::app
