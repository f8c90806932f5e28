#include "lab/report/gnuplot.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "lab/files/plain_name.hpp"
#include "lab/files/text_stream.hpp"
#include "lab/files/whole_file.hpp"
#include "lab/process/failure.hpp"
#include "lab/report/memory_file.hpp"
#include "lab/report/process.hpp"
#include "lab/report/svg.hpp"
#include "world/input_error.hpp"
#include "world/json_file.hpp"
#include "world/number_text.hpp"
#include "world/printable.hpp"

namespace flipside::lab::report {

namespace fs = std::filesystem;

namespace {

/// The only way of any text into a script: in double quotes, and every byte that is no letter, digit, space
/// or one of a few harmless signs as \ooo. So nothing is there that any of gnuplot's passes (comments,
/// backquotes, macros, escapes) could take for something else.
std::string string_literal(std::string_view text) {
    constexpr std::string_view harmless = " .,:;_-+=()/#";
    std::string out = "\"";
    for (const char c : printable(text)) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        if (plain || harmless.find(c) != std::string_view::npos) {
            out += c;
        } else {
            char escape[8];
            std::snprintf(escape, sizeof escape, "\\%03o", static_cast<unsigned char>(c));
            out += escape;
        }
    }
    return out + '"';
}

/// Names of files must not mean pipes or other folders to gnuplot.
void require_plain_id(const Figure& figure) {
    if (!is_plain_name(figure.id))
        throw Failure("figure '" + figure.id + "' cannot have files of its name; allowed are " +
                      std::string(plain_name_rule));
}

Range just_inside(const Range& range, const Axis& axis) {
    constexpr double hair = 1e-6;  // of the span
    if (!axis.logarithmic) {
        const double step = hair * (range.to - range.from);
        return {range.from + step, range.to - step};
    }
    const double factor = std::pow(range.to / range.from, hair);
    return {range.from * factor, range.to / factor};
}

/// Every decade, or every few where there are many, by its power; smaller marks between. Written out one by
/// one: left to itself gnuplot 5.4 may label 1000 as 10^2, where its own 1000 is a bit less.
std::string decades(const Range& range) {
    const int first = static_cast<int>(std::ceil(std::log10(range.from)));
    const int last = static_cast<int>(std::floor(std::log10(range.to)));
    const int apart = (last - first) / 8 + 1;  // labels on at most eight
    std::string tics;
    for (int power = first; power <= last; ++power) {
        const std::string label = power % apart == 0 ? "'10^{" + std::to_string(power) + "}' " : "'' ";
        tics += (tics.empty() ? "(" : ", ") + label + "1e" + std::to_string(power) +
                (power % apart == 0 ? "" : " 1");
        if (apart > 1 || power == last) continue;
        for (int digit = 2; digit <= 9; ++digit)
            tics += ", '' " + std::to_string(digit) + "e" + std::to_string(power) + " 1";
    }
    return tics + ")";
}

/// "('rain' 1, 'gas' 2)".
std::string names_of(const std::vector<std::string>& things) {
    std::string tics;
    for (std::size_t i = 0; i < things.size(); ++i)
        tics += (i == 0 ? "(" : ", ") + string_literal(things[i]) + " " + std::to_string(i + 1);
    return tics + ") noenhanced";
}

void write_axis(std::ostream& out, char name, const Axis& axis, const Range& range) {
    const Range inside = just_inside(range, axis);
    out << "set format " << name << " '%g'\n";
    if (axis.logarithmic) out << "set logscale " << name << '\n';
    if (axis.logarithmic || !axis.things.empty())
        out << "set " << name << "tics " << (axis.things.empty() ? decades(range) : names_of(axis.things))
            << '\n';
    out << "set " << name << "range [" << number_text(range.from) << ':' << number_text(range.to)
        << "]\n"
        // An infinite value, of a failed run, comes to the upper edge; what is below the range to the lower.
        // Just inside: what rounds to beyond the border is not drawn.
        << "at_" << name << "(v) = v < " << number_text(inside.from) << " ? " << number_text(inside.from)
        << " : v > " << number_text(inside.to) << " ? " << number_text(inside.to) << " : v\n";
}

void write_layout(std::ostream& out, const Figure& figure, const Layout& layout) {
    const auto across = [&](double px) { return number_text(px / layout.width); };
    const auto up = [&](double px) { return number_text(1 - px / layout.height); };
    out << "set lmargin at screen " << across(layout.left) << "\nset rmargin at screen "
        << across(layout.right) << "\nset tmargin at screen " << up(layout.top) << "\nset bmargin at screen "
        << up(layout.bottom) << '\n';
    if (!layout.has_words) {
        out << "unset key\nunset xlabel\nunset ylabel\n";
        return;
    }
    out << "set key at screen " << across(layout.right + 15) << ", screen " << up(layout.top)
        << " left top Left reverse samplen 2.5 noenhanced textcolor rgb ink\n";
    for (const auto& [name, axis] : {std::pair("x", &figure.x), {"y", &figure.y}})
        out << "set " << name << "label " << string_literal(axis->label) << " noenhanced textcolor rgb ink\n";
}

void write_frame(std::ostream& out, const Figure& figure) {
    const Frame frame = frame_of(figure);
    out << "ink = " << string_literal(ink)
        << "\nset encoding utf8\nset datafile separator comma\nset datafile commentschars ''\n"
        << "set border 3 linecolor rgb ink\nset tics nomirror textcolor rgb ink\n"
        << "set grid linecolor rgb '#909090' linewidth 0.4 dashtype 1\n";
    write_axis(out, 'x', figure.x, frame.x);
    write_axis(out, 'y', figure.y, frame.y);
    for (const Mark& mark : figure.marks)
        if (mark.shaded)
            out << "set object rectangle from " << number_text(mark.x)
                << ", graph 0 to graph 1, graph 1 behind "
                << "fillcolor rgb " << string_literal(mark.colour) << " fillstyle solid 0.15 noborder\n";
    for (const Mark& mark : figure.marks)
        out << "set arrow from " << number_text(mark.x) << ", graph 0 to " << number_text(mark.x)
            << ", graph 1 nohead dashtype 3 linewidth 2 linecolor rgb " << string_literal(mark.colour)
            << "\nset label " << string_literal(mark.says) << " at " << number_text(mark.x)
            << ", graph 0.61 rotate by -90 offset 1.2,0 center noenhanced font ',11' textcolor rgb "
            << string_literal(mark.colour) << '\n';
}

/// The plot elements that show one series, whose rows in the CSV file begin with number `row`.
std::vector<std::string> elements_of(const Series& series, std::size_t row) {
    const auto failed = static_cast<std::size_t>(
        std::ranges::count_if(series.points, [](const Point& p) { return std::isinf(p.y); }));
    const std::size_t good = series.points.size() - failed;
    const std::string look = " linecolor rgb " + string_literal(series.colour);
    const auto rows = [](std::size_t from, std::size_t count) {
        return "csv skip 1 every ::" + std::to_string(from) + "::" + std::to_string(from + count - 1) +
               " using (at_x($2)):(at_y($3))";
    };
    const auto labels = [&](std::size_t from, std::size_t count, int marker, double size) {
        return rows(from, count) + ":(sprintf('%d', $0 + " + std::to_string(from) +
               ")) with labels hypertext point pointtype " + std::to_string(marker) + " pointsize " +
               number_text(size) + look + " notitle";
    };
    const std::string line = " dashtype " + std::to_string(series.dash) + " linewidth 2";
    const std::string marker =
        " pointtype " + std::to_string(series.marker) + " pointsize " + number_text(series.size);
    std::vector<std::string> elements;
    if (good > 0 && series.joined)
        elements.push_back(rows(row, good) + " with lines" + line + look + " notitle");
    if (good > 0) elements.push_back(labels(row, good, series.marker, series.size));
    if (failed > 0) elements.push_back(labels(row + good, failed, 2, 1.2));
    elements.push_back("NaN with " + (series.joined ? "linespoints" + line : std::string("points")) + marker +
                       look + " title " + string_literal(series.name));
    return elements;
}

/// Of which series each element of the plot is.
std::vector<std::size_t> series_of_elements(const Figure& figure) {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < figure.series.size(); ++i)
        all.insert(all.end(), elements_of(figure.series[i], 0).size(), i);
    return all;
}

[[noreturn]] void fail_to_draw(const fs::path& script, std::string why) {
    std::ranges::replace(why, '\n', ' ');
    throw Failure("gnuplot cannot draw " + script.string() + ": " + why);
}

/// The last chunk of every PNG file: no bytes of data, its name, its checksum (ISO/IEC 15948, 11.2.5).
constexpr std::string_view png_end("\0\0\0\0IEND\xae\x42\x60\x82", 12);

/// The bytes of what gnuplot has drawn, all of them.
std::string picture(const fs::path& file, std::string_view end, const fs::path& script) {
    std::string bytes;
    try {
        bytes = read_file(file);
    } catch (const InputError& error) {
        fail_to_draw(script, error.what());
    }
    const std::string_view drawn(bytes.data(), bytes.find_last_not_of('\n') + 1);
    if (!drawn.ends_with(end)) fail_to_draw(script, "its picture has no end");
    return bytes;
}

/// Names of things need room, and each of them a line.
Layout with_room(const Layout& layout, const Axis& y, double name_px) {
    if (y.things.empty()) return layout;
    constexpr double line = 26;  // px
    Layout roomy = layout;
    std::size_t longest = 0;
    for (const std::string& name : y.things) longest = std::max(longest, name.size());
    roomy.left = 15 + name_px * static_cast<double>(longest);
    roomy.bottom = layout.top + line * (static_cast<double>(y.things.size()) + 1);
    roomy.height = roomy.bottom + layout.height - layout.bottom;
    return roomy;
}

}  // namespace

Layout file_layout(const Figure& figure) {
    Layout layout = with_room({900, 460, 90, 590, 20, 390, true}, figure.y, 7);
    layout.height = std::max(layout.height, 20. * static_cast<double>(figure.series.size() + 2));
    return layout;
}

Layout page_layout(const Figure& figure) {
    return with_room({560, 390, 58, 548, 12, 352, false}, figure.y, 8.6);
}

std::string script_of(const Figure& figure, const std::string& csv) {
    require_plain_id(figure);
    TextStream out;
    out << "# Run in this folder by: gnuplot -d " << figure.id << ".gp\n"
        << "csv = " << string_literal(csv) << '\n';
    for (const char* picture : {"svg", "png"})
        out << "if (!exists('" << picture << "')) " << picture << " = "
            << string_literal(figure.id + "." + picture) << '\n';
    write_frame(out, figure);
    std::string plot = "plot ";
    std::size_t row = 0;
    for (const Series& series : figure.series) {
        for (const std::string& element : elements_of(series, row))
            plot += (plot == "plot " ? "" : ", \\\n     ") + element;
        row += series.points.size();
    }
    const Layout file = file_layout(figure), page = page_layout(figure);
    const auto size = [](const Layout& layout, double scale) {
        return number_text(scale * layout.width) + "," + number_text(scale * layout.height);
    };
    const auto svg = [&](const Layout& layout, const char* font) {
        return "set terminal svg size " + size(layout, 1) + " font 'sans-serif," + font + "' name " +
               string_literal(svg_name(figure)) + "\n";
    };
    write_layout(out, figure, file);
    out << svg(file, "14") << "set output svg\n"
        << plot << '\n'
        << "set terminal pngcairo size " << size(file, 2)
        << " fontscale 1.9 linewidth 2 pointscale 2 font 'DejaVu Sans,11'\n"
        << "set output png\nreplot\nunset output\nif (!exists('page')) exit\n";
    write_layout(out, figure, page);
    out << svg(page, "17") << "set output page\nreplot\nunset output\n";
    return out.str();
}

std::string draw(const Figure& figure, const fs::path& csv, const fs::path& pictures) {
    require_plain_id(figure);
    const fs::path script = pictures / (figure.id + ".gp");
    const fs::path svg = pictures / (figure.id + ".svg"), png = pictures / (figure.id + ".png");
    write_whole_file(script, script_of(figure, fs::relative(csv, pictures).string()));
    // gnuplot is no judge of whether what it wrote arrived, so it does not write into their places. Nor into
    // other files there: one that is killed while it opens a file may still create it much later.
    const MemoryFile drawn_svg, drawn_png, drawn_page;
    const auto name = [](const MemoryFile& file) { return string_literal(file.path().string()); };
    Finished done = run_program(
        {"gnuplot", "-d", "-e",
         "svg = " + name(drawn_svg) + "; png = " + name(drawn_png) + "; page = " + name(drawn_page),
         figure.id + ".gp"},
        pictures);
    std::ranges::replace(done.said, '\n', ' ');
    if (done.code != 0)
        fail_to_draw(script, done.said.empty() ? "exit code " + std::to_string(done.code) : done.said);
    const std::vector<std::size_t> elements = series_of_elements(figure);
    write_whole_file(svg, inline_svg(picture(drawn_svg.path(), "</svg>", script), figure, elements));
    write_whole_file(png, picture(drawn_png.path(), png_end, script));
    return inline_svg(picture(drawn_page.path(), "</svg>", script), figure, elements);
}

std::string gnuplot_version() {
    try {
        const Finished done = run_program({"gnuplot", "--version"});
        if (done.code == 0) return done.said.substr(0, done.said.find('\n'));
    } catch (const Failure&) {  // said below, with what helps
    }
    throw Failure("gnuplot cannot be run, and it draws the figures; on Debian install gnuplot-nox");
}

}  // namespace flipside::lab::report
