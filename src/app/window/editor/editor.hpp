#pragma once
/// The edit mode: a scene is drawn by mouse and keys while the table stands still. What it does to the
/// scene's document is in lab/editor; how it looks is in editor_view.hpp.

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <SFML/Window/Event.hpp>

#include "app/window/camera.hpp"
#include "app/window/layout.hpp"
#include "app/window/stage.hpp"
#include "lab/editor/draft.hpp"
#include "lab/editor/scene_save.hpp"
#include "lab/editor/snap.hpp"

namespace flipside::app {

/// Where the mouse is, and what is held beside it.
struct Pointing {
    const Rect& pane;
    const Camera& camera;
    double scale = 1;        ///< of letters and controls
    bool unsnapped = false;  ///< Ctrl is held
    bool adding = false;     ///< Shift is held
    double now = 0;          ///< wall time, s
};

/// What the mouse does while its button is down.
struct EditDrag {
    enum class What { move, pull, turn };
    EditDrag(What kind, lab::OrderedJson thing) : what(kind), before(std::move(thing)) {}

    What what;
    lab::OrderedJson before;  ///< the thing
    lab::Handle handle;
    Vec2 from;   ///< m, where it was pressed
    Vec2 pixel;  ///< of the window
    bool moved = false;
    std::vector<Vec2> ends;  ///< to which it may join
};

class Editor {
  public:
    /// On the scene that is on show: from its file, as it is now, or on with what was drawn of it before.
    /// Throws InputError where the file is no good.
    void begin(const Stage& stage);
    /// On an empty table, or a scene from elsewhere.
    void begin_new();
    void begin_file(const std::string& name);
    void leave() { on_ = false; }
    [[nodiscard]] bool on() const { return on_; }

    /// True if no other part of the window may handle the event.
    bool process(const sf::Event& event, const Pointing& pointing);

    [[nodiscard]] const lab::Draft& draft() const { return *draft_; }
    /// Of the panel: within the step that is open.
    [[nodiscard]] lab::Draft& draft() { return *draft_; }
    /// What is moved, copied and taken away: parts, balls, the launcher.
    [[nodiscard]] const std::vector<lab::Item>& selection() const { return selection_; }
    [[nodiscard]] bool is_selected(const lab::Item& item) const;
    /// The last one that was picked, or the bounds, which is to say the table, where nothing is.
    [[nodiscard]] lab::Item selected() const;
    /// It alone; of the bounds: nothing.
    void select(const lab::Item& item);
    /// Of the selected thing, if it is the only one, those that are far enough from others to be seized.
    [[nodiscard]] std::vector<lab::Handle> handles(const Camera& camera, double scale) const;
    /// Where the selected thing is turned, and about what; nothing for what has no direction.
    struct TurnHandle {
        Vec2 about, at;  ///< px, of the pane
    };
    [[nodiscard]] std::optional<TurnHandle> turn_handle(const Camera& camera, double scale) const;

    [[nodiscard]] const lab::Tool& tool() const { return lab::tools()[tool_]; }
    void take(const lab::Tool& tool);
    /// What is being drawn: the points so far, and where the next one would be.
    [[nodiscard]] const std::vector<Vec2>& pen() const { return pen_; }
    [[nodiscard]] const lab::Snapped& target() const { return target_; }
    [[nodiscard]] bool draws() const { return tool_ != 0; }
    /// While something is pulled, moved or turned.
    [[nodiscard]] bool drags() const { return drag_ && drag_->moved; }
    [[nodiscard]] bool mouse_in_pane() const { return in_pane_; }

    void undo();
    void redo();
    void remove_selected();
    void duplicate_selected();

    /// Snapping as the user wants it; reach is the editor's own.
    double pitch = 0.01;  ///< m
    bool snaps = true;

    /// Has something been drawn that is in no file?
    [[nodiscard]] bool unsaved() const;
    /// Where the scene is from and is saved to; nothing for one that has no file yet.
    [[nodiscard]] const std::optional<lab::OwnFile>& own() const { return own_; }
    /// As Stage::scene_name() has it.
    [[nodiscard]] const std::string& name() const { return name_; }
    /// Whether its file is another one than was read or written.
    [[nodiscard]] bool file_changed() const;
    /// Writes the file. Throws lab::Failure; then all is as it was.
    void save_to(const std::filesystem::path& file);

    // What was asked for by keys, for the panel to do.
    bool save_wanted = false, save_as_wanted = false;

  private:
    void show(lab::Draft draft);
    bool press(Vec2 pixel, const Pointing& pointing);
    void move(Vec2 pixel, const Pointing& pointing);
    void release(Vec2 pixel, const Pointing& pointing);
    bool press_key(const sf::Event::KeyEvent& key, const Pointing& pointing);
    bool press_with_ctrl(const sf::Event::KeyEvent& key);
    bool escape();
    void nudge(Vec2 by);
    void select_one_more_or_less(const lab::Item& item);
    void select_all();
    [[nodiscard]] std::vector<lab::Item> all_items() const;
    void select_next(int by);
    void remove_corner_or_selected(const Pointing& pointing);

    void put_point(Vec2 pixel, const Pointing& pointing);
    void finish_pen();
    void aim(Vec2 pixel, const Pointing& pointing);
    void drag_to(Vec2 at, const Pointing& pointing);
    [[nodiscard]] lab::OrderedJson pulled_to(Vec2 at, const lab::SnapRules& rules);
    [[nodiscard]] lab::OrderedJson turned_to(Vec2 at, bool snapping) const;
    void begin_drag(EditDrag::What what, Vec2 pixel, const Pointing& pointing);
    [[nodiscard]] std::optional<lab::Handle> handle_at(Vec2 pixel, const Camera& camera, double scale) const;
    [[nodiscard]] std::optional<lab::Item> item_at(Vec2 at, double reach) const;
    [[nodiscard]] std::vector<Vec2> ends_but_of(std::span<const lab::Item> items) const;
    [[nodiscard]] lab::SnapRules rules(const Pointing& pointing) const;
    void keep_selection_valid();

    bool on_ = false;
    std::optional<lab::Draft> draft_;
    std::string name_;
    std::optional<lab::OwnFile> own_;
    std::string saved_;  ///< the text that is in the file, or with which it began
    std::vector<lab::Item> selection_;
    std::size_t tool_ = 0;  ///< of lab::tools()
    std::vector<Vec2> pen_;
    lab::Snapped target_;
    std::optional<EditDrag> drag_;
    bool pressed_ = false;    ///< the left button, in the pane
    Vec2 pressed_pixel_;      ///< of the window
    double pressed_at_ = -1;  ///< s
    Vec2 mouse_pixel_;        ///< of the window
    bool in_pane_ = false;
    bool ground_ = false;  ///< nothing was under the mouse as it was pressed
};

/// The launcher is drawn and picked as a disc of so many radii of its ball.
inline constexpr double launcher_radii = 1;

}  // namespace flipside::app
