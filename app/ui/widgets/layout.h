// Where the panels stand: columns beside the view where there is room, one at a time where there is little, and below the
// view where the window is taller than wide besides.
// Pure arithmetic. Units: pixel of the framebuffer.
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
  float scale = 1.0f;                                 ///< of what holds text
  bool lesson = true, touch = true;                   ///< panels that are wanted
  bool page = false;                                  ///< a page stands in the place of view and panels
  float lesson_width = 350.0f, touch_width = 288.0f;  ///< at 96 dpi
  float strip_height = 0.0f;                          ///< at 96 dpi; 0: no strip
  float below_share = 0.46f;                          ///< of the height, for a panel below the view
};

struct Layout {
  Rectangle menu, lesson, view, touch, page, status;  ///< a panel without room, or not wanted, is empty
  Rectangle strip;                                    ///< under the view: playback, turns
  bool narrow = false;                                ///< only one side panel has room
  bool tall = false;                                  ///< that one stands below the view
};

/// `lesson_first`: which side panel is kept where only one has room.
Layout layOut(const LayoutWish& wish, bool lesson_first);

inline constexpr float kMenuHeight = 36.0f, kStatusHeight = 32.0f;  // at 96 dpi

}  // namespace moltact
