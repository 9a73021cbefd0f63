// The edges between the panels and the view, as the widgets' map names them while they are there.
#pragma once

namespace moltact {

inline constexpr const char* kLessonEdge = "splitter/lesson";
inline constexpr const char* kTouchEdge = "splitter/touch";
inline constexpr const char* kEdgeBelow = "splitter/below";  ///< of a tall window
inline constexpr const char* kPanelEdges[] = {kLessonEdge, kTouchEdge, kEdgeBelow};

}  // namespace moltact
