#pragma once
/// What the window has to tell: what went wrong stays until it is read, all else goes by itself.

#include <string>
#include <string_view>

namespace flipside::app {

struct ControlPlaces;
struct Rect;

class Notice {
  public:
    /// What went wrong.
    Notice& operator=(std::string_view words);
    /// What went well, or a question.
    void tell(std::string_view words);
    void clear() { words_.clear(); }
    [[nodiscard]] bool empty() const { return words_.empty(); }
    [[nodiscard]] const std::string& words() const { return words_; }
    [[nodiscard]] bool is_trouble() const { return trouble_; }
    /// `seconds` more have been seen of it.
    void pass(double seconds);

  private:
    std::string words_;
    bool trouble_ = false;
    double left_ = 0;  ///< until it goes, s
};

/// In the column, with a button to take it away.
void draw_notice(Notice& notice, ControlPlaces& places);
/// The same over the upper right corner of a pane, for a column that is folded.
void draw_notice_on(const Rect& pane, Notice& notice, ControlPlaces& places);

}  // namespace flipside::app
