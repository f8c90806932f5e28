#pragma once
/// Fields for values of a document: each shows what is there and writes what is typed.

#include "app/window/controls.hpp"
#include "app/window/editor/editor.hpp"

namespace flipside::app {

/// Of a number: how it is shown, and what the form of the scene file permits of it.
struct FieldSpec {
    const char* label = "";
    const char* meaning = "";
    const char* unit = "";
    double per_unit = 1;  ///< shown over stored: 1000 for mm
    double least = -1e9, most = 1e9;
    double usual = 0;  ///< where the key is missing
};

class FieldSet {
  public:
    FieldSet(Editor& editor, ControlPlaces& places) : editor_(editor), places_(places) {}

    void number(const lab::Path& path, const FieldSpec& spec) const;
    /// Of a place or velocity, in a line.
    void pair(const lab::Path& path, const FieldSpec& spec) const;
    /// Never "" where `some` is wanted.
    void text(const lab::Path& path, const char* name, const char* meaning, std::size_t most,
              bool some = false) const;
    void toggle(const lab::Path& path, const char* name, const char* meaning) const;
    /// The field alone; true once the text is to be written, by those who have to do more than that.
    bool typed_text(const char* name, const char* meaning, std::string& text, std::size_t most) const;

    [[nodiscard]] const lab::OrderedJson* find(const lab::Path& path) const {
        return lab::find(editor_.draft().document().json(), path);
    }

  private:
    /// A field as wide as is said; writes into the document.
    void value(const char* id, const std::string& name, double before, const lab::Path& path, std::size_t at,
               const FieldSpec& spec) const;
    void end_where_done() const;

    Editor& editor_;
    ControlPlaces& places_;
};

[[nodiscard]] lab::Path operator/(lab::Path path, const std::string& key);

}  // namespace flipside::app
