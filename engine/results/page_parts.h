// Building blocks of the class page: escaped text, numbers, and SVG charts that are readable in black and white (a way
// of input has a pattern and a colour). Any thread but the haptic one.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/markup.h"
#include "engine/core/quantile.h"
#include "engine/core/svg.h"
#include "engine/results/class_summary.h"

namespace moltact::page {

/// "1.25", with `digits` digits after the point; "–" if it is not finite.
std::string number(double value, int digits);
/// "83 %" for a share from 0 to 1.
std::string percent(double share);
/// "12 min", "45 s".
std::string duration(double time_s);

/// The CSS class of the fill for a way of input, "way-mouse".
std::string inputClass(InputKind input);
/// Draws the mark of a way of input around a place: disc, square or triangle.
void drawMark(Svg& svg, InputKind input, double x, double y);
/// "mouse 80 %, keyboard 20 %", in descending order; "–" without touch.
std::string inputsText(const PersonScore& person);

/// A value and the way of input by which it was measured.
struct Measured {
  double value = 0.0;
  InputKind by = InputKind::Mouse;
};

/// A histogram of about eight bars of equal width, each divided by the way of input, with the median.
std::string histogram(const std::string& title, const std::string& unit, std::vector<Measured> values);

/// Draws each value as a mark on a line from 0 to `max`, the interquartile range as a box and the median as a bar.
std::string strip(const std::vector<Measured>& values, double max);
/// The scale below a column of strips.
std::string stripScale(double max, const std::string& unit);
/// A round number that is not less than the value, for the end of a scale.
double roundAbove(double value);

/// The drawn force curve and the felt one; either may be null, not both.
std::string curves(const std::string& title, const CurveKept* drawn, const CurveKept* felt);

/// A bar filled from 0 to 1; `right` is a solid fill, otherwise hatched.
std::string bar(double share, bool right);

/// The patterns of the fills, needed once per page; and the page's style sheet.
std::string patterns();
std::string_view styleSheet();

struct Column {
  std::string title;  ///< may contain <br>
  bool left = false;
};
/// The start of a table, up to the beginning of its body.
std::string tableHead(std::initializer_list<Column> columns);
/// A heading and the start of a table, which "</tbody></table></div>" must close.
std::string section(const char* heading, std::initializer_list<Column> columns);

}  // namespace moltact::page
