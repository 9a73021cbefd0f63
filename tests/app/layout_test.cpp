// The places of the panels, by arithmetic alone.
#include "app/ui/widgets/layout.h"

#include <doctest/doctest.h>

#include <initializer_list>

namespace moltact {
namespace {

float area(const Rectangle& r) { return r.empty() ? 0.0f : r.size().x * r.size().y; }

const glm::vec2 kWindows[] = {{390, 844}, {844, 390}, {800, 1280}, {1280, 800}, {960, 600}, {320, 480}, {2560, 1440}};

}  // namespace

TEST_CASE(
    "a window of 1280 by 800 has the lesson left of the view and the touch panel right of it, over its whole height") {
  const Layout l = layOut({.window = {1280, 800}}, true);
  CHECK_FALSE(l.narrow);
  CHECK_FALSE(l.tall);
  CHECK(l.lesson.low == glm::vec2(0, 36));
  CHECK(l.lesson.high == glm::vec2(350, 768));
  CHECK(l.view.low == glm::vec2(350, 36));
  CHECK(l.view.high == glm::vec2(1280 - 288, 768));
  CHECK(l.touch.high == glm::vec2(1280, 768));
}

TEST_CASE("a telephone of 390 by 844 has one panel, over the whole width, below the view; on its side, left of it") {
  const Layout upright = layOut({.window = {390, 844}}, true);
  CHECK(upright.tall);
  CHECK(upright.touch.empty());
  CHECK(upright.view.low == glm::vec2(0, 36));
  CHECK(upright.view.high.x == 390);
  CHECK(upright.lesson.low == glm::vec2(0, upright.view.high.y));
  CHECK(upright.lesson.high == glm::vec2(390, 812));
  // 46 of 100 of the 776 between menu and status.
  CHECK(upright.lesson.size().y == 357.0f);
  CHECK(layOut({.window = {390, 844}}, false).touch.low == upright.lesson.low);

  const Layout side = layOut({.window = {844, 390}}, true);
  CHECK_FALSE(side.tall);
  CHECK(side.lesson.low.x == 0.0f);
  CHECK(side.view.low.x == side.lesson.high.x);
  CHECK(side.view.high.x == 844.0f);
}

TEST_CASE("menu, panels, view, strip and status cover every window once, wherever the panels stand") {
  for (const glm::vec2 window : kWindows)
    for (const float scale : {1.0f, 1.5f, 2.0f})
      for (const float strip : {0.0f, 64.0f})
        for (const bool lesson : {true, false})
          for (const bool touch : {true, false})
            for (const float share : {0.2f, 0.46f, 0.8f}) {
              CAPTURE(window.x);
              CAPTURE(window.y);
              CAPTURE(scale);
              const Layout l = layOut({.window = window,
                                       .scale = scale,
                                       .lesson = lesson,
                                       .touch = touch,
                                       .strip_height = strip,
                                       .below_share = share},
                                      true);
              const float whole =
                  area(l.menu) + area(l.lesson) + area(l.view) + area(l.touch) + area(l.strip) + area(l.status);
              CHECK(whole == doctest::Approx(window.x * window.y).epsilon(1e-5));
              CHECK(l.view.size().y > 0.0f);
            }
}

}  // namespace moltact
