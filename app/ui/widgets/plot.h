// A live plot of the last values of a buffer, on ImGui's draw list. Window's thread.
#pragma once

#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/plot_buffer.h"

namespace moltact {

struct PlotLook {
  const char* title = "";
  float least_top = 1.0f;  ///< the scale's upper end is at least this
  float height = 86.0f;    ///< unit: pixel at 96 dpi
  double span_s = 5.0;     ///< from the oldest value to the newest
  ShownAs shown_as{};      ///< the newest value
};

/// As wide as there is room, recorded as `name` with the newest value as its text.
void plot(const char* name, const PlotBuffer& buffer, double newest, const PlotLook& how);

}  // namespace moltact
