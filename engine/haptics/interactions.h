// What there is to feel a scene with. An interaction is added with its own files and one line in interactions.cpp.
// Window's thread; making one may allocate. Units: angstrom.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "engine/haptics/methods.h"

namespace moltact {

/// What an interaction is made from.
struct InteractionScene {
  std::shared_ptr<const BallScene> balls;
  const Method* method;  ///< how a sphere is kept outside the balls
  double probe_A = kWaterProbe_A;
};

struct InteractionKind {
  std::string_view name;      ///< "probe"
  std::string_view sentence;  ///< what it is
  std::unique_ptr<Interaction> (*make)(const InteractionScene& scene);
};

/// All, the one that a scene has unless it chooses another first.
std::span<const InteractionKind> interactionKinds();

}  // namespace moltact
