// Undo and redo of the user's changes to the scene: touch settings, visible parts, magnification, and resets of the
// view. A lesson's step that sets them starts a new history. Window's thread.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/ui/application/extension.h"

namespace moltact {

class SceneChange;

class SceneHistory : public Extension {
 public:
  SceneHistory(SceneChange& change, HapticSession& scene) : scene_(scene), change_(change) {}

  static constexpr std::size_t kMax = 100;  ///< the oldest changes beyond this number are dropped

  bool canUndo() const { return !done_.empty(); }
  bool canRedo() const { return !undone_.empty(); }
  void undo();
  void redo();
  /// Records a change once the mouse button is released, so that a whole drag of a slider is one change.
  void afterPanels() override;
  void sceneChanged() override { begin(); }
  void stepChanged() override { begin(); }
  void viewReset(const Camera& seen) override;

 private:
  HapticSession& scene_;
  SceneChange& change_;  // moves the camera on undo and redo
  struct Choices {
    TouchSetup touch;
    bool magnified = false;
    ViewPartSet shown;
    AtomsLook look;
    ColourBy colour_by = ColourBy::Element;
    /// Colours of one scheme are equal: those that are computed later replace a placeholder (PotentialColours).
    bool operator==(const Choices& other) const;
  };
  struct Change {
    Choices before, after;
    std::optional<Camera> camera_before, camera_after;
  };

  void begin();
  Choices choices() const;
  void apply(const Choices& choices, const std::optional<Camera>& camera);

  std::optional<Choices> current_;                 // nothing: read it from the scene at the end of the frame
  std::optional<std::pair<Camera, Camera>> view_;  // before and after a reset
  std::vector<Change> done_, undone_;
};

}  // namespace moltact
