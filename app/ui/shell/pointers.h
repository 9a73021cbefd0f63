// What points in a window that may have a touch screen: a mouse, or fingers, by the rules of app/ui/widgets/fingers.h. The
// desktop's window and the page's tell it what they hear. Window's thread. Units: pixel of the framebuffer, second.
#pragma once

#include "app/ui/widgets/fingers.h"

namespace moltact {

class Application;

/// What lies there: the molecule's picture, a pad in it, a panel's edge, and no page or menu over it.
Fingers::On fingerOn(const Application& app, glm::dvec2 place_px);

class Pointers {
 public:
  /// Outlived by both.
  Pointers(Application& app, InputQueue& to) : app_(app), to_(to), fingers_(to) {}

  /// From here on a mouse is what points, until the next finger.
  void mouse(glm::dvec2 place_px);
  void fingerDown(int id, glm::dvec2 place_px, double now_s);
  void fingerMove(int id, glm::dvec2 place_px) { fingers_.move(id, place_px); }
  void fingerUp(int id) { fingers_.up(id); }
  /// Once a frame.
  void advance(double now_s) { fingers_.advance(now_s); }
  bool anyFinger() const { return fingers_.any(); }

 private:
  Application& app_;
  InputQueue& to_;
  Fingers fingers_;
};

}  // namespace moltact
