// The pointing device of a window: the mouse or fingers, by the rules of app/ui/widgets/fingers.h. The desktop window
// and the browser page report their events here. Window's thread. Units: pixel of the framebuffer, second.
#pragma once

#include "app/ui/widgets/fingers.h"

namespace moltact {

class Application;

/// What a finger at this place touches: the view, a pad in it, a panel's edge, or a panel. A page or menu above it
/// counts as a panel.
Fingers::Target fingerOn(const Application& app, glm::dvec2 place_px);

class Pointers {
 public:
  /// Both must outlive this object.
  Pointers(Application& app, InputQueue& to) : app_(app), to_(to), fingers_(to) {}

  /// The mouse moves and is the pointing device until the next finger.
  void mouse(glm::dvec2 place_px);
  void fingerDown(int id, glm::dvec2 place_px, double now_s);
  void fingerMove(int id, glm::dvec2 place_px) { fingers_.move(id, place_px); }
  void fingerUp(int id) { fingers_.up(id); }
  /// Called once per frame.
  void advance(double now_s) { fingers_.advance(now_s); }
  bool anyFinger() const { return fingers_.any(); }

 private:
  Application& app_;
  InputQueue& to_;
  Fingers fingers_;
};

}  // namespace moltact
