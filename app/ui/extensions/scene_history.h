// Undo and redo of what a person changed about the scene by hand: what it is felt with, parts shown, what was
// magnified, the view that was reset. A step of a lesson that sets them starts a new history. Window's thread.
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

  static constexpr std::size_t kMax = 100;  ///< the oldest changes are forgotten beyond this

  bool canUndo() const { return !done_.empty(); }
  bool canRedo() const { return !undone_.empty(); }
  void undo();
  void redo();
  /// Takes up a change once the mouse rests, so that a slider's whole drag is one.
  void afterPanels() override;
  void sceneChanged() override { begin(); }
  void stepChanged() override { begin(); }
  void viewReset(const Camera& seen) override;

 private:
  HapticSession& scene_;
  SceneChange& change_;  // leads the camera to what is brought back
  struct Choices {
    TouchSetup touch;
    bool magnified = false;
    ViewPartSet shown;
    AtomsLook look;
    ColourBy colour_by = ColourBy::Element;
    friend bool operator==(const Choices&, const Choices&) = default;
  };
  struct Change {
    Choices before, after;
    std::optional<Camera> camera_before, camera_after;
  };

  void begin();
  Choices choices() const;
  void apply(const Choices& choices, const std::optional<Camera>& camera);

  std::optional<Choices> current_;                 // none: what the scene has at the end of the frame
  std::optional<std::pair<Camera, Camera>> view_;  // before and after
  std::vector<Change> done_, undone_;
};

}  // namespace moltact
