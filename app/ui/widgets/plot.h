// Draws a live plot of a buffer's newest values on ImGui's draw list. Window's thread.
#pragma once

#include <imgui.h>

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/plot_buffer.h"

namespace moltact {

struct PlotLook {
  const char* title = "";
  float min_top = 1.0f;  ///< lower bound of the scale's upper end
  float height = 86.0f;  ///< unit: pixel at 96 dpi
  double span_s = 5.0;   ///< time from the oldest value to the newest
  ShownAs shown_as{};    ///< format of the newest value
};

/// Draws the plot as wide as there is room. Recorded as `name`, with the newest value as its text.
void plot(const char* name, const PlotBuffer& buffer, double newest, const PlotLook& how);

/// One of several quantities of either sign in a plot.
struct PlotCurve {
  const PlotBuffer* buffer = nullptr;
  std::string title;    ///< of the curve, shown with its newest value in its colour
  std::string reading;  ///< the newest value with its unit
  ImU32 colour = 0;
};

/// Draws curves about a line of zero, with their titles above the plot. `look.min_top` is the least range to either side.
/// Recorded as `name`, with the readings as its text.
void signedPlot(const char* name, std::span<const PlotCurve> curves, const PlotLook& look);

/// A function of one number, drawn over a range, with a point on it.
struct FunctionPlot {
  const char* title = "";
  const char *across = "", *up = "";  ///< of the axes, with their unit
  double from = 0.0, to = 1.0;        ///< range of the argument; the point's argument extends it
  std::optional<double> at;           ///< the argument of the point; empty: no point
  float height = 110.0f;              ///< unit: pixel at 96 dpi
};

/// A series of values, one for each step of the argument, with a point on it.
struct SeriesPlot {
  const char* title = "";
  const char *across = "", *up = "";  ///< of the axes, with their unit
  double first = 0.0, step = 1.0;     ///< argument of the first value, and from one to the next
  double at = 0.0;                    ///< argument of the point
  float height = 110.0f;              ///< unit: pixel at 96 dpi
};

/// Draws the values above zero, and a point between the two at its argument. Recorded as `name`, with the point's value.
void seriesPlot(const char* name, std::span<const float> values, const SeriesPlot& how);

/// Draws the function, and faintly the line where it would equal its argument. Recorded as `name`, with the point's
/// argument and value as its text.
void functionPlot(const char* name, const std::function<double(double)>& function, const FunctionPlot& how);

}  // namespace moltact
