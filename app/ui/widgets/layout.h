// Places the panels in the window. With enough room they are columns beside the view; otherwise one panel at a time is
// shown. In a window taller than wide, that panel is below the view. Pure arithmetic. Units: pixel of the framebuffer.
#pragma once

#include <glm/glm.hpp>

namespace moltact {

struct Rectangle {
  glm::vec2 low{0.0f}, high{0.0f};
  glm::vec2 size() const { return high - low; }
  bool empty() const { return high.x <= low.x || high.y <= low.y; }
};

struct LayoutWish {
  glm::vec2 window{1280, 800};
  float scale = 1.0f;                                 ///< of areas that hold text
  bool lesson = true, touch = true;                   ///< panels that should be shown
  bool page = false;                                  ///< a page replaces view and panels
  float lesson_width = 350.0f, touch_width = 288.0f;  ///< at 96 dpi
  float strip_height = 0.0f;                          ///< at 96 dpi; 0: no strip
  float below_share = 0.46f;                          ///< share of the height for a panel below the view
};

struct Layout {
  Rectangle menu, lesson, view, touch, page, status;  ///< a panel that has no room or is not wanted is empty
  Rectangle strip;                                    ///< below the view: playback, turns
  bool narrow = false;                                ///< only one side panel fits
  bool tall = false;                                  ///< the side panel is below the view
};

/// Computes the layout. `lesson_first`: where only one side panel fits, keep the lesson instead of the touch panel.
Layout layOut(const LayoutWish& wish, bool lesson_first);

inline constexpr float kMenuHeight = 36.0f, kStatusHeight = 32.0f;  // at 96 dpi

}  // namespace moltact
