// What is told to an extension of the window (a recorder, sound, a watcher of files) while the program runs. Each is
// one class in its own file and one member of Extensions (app/ui/extensions/extensions.h), and overrides the points
// that it needs. Panels reach it through app.extensions(). Window's thread.
//
// A frame calls, in this order: beforeTicks, ticks, the panels, afterPanels. lessonChanged, stepChanged and
// sceneChanged come in between, in this order, as soon as the thing has happened.
#pragma once

#include "app/ui/scene/touch_scene.h"

namespace moltact {

class Application;

class Extension {
 public:
  virtual ~Extension() = default;

  /// A frame begins; what the hand felt since the last one has not been taken up.
  virtual void beforeTicks(Application&) {}
  /// Every tick since the last frame, oldest first; not called where there is none.
  virtual void ticks(Application&, const FeltTicks&) {}
  /// Every panel has been drawn, so every click and key of the frame has done its work. The GL context is current.
  virtual void afterPanels(Application&) {}

  /// Another molecule is on the stage, or the same one was placed anew: what was felt before no longer counts.
  virtual void sceneChanged(Application&) {}
  /// Another lesson is open, or the same one was opened or read again.
  virtual void lessonChanged(Application&) {}
  /// The lesson is at another step, or another lesson is at its first.
  virtual void stepChanged(Application&) {}

  /// The program ends; everything else still stands.
  virtual void atEnd(Application&) {}

  /// Whether the next frame would look or sound different because of it: the window then does not sleep.
  virtual bool live() const { return false; }
};

}  // namespace moltact
