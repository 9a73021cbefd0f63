// Draws charts with two logarithmic axes as SVG. Series differ by the shape of their marks, in black and grey, so that
// the chart is readable in black and white and by people with colour vision deficiency. Labels beside the points do not
// overlap. The font is the default sans-serif; nothing is loaded. A gap of more than three decades in y is shortened
// and marked.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace moltact::bench {

enum class Mark { Disc, Circle, Square, Triangle, Diamond, Cross };
inline constexpr std::size_t kMarkCount = 6;

/// The mark of the series number `index`, from 0. From kMarkCount on the marks repeat.
constexpr Mark markAt(std::size_t index) {
  constexpr Mark kOrder[kMarkCount]{Mark::Diamond, Mark::Disc, Mark::Triangle, Mark::Square, Mark::Cross, Mark::Circle};
  return kOrder[index % kMarkCount];
}

struct ChartPoint {
  double x = 0, y = 0;  ///< positive; other points are omitted
  std::string label;    ///< drawn beside the mark; may be empty
};

struct ChartSeries {
  std::string name;  ///< in the legend; empty: no entry
  Mark mark = Mark::Disc;
  bool joined = false;  ///< connect the points by lines
  bool dashed = false;
  bool marked = true;  ///< draw the marks
  std::vector<ChartPoint> points;
};

struct ChartPanel {
  std::string title, x_axis, y_axis;
  std::vector<ChartSeries> series;
};

/// Draws the panels in two columns under a title, with a common legend and a note below.
std::string chartSvg(const std::string& title, const std::vector<ChartPanel>& panels, const std::string& note);

}  // namespace moltact::bench
