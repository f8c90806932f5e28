#pragma once
/// CSV (RFC 4180, lines end with \n): rows of any table, trajectories and events among them. Numbers have 17
/// significant digits, so they read back to the same bits, and do not depend on the locale. Text is
/// printable() and so in one line; one that begins with = + - @ or ' gets a ' before it, for a spreadsheet
/// takes the first four for a formula. A reader takes one ' off the beginning of a text that has one.

#include <iosfwd>
#include <span>
#include <string>
#include <string_view>

#include "world/events.hpp"

namespace flipside::lab {

inline constexpr std::string_view trajectory_header = "time,ball,x,y,vx,vy,angle,spin\n";
inline constexpr std::string_view events_header = "time,kind,ball,other,x,y,nx,ny,speed,impulse\n";

/// One line, put together before it is written.
class CsvRow {
  public:
    CsvRow& add(double value);
    CsvRow& add(std::uint32_t value) { return append(std::to_string(value)); }
    CsvRow& add(std::uint64_t value) { return append(std::to_string(value)); }
    /// Text, in quotes where a comma or a quote asks for it.
    CsvRow& add(std::string_view text);
    /// Writes the line and is empty again.
    void write(std::ostream& out);

  private:
    /// A field as it is.
    CsvRow& append(std::string_view field);

    std::string line_;
    bool begun_ = false;
};

/// A row per ball.
void write_sample(std::ostream& out, double time, std::span<const Ball> balls);
/// A row per event.
void write_events(std::ostream& out, std::span<const Event> events, const Scene& scene);

/// What a ball met, as files and messages call it: the part's name or "ball:N"; "" for a lost ball.
[[nodiscard]] std::string name_of_other(const Event& event, const Scene& scene);

}  // namespace flipside::lab
