// Small pieces of the class page: escaped text, numbers, and charts as SVG that read in black and white (a way of input
// is a pattern as well as a colour). Any thread but the haptic one.
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

/// "1.25", with so many digits after the point; "–" where it is not finite.
std::string number(double value, int digits);
/// "83 %" of a share from 0 to 1.
std::string percent(double share);
/// "12 min", "45 s".
std::string duration(double time_s);

/// The class of a way's fill, "way-mouse".
std::string wayClass(InputWay way);
/// The mark of a way, round a place: disc, square, triangle.
void drawMark(Svg& svg, InputWay way, double x, double y);
/// "mouse 80 %, keyboard 20 %", the largest first; "–" without touch.
std::string waysText(const PersonScore& person);

/// One value and what it was made with.
struct Measured {
  double value = 0.0;
  InputWay by = InputWay::Mouse;
};

/// A histogram of about eight bars of even width, each split by the way of input, with its median.
std::string histogram(const std::string& title, const std::string& unit, std::vector<Measured> values);

/// Every value as a mark on a line from 0 to `most`, the middle half as a box, the median as a bar.
std::string strip(const std::vector<Measured>& values, double most);
/// The scale under a column of strips.
std::string stripScale(double most, const std::string& unit);
/// The end of a scale that shows every value: a round number not below any.
double roundAbove(double value);

/// A force curve as it was drawn before it was felt, and as it was felt where that is known.
std::string curves(const std::string& title, const CurveKept& drawn, const CurveKept* felt);

/// A bar filled from 0 to 1; `right` is a full fill, else hatched.
std::string bar(double share, bool right);

/// Patterns that the fills refer to, once a page; and the page's style sheet.
std::string patterns();
std::string_view styleSheet();

struct Column {
  std::string title;  ///< may hold <br>
  bool left = false;
};
/// The start of a table, to its body.
std::string tableHead(std::initializer_list<Column> columns);
/// A heading and the start of a table below it; it ends by "</tbody></table></div>".
std::string section(const char* heading, std::initializer_list<Column> columns);

}  // namespace moltact::page
