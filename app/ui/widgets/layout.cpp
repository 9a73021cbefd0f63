#include "app/ui/widgets/layout.h"

#include <algorithm>
#include <cmath>

namespace moltact {
namespace {
constexpr float kMinView = 380.0f;        // at 96 dpi, between two panels
constexpr float kMinViewNarrow = 200.0f;  // beside one panel
constexpr float kMinPanel = 220.0f;
}  // namespace

Layout layOut(const LayoutWish& w, bool lesson_first) {
  Layout out;
  const float s = w.scale;
  const float menu = std::round(kMenuHeight * s), status = std::round(kStatusHeight * s);
  const float top = menu, bottom = std::max(top, w.window.y - status);
  float left = std::round(w.lesson_width * s), right = std::round(w.touch_width * s);
  const float width = w.window.x;

  out.narrow = width < left + right + kMinView * s;
  if (out.narrow && width >= (2 * kMinPanel + kMinView + 60.0f) * s) {
    // The wanted widths do not fit, but narrower panels do.
    const float give = std::min(1.0f, (width - kMinView * s) / (left + right));
    left = std::max(kMinPanel * s, std::floor(left * give));
    right = std::max(kMinPanel * s, std::floor(right * give));
    out.narrow = false;
  }
  bool lesson = w.lesson, touch = w.touch;
  if (out.narrow) {
    if (lesson && touch) (lesson_first ? touch : lesson) = false;
    out.tall = w.window.y > w.window.x;
    const float most = std::max(0.42f * width, std::min(width - kMinViewNarrow * s, 0.6f * width));
    left = std::min(left, std::round(most));
    right = std::min(right, std::round(most));
  }
  if (!lesson) left = 0;
  if (!touch) right = 0;
  out.menu = {{0, 0}, {width, menu}};
  out.status = {{0, bottom}, {width, w.window.y}};
  if (w.page) {
    out.page = {{0, top}, {width, bottom}};
    return out;
  }
  const float strip = std::min(std::round(w.strip_height * s), 0.5f * (bottom - top));
  if (out.tall) {
    const float below = lesson || touch ? std::round(w.below_share * (bottom - top)) : 0.0f, edge = bottom - below;
    const float under = std::min(strip, 0.5f * (edge - top));
    out.view = {{0, top}, {width, edge - under}};
    out.strip = {{0, edge - under}, {width, edge}};
    if (lesson) out.lesson = {{0, edge}, {width, bottom}};
    if (touch) out.touch = {{0, edge}, {width, bottom}};
    return out;
  }
  out.lesson = {{0, top}, {left, bottom}};
  out.touch = {{width - right, top}, {width, bottom}};
  out.view = {{left, top}, {width - right, bottom - strip}};
  out.strip = {{left, bottom - strip}, {width - right, bottom}};
  return out;
}

}  // namespace moltact
