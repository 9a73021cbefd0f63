// The methods for a rigid body in the hand that the bench compares: the program's own interactions and those that are
// only measured. A new one needs its own files and a row in body_methods.cpp. Any thread. Units: angstrom.
#pragma once

#include <memory>
#include <span>
#include <string_view>

#include "engine/haptics/body/held_body.h"
#include "engine/haptics/interaction.h"
#include "engine/haptics/sphere_grid.h"

namespace moltact {
class BodyPathObserver;
}

namespace moltact::bench {

/// A body's interaction, of which the energy of the springs is watched too. Slower than the interaction alone.
class BodyUnderTest {
 public:
  virtual ~BodyUnderTest() = default;
  virtual Interaction& interaction() noexcept = 0;
  /// Performs one tick. `made_A2` becomes the energy made by the tick, divided by the stiffness. It is the energy that
  /// the springs store for this hand after the tick, less that for the same hand with the state before the tick. A
  /// passive method makes none: at most 0.
  virtual Response tick(const PoseA& hand, double& made_A2) = 0;
  /// Reports the body's steps between ticks from now on. False if the method takes none: its poses alone are known.
  virtual bool observe(BodyPathObserver*) { return false; }
};

struct BodyMethod {
  std::string_view name;      ///< as in `--methods exact-body`
  std::string_view sentence;  ///< in English, like all of the bench
  std::unique_ptr<Interaction> (*make)(std::shared_ptr<const SphereGrid> scene, std::shared_ptr<const HeldBody> body);
  std::unique_ptr<BodyUnderTest> (*test)(std::shared_ptr<const SphereGrid> scene, std::shared_ptr<const HeldBody> body);
  bool reference = false;  ///< the method against which the others are measured; exactly one
};

/// All methods, the reference first.
std::span<const BodyMethod> bodyMethods();

/// Finds a method by name; nullptr if there is none.
const BodyMethod* findBodyMethod(std::string_view name);

}  // namespace moltact::bench
