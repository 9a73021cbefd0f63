// The events of the window that an extension (a recorder, sound, a watcher of files) receives while the program runs.
// Each extension is one class in its own file and one member of Extensions (app/ui/extensions/extensions.h). It is made
// with the parts of the application that it uses (the scene, the settings, …) and the other extensions that it uses, and
// overrides the points that it needs. Panels reach it through app.extensions(). Window's thread.
//
// A frame calls, in this order: beforeTicks, ticks, the panels, lessonEvents, afterPanels. lessonChanged, stepChanged and
// sceneChanged come in between, in this order, as soon as the thing has happened.
#pragma once

#include <filesystem>
#include <span>

#include "app/ui/files/file_kinds.h"
#include "app/ui/scene/haptic_session.h"
#include "engine/lesson/session_events.h"

namespace moltact {

/// The window's clock for the current frame (unit: second).
struct FrameTime {
  double dt_s = 0.0;   ///< since the previous frame
  double now_s = 0.0;  ///< since the program began
};

class Extension {
 public:
  virtual ~Extension() = default;

  /// Called at the start of the program: the settings have been read, nothing has been opened.
  virtual void atStart() {}

  /// Called at the beginning of a frame, before the ticks since the last one are taken from the loop.
  virtual void beforeTicks() {}
  /// Called with every tick since the last frame, oldest first; not called without ticks.
  virtual void ticks(const FeltTicks&) {}
  /// Called with the events of the lesson's session since the last frame, oldest first, after the panels and before
  /// afterPanels; not called without events.
  virtual void lessonEvents(std::span<const SessionEvent>) {}
  /// Called after all panels, when every click and key of the frame has taken effect. The GL context is current.
  virtual void afterPanels() {}

  /// Called on all extensions before one of them opens a file of this kind.
  virtual void beforeOpening(FileKind) {}
  /// Opens the file if its kind belongs to this extension. Returns true if it does, whatever the result.
  virtual bool open(FileKind, const std::filesystem::path&) { return false; }
  /// Called if a lesson could not be read.
  virtual void lessonRefused(const std::filesystem::path&) {}

  /// Called if another molecule is on the stage, or the same one was repositioned: earlier contacts are invalid.
  virtual void sceneChanged() {}
  /// Called if another lesson was opened, or the same one was opened or read again.
  virtual void lessonChanged() {}
  /// Called if the lesson has entered another step, or another lesson its first one.
  virtual void stepChanged() {}
  /// Called if the user restored the scene's initial view; `seen` is the camera until then.
  virtual void viewReset(const Camera& /*seen*/) {}

  /// Called at the end of the program, while all other parts still exist.
  virtual void atEnd() {}

  /// Whether the next frame differs without further input because of it; the window then does not sleep.
  virtual bool live() const { return false; }
  /// Whether it leads the hand; contacts are then not passed to tasks.
  virtual bool leadsHand() const { return false; }
  /// Whether it replaces the lesson's panel, which is then closed.
  virtual bool hidesLesson() const { return false; }
};

/// All extensions of a program, as seen by the application.
class ExtensionSet {
 public:
  virtual ~ExtensionSet() = default;

  /// In the order of the calls, which is the same in every frame.
  virtual std::span<Extension* const> all() const = 0;
  /// Height of the strip under the view (unit: pixel at 96 dpi); 0 without one.
  virtual float stripHeight() const = 0;
};

}  // namespace moltact
