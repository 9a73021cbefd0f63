// Draws charts with two logarithmic axes as SVG: black and greys, with a mark's shape for its kind, so that they can be
// read in black and white and by the colour-blind; labels beside the points that do not overlap. The text is plain
// sans-serif; nothing is loaded from elsewhere. A gap of more than three decades in y is cut short and marked.
#pragma once

#include <string>
#include <vector>

namespace moltact::bench {

enum class Mark { Disc, Circle, Square, Triangle, Diamond, Cross };

struct ChartPoint {
  double x = 0, y = 0;  ///< above zero; others are left out
  std::string label;    ///< beside the mark; may be empty
};

struct ChartSeries {
  std::string name;  ///< for the legend; empty: not in it
  Mark mark = Mark::Disc;
  bool joined = false;  ///< a line from point to point
  bool dashed = false;
  bool marked = true;  ///< draw the marks
  std::vector<ChartPoint> points;
};

struct ChartPanel {
  std::string title, x_axis, y_axis;
  std::vector<ChartSeries> series;
};

/// The panels side by side under a title, the legend of all below them, and a note.
std::string chartSvg(const std::string& title, const std::vector<ChartPanel>& panels, const std::string& note);

}  // namespace moltact::bench
