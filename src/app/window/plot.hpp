#pragma once
/// A plot over time: its box, its round ticks, and curves that stay inside it and do not join what was apart.
/// The shape of a curve knows no screen.

#include <span>
#include <string>
#include <vector>

#include "app/window/canvas.hpp"
#include "app/window/history.hpp"
#include "app/window/layout.hpp"

namespace flipside::app {

/// The runs of samples within `from`…`to` that lie at most `gap` s one after the other and are numbers.
[[nodiscard]] std::vector<std::vector<Sample>> unbroken(std::span<const Sample> samples, double from,
                                                        double to, double gap);
/// Multiples of 1, 2 or 5 times a power of ten within low…high, at most `most` ≥ 2 of them.
[[nodiscard]] std::vector<double> round_ticks(double low, double high, int most);

struct Curve {
    std::string name;
    sf::Color color;
    std::vector<Sample> samples;  ///< by rising time
    std::string unit;
    /// Of a value, as words.
    std::string (*words)(double) = nullptr;
    bool named = false;  ///< its name stands beside its value of now
};

enum class Scale { linear, decades };

struct Plot {
    std::string title, brief;  ///< the brief one where there is little room
    Scale scale = Scale::linear;
    double bottom = 0, top = 1;  ///< of the values
    std::vector<Curve> curves = {};
    std::string note = {};  ///< what happened, beside the values of now
    /// A moment with its name.
    struct Mark {
        double time = 0;
        std::string words;
        sf::Color color;
        bool dot = false;  ///< on the first curve, with the words in the note
    };
    std::vector<Mark> marks = {};
    std::vector<double> impacts = {};  ///< times, ticks at the foot
};

/// What the axis of time spans, s: all that has passed, or the last of it.
struct TimeSpan {
    double from = 0, to = 1;
};
[[nodiscard]] TimeSpan span_until(double now);

/// Whose range holds all of the curves within `from`…`to`, and 0 where it is near.
void fit(Plot& plot, double from, double to);

struct PlotTime {
    double now = 0;  ///< s
    double gap = 0;  ///< s: longer than this apart, samples are not joined
    /// Where the mouse rests, px; no readout outside of the box.
    Vec2 mouse{-1, -1};
};

/// Draws it at `place` with its axes, and a readout where the mouse rests.
void draw_plot(Canvas& canvas, const Rect& place, const Plot& plot, const PlotTime& time);

}  // namespace flipside::app
