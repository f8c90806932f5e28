#include "lab/files/csv.hpp"

#include <charconv>
#include <ostream>

#include "world/printable.hpp"

namespace flipside::lab {

CsvRow& CsvRow::add(double value) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, value, std::chars_format::general, 17).ptr;
    return append(std::string_view(text, end));
}

CsvRow& CsvRow::add(std::string_view text) {
    std::string word = printable(text);
    if (word.find_first_of("=+-@'") == 0) word.insert(0, 1, '\'');
    if (word.find_first_of(",\"") == std::string::npos) return append(word);
    std::string quoted = "\"";
    for (const char c : word) quoted.append(c == '"' ? 2 : 1, c);
    return append(quoted + '"');
}

CsvRow& CsvRow::append(std::string_view field) {
    if (begun_) line_ += ',';
    begun_ = true;
    line_ += field;
    return *this;
}

void CsvRow::write(std::ostream& out) {
    line_ += '\n';
    out << line_;
    line_.clear();
    begun_ = false;
}

void write_sample(std::ostream& out, double time, std::span<const Ball> balls) {
    CsvRow row;
    for (const Ball& ball : balls) {
        row.add(time).add(ball.number);
        row.add(ball.position.x).add(ball.position.y).add(ball.velocity.x).add(ball.velocity.y);
        row.add(ball.angle).add(ball.spin).write(out);
    }
}

void write_events(std::ostream& out, std::span<const Event> events, const Scene& scene) {
    CsvRow row;
    for (const Event& event : events) {
        row.add(event.time).add(name_of(event.kind)).add(event.ball);
        row.add(name_of_other(event, scene)).add(event.point.x).add(event.point.y);
        row.add(event.normal.x).add(event.normal.y).add(event.speed).add(event.impulse).write(out);
    }
}

std::string name_of_other(const Event& event, const Scene& scene) {
    if (event.kind == EventKind::lost) return "";
    if (event.other.is_ball) return "ball:" + std::to_string(event.other.index);
    return scene.parts[event.other.index].name;
}

}  // namespace flipside::lab
