// The names in the widget map of the edges between the panels and the view.
#pragma once

namespace moltact {

inline constexpr const char* kLessonEdge = "splitter/lesson";
inline constexpr const char* kTouchEdge = "splitter/touch";
inline constexpr const char* kEdgeBelow = "splitter/below";  ///< in a tall window
inline constexpr const char* kPanelEdges[] = {kLessonEdge, kTouchEdge, kEdgeBelow};

}  // namespace moltact
