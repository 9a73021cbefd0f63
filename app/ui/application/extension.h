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

/// The window's clock, as the frame that is drawn has it (unit: second).
struct FrameTime {
  double dt_s = 0.0;   ///< since the frame before
  double now_s = 0.0;  ///< since the program began
};

class Extension {
 public:
  virtual ~Extension() = default;

  /// The program begins: the settings have been read, nothing has been opened.
  virtual void atStart() {}

  /// A frame begins; what the hand felt since the last one has not been taken up.
  virtual void beforeTicks() {}
  /// Every tick since the last frame, oldest first; not called where there is none.
  virtual void ticks(const FeltTicks&) {}
  /// What happened in the lesson's session since the last frame, oldest first; after the panels and before afterPanels,
  /// and not called where there is nothing.
  virtual void lessonEvents(std::span<const SessionEvent>) {}
  /// Every panel has been drawn, so every click and key of the frame has done its work. The GL context is current.
  virtual void afterPanels() {}

  /// A file of this kind is about to be opened; this is called on all extensions before one of them opens it.
  virtual void beforeOpening(FileKind) {}
  /// Opens it where files of this kind are this extension's own: true, whatever comes of it.
  virtual bool open(FileKind, const std::filesystem::path&) { return false; }
  /// A lesson was to be opened and could not be read.
  virtual void lessonRefused(const std::filesystem::path&) {}

  /// Another molecule is on the stage, or the same one was placed again: earlier contacts no longer count.
  virtual void sceneChanged() {}
  /// Another lesson is open, or the same one was opened or read again.
  virtual void lessonChanged() {}
  /// The lesson is at another step, or another lesson is at its first.
  virtual void stepChanged() {}
  /// A person asked for the camera as it was when the scene was opened; `seen` is how it was until now.
  virtual void viewReset(const Camera& /*seen*/) {}

  /// The program ends; everything else still stands.
  virtual void atEnd() {}

  /// Whether the next frame would look or sound different because of it: the window then does not sleep.
  virtual bool live() const { return false; }
  /// Whether it leads the hand: what is felt then is nobody's task.
  virtual bool leadsHand() const { return false; }
  /// Whether it shows something in the lesson's place: the lesson's panel then is closed.
  virtual bool hidesLesson() const { return false; }
};

/// All extensions of a program, as the application knows them.
class ExtensionSet {
 public:
  virtual ~ExtensionSet() = default;

  /// In the order in which they are called; the same in every frame.
  virtual std::span<Extension* const> all() const = 0;
  /// Height of the strip under the view (unit: pixel at 96 dpi); 0 where there is none.
  virtual float stripHeight() const = 0;
};

}  // namespace moltact
