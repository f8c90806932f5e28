#include "lab/editor/document.hpp"

#include <utility>

namespace flipside::lab {

Document::Document(std::string text) : text_(std::move(text)) {
    read();
}

void Document::apply(std::vector<Splice> splices) {
    // From the last to the first, so that each finds its place.
    for (std::size_t i = splices.size(); i-- > 0;) {
        text_.replace(splices[i].at, splices[i].removed.size(), splices[i].inserted);
        open_.push_back(std::move(splices[i]));
    }
    if (!splices.empty()) read();
}

void Document::set(const Path& path, const OrderedJson& value) {
    const OrderedJson* before = find(json_, path);
    if (before == nullptr) {
        apply({adding(text_, {path.begin(), path.end() - 1}, path.back(), value)});
        return;
    }
    if (!before->is_object() || !value.is_object()) return apply(replacing(text_, path, value));
    // Keys come and go one by one; the others stay as they are written.
    std::vector<std::string> gone;
    for (const auto& entry : before->items())
        if (!value.contains(entry.key())) gone.push_back(entry.key());
    Path inner = path;
    inner.emplace_back();
    for (const std::string& key : gone) {
        inner.back() = key;
        remove(inner);
    }
    for (const auto& entry : value.items()) {
        inner.back() = entry.key();
        set(inner, entry.value());
    }
}

void Document::append(const Path& array, const OrderedJson& value) {
    if (find(json_, array) == nullptr) set(array, OrderedJson::array());
    apply({adding(text_, array, "", value)});
}

void Document::remove(const Path& path) {
    apply({removing(text_, path)});
}

namespace {

void splice_back(std::string& text, const std::vector<Splice>& step) {
    for (std::size_t i = step.size(); i-- > 0;)
        text.replace(step[i].at, step[i].inserted.size(), step[i].removed);
}

}  // namespace

void Document::run(const Step& step) {
    for (const Splice& splice : step) text_.replace(splice.at, splice.removed.size(), splice.inserted);
    read();
}

void Document::run_back(const Step& step) {
    splice_back(text_, step);
    read();
}

std::size_t Document::bytes_of(const Step& step) {
    std::size_t bytes = 0;
    for (const Splice& splice : step) bytes += splice.removed.size() + splice.inserted.size();
    return bytes;
}

void Document::end_step() {
    if (open_.empty()) return;
    std::string before = text_;
    splice_back(before, open_);
    if (before == text_) return open_.clear();  // edits that cancel are no step
    bytes_ += bytes_of(open_);
    done_.push_back(std::exchange(open_, {}));
    undone_.clear();
    while (done_.size() > most_steps || (bytes_ > most_bytes && done_.size() > 1)) {
        bytes_ -= bytes_of(done_.front());
        done_.pop_front();
    }
}

void Document::revert_step() {
    if (!open_.empty()) run_back(std::exchange(open_, {}));
}

bool Document::undo() {
    end_step();
    if (done_.empty()) return false;
    run_back(done_.back());
    bytes_ -= bytes_of(done_.back());
    undone_.push_back(std::move(done_.back()));
    done_.pop_back();
    return true;
}

bool Document::redo() {
    if (!can_redo()) return false;
    run(undone_.back());
    bytes_ += bytes_of(undone_.back());
    done_.push_back(std::move(undone_.back()));
    undone_.pop_back();
    return true;
}

}  // namespace flipside::lab
