#pragma once
/// A scene that is being drawn: its document, what it looks like at this moment, and whether it is a scene
/// that can be run, by the same checks as `flipside check` makes.

#include <memory>
#include <optional>

#include "lab/editor/document.hpp"
#include "lab/editor/handles.hpp"
#include "lab/editor/palette.hpp"
#include "lab/editor/reshape.hpp"

namespace flipside::lab {

/// One thing on the table.
struct Item {
    enum class Kind { part, ball, launcher, bounds };
    Kind kind = Kind::part;
    std::size_t index = 0;  ///< of parts and balls, as listed in the document

    friend bool operator==(const Item&, const Item&) = default;
};

[[nodiscard]] Path path_of(const Item& item);

/// Why the scene cannot be run.
struct Problem {
    std::string words;           ///< one line
    std::optional<Item> item{};  ///< whose fault it is, if one thing's
};

class Draft {
  public:
    /// Throws InputError where the text is not a good scene. `file` is only named in errors.
    Draft(std::string text, const std::string& file);

    [[nodiscard]] const Document& document() const { return document_; }
    /// The thing as the document has it, or null.
    [[nodiscard]] const OrderedJson* find(const Item& item) const;
    /// What is listed, as it looks.
    [[nodiscard]] const Scene& sketch() const { return sketch_; }
    /// The last good scene: that of this document while there is no problem.
    [[nodiscard]] const std::shared_ptr<const Scene>& scene() const { return scene_; }
    [[nodiscard]] const std::optional<Problem>& problem() const { return problem_; }
    /// Of the launcher's or the first ball, or one that suits the table's size, m.
    [[nodiscard]] double ball_radius() const;

    /// What follows changes the document within the step that is open; end_step() ends it.
    void set(const Path& path, const OrderedJson& value);
    void replace(const Item& item, const OrderedJson& thing) { set(path_of(item), thing); }
    void move(std::span<const Item> items, Vec2 by);
    /// What a tool makes of these points, in the first material that suits it.
    Item add(const Tool& tool, std::span<const Vec2> points);
    Item duplicate(const Item& item, Vec2 by);
    /// Also out of the rules, where they name it. The bounds stay.
    void remove(const Item& item);
    /// Also in the rules.
    void rename(std::size_t part, const std::string& name);
    /// One more, like that one, for the thing at that path alone.
    void add_material(Path thing, const std::string& like);

    void end_step() { document_.end_step(); }
    void revert_step();
    bool undo();
    bool redo();

  private:
    void refresh();
    [[nodiscard]] std::string free_name(const std::string& stem) const;
    /// Rules that name a part name another one from now on; "": none.
    void name_in_rules(const std::string& before, const std::string& after);

    Document document_;
    Scene sketch_;
    std::shared_ptr<const Scene> scene_;
    std::optional<Problem> problem_;
};

}  // namespace flipside::lab
