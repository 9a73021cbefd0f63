// Begins recordings of the hand, and leads the scene by the conditions of a recorded hand. Window's thread.
#pragma once

#include "app/ui/scene/felt_scene.h"
#include "app/ui/scene/fitted_view.h"

namespace moltact {

class HandRecording {
 public:
  HandRecording(FeltScene& felt, FittedView& view, Camera& camera) : felt_(felt), view_(view), camera_(camera) {}

  /// Starts a recording at a new contact. Returns false if nothing can be felt.
  bool begin();
  /// Applies the conditions of a recording (workspace, probe, surface and clutch) instead of the scene's own.
  void lead(const ServoSettings& recorded);
  /// Restores the scene's own conditions. The clutch is then that of the next device.
  void endLead();

 private:
  FeltScene& felt_;
  FittedView& view_;
  Camera& camera_;
};

}  // namespace moltact
