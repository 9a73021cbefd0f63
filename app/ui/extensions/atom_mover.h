// What moves the atoms of the open scene: one interface for the two structures of a scene (`then`), an elastic network, a
// trajectory, a simulation. Attempts record where a mover's atoms are in its own parameter (AtomsMoved), and a playback
// has the mover restore them from it. Window's thread.
//
// A new mover is a class that derives from AtomMover, its section of the tab Motion, and one row of MOLTACT_ATOM_MOVERS
// (atom_movers.h). It
// receives every event of an Extension, and moves the atoms by HapticSession::moveAtoms or placeAtoms with `own_`, after
// own_.claim(). What the hand does to the atoms comes from ServoLoop::takeImpulses.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "app/ui/application/extension.h"
#include "engine/results/attempt.h"

namespace moltact {

struct ApplicationOptions;
class AtomMovers;
class LessonGuide;
class Messages;

/// The application's parts that a mover uses.
struct MoverParts {
  HapticSession& scene;
  LessonGuide& lesson;
  Messages& messages;
  const ApplicationOptions& options;
  AtomMovers* movers = nullptr;  ///< all movers; AtomMovers sets it
};

class AtomMover : public Extension {
 public:
  explicit AtomMover(const MoverParts& parts)
      : scene_(parts.scene),
        lesson_(parts.lesson),
        messages_(parts.messages),
        options_(parts.options),
        movers_(parts.movers),
        own_(parts.scene.atoms().owner, MotionRank::Scene) {}

  /// The word for it in attempts (AtomsMoved::by), the same in all versions. No other mover has it.
  virtual std::string_view kind() const = 0;
  /// The present position of the atoms; empty if it does not move those of the open scene. `by` is filled in by
  /// AtomMovers. Files of later versions of the mover must keep the meaning of the members.
  virtual std::optional<AtomsMoved> position() const = 0;
  /// Whether the atoms are on the way. Positions on the way are recorded at most five times a second, the last one in
  /// any case.
  virtual bool moving() const = 0;
  /// For a playback: moves the atoms at once to a recorded position, in this or a later call, if it is not there yet.
  /// It is called in each frame. `file` is the file named by the position, found on this computer, with the reading
  /// options of the current molecule. Its path is empty if the position names none. `source` moves the atoms and owns
  /// them until it is released. A position out of range is clamped.
  virtual void show(const MotionSource& source, const AtomsMoved& position, const MoleculeKey& file) = 0;

  /// Why the user cannot start it in the open scene, as a sentence; empty if nothing prevents it. Here: the scene's two
  /// structures. An override asks this one first.
  virtual std::string unavailable() const;
  /// Starts it at the user's request, after the motions of all other movers have ended. Returns false and does nothing
  /// while it is unavailable.
  bool start();
  /// Ends its motion, at the user's request or because the user has started another mover; the atoms return to their
  /// places. Does nothing if it is not on.
  virtual void end() {}

  /// Whether it owns the atoms (app/ui/scene/motion_owner.h).
  bool owns() const { return own_.owns(); }

 protected:
  /// Begins the motion for start(). Does nothing if it is on.
  virtual void onStart() {}

  HapticSession& scene_;
  LessonGuide& lesson_;
  Messages& messages_;
  const ApplicationOptions& options_;
  AtomMovers* const movers_;  // null in a test of one mover
  MotionSource own_;
};

}  // namespace moltact
