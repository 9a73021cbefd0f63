// Pictures of what methods cost and how true they are, on ImGui's draw list. Time runs along the same logarithmic axis
// in both, so that they may stand under each other. Window's thread.
#pragma once

#include <string>

#include "app/ui/scene/method_watch.h"

namespace moltact {

/// Tick times by decades, with the median as the reading; recorded as `name`. `record` may be null: nothing measured
/// yet.
void tickHistogram(const char* name, const MethodRecord* record, float height);

/// A mark for each method tried, time against error, both logarithmic; the one in use stands out. Recorded as `name`,
/// and each mark as name/<method>.
void speedAccuracyChart(const char* name, const MethodWatch& watch, const std::string& in_use, float height);

}  // namespace moltact
