#include "engine/haptics/interactions.h"

#include <array>

#include "engine/language/catalogue.h"

namespace moltact {
namespace {

std::unique_ptr<Interaction> makeProbe(const InteractionScene& scene) {
  return scene.method->make(scene.balls, scene.probe_A);
}

constexpr std::array kKinds{
    InteractionKind{"probe", N_("a sphere at the hand, which a haptic method keeps outside every atom"), &makeProbe},
};

}  // namespace

std::span<const InteractionKind> interactionKinds() { return kKinds; }

}  // namespace moltact
