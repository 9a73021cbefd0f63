#include "app/ui/scene/hand_recording.h"

namespace moltact {

bool HandRecording::begin() {
  if (!felt_.stage() || !felt_.ownHand() || felt_.recorded.on()) return false;
  felt_.letGo();
  ++felt_.settings.discontinuities;
  felt_.servo.loop().setSettings(felt_.settingsOfScene());
  felt_.servo.record(true);
  felt_.servo.setInteraction(felt_.freshInteraction());
  return true;
}

void HandRecording::lead(const ServoSettings& recorded) {
  if (felt_.recorded.lead(recorded, felt_.settings, camera_)) ++felt_.settings.discontinuities;
}

void HandRecording::endLead() {
  if (felt_.recorded.end(felt_.settings)) view_.fitDevice();
  ++felt_.settings.discontinuities;
}

}  // namespace moltact
