// A scanned surface that the hand touches with a point instead of the scene. Window's thread.
#pragma once

#include <memory>

#include "app/ui/scene/force_control.h"

namespace moltact {

class ScannedSurface {
 public:
  ScannedSurface(FeltScene& felt, ForceControl& force) : felt_(felt), force_(force) {}

  /// Touches this surface until called with null or the scene begins anew. Begins from outside. Does nothing during
  /// playback, while a force is tried and with a body in the hand. `like` are spheres whose surface, inflated by the
  /// probe, is nearly the same; a mouse's hand hovers over them.
  void touch(std::shared_ptr<const HeightField> field, std::shared_ptr<const SphereGrid> like = nullptr);
  /// The touched surface; null: the scene is touched.
  const std::shared_ptr<const HeightField>& field() const { return felt_.scanned; }
  /// The spheres over which a mouse's hand hovers, also while the scene is touched; null without a scene.
  const SphereGrid* underPointer() const {
    return felt_.scanned_like ? felt_.scanned_like.get() : felt_.stage().spheres.get();
  }

 private:
  FeltScene& felt_;
  ForceControl& force_;
};

}  // namespace moltact
