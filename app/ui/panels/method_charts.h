// Charts of the methods' times and errors, on ImGui's draw list. Both have the same logarithmic time axis, so that they
// can be stacked. Window's thread.
#pragma once

#include <string>

#include "app/ui/scene/method_watch.h"

namespace moltact {

/// A histogram of tick times by decades, with the median as its value. Recorded as `name`. `record` null: nothing
/// measured yet.
void tickHistogram(const char* name, const MethodRecord* record, float height);

/// Plots error against time for each method tried, both logarithmic; the method in use is highlighted. Recorded as
/// `name`, each mark as name/<method>.
void speedAccuracyChart(const char* name, const MethodWatch& watch, const std::string& in_use, float height);

}  // namespace moltact
