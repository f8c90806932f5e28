#pragma once
/// A JSON document that is edited by hand: its text, what it says, and the steps that led to it. Whatever is
/// not edited keeps its letters, and undoing gives the same bytes again.

#include <deque>

#include "lab/editor/json_text.hpp"

namespace flipside::lab {

class Document {
  public:
    /// The text must be JSON.
    explicit Document(std::string text);

    [[nodiscard]] const std::string& text() const { return text_; }
    [[nodiscard]] const OrderedJson& json() const { return json_; }

    /// What is at the path becomes that. A key that is missing in an object is added to it.
    void set(const Path& path, const OrderedJson& value);
    /// To the end of an array, which is made where it is missing.
    void append(const Path& array, const OrderedJson& value);
    void remove(const Path& path);

    /// What was changed since the last step becomes a step of its own, if it changed anything: the edits may
    /// have cancelled. The oldest ones are forgotten beyond
    /// `most_steps`, or where all of them hold more than `most_bytes`.
    void end_step();
    /// Takes back what was changed since the last step.
    void revert_step();
    [[nodiscard]] bool in_step() const { return !open_.empty(); }
    /// False where there is nothing to undo or to do again. What was changed since the last step becomes one
    /// first.
    bool undo();
    bool redo();
    [[nodiscard]] bool can_undo() const { return !done_.empty() || in_step(); }
    [[nodiscard]] bool can_redo() const { return !undone_.empty() && !in_step(); }

    static constexpr std::size_t most_steps = 1000, most_bytes = 16U << 20U;

  private:
    using Step = std::vector<Splice>;

    void apply(std::vector<Splice> splices);
    /// In that order, or taken back from the last to the first.
    void run(const Step& step);
    void run_back(const Step& step);
    void read() { json_ = OrderedJson::parse(text_); }
    [[nodiscard]] static std::size_t bytes_of(const Step& step);

    std::string text_;
    OrderedJson json_;
    Step open_;
    std::deque<Step> done_, undone_;
    std::size_t bytes_ = 0;  ///< of done_
};

}  // namespace flipside::lab
