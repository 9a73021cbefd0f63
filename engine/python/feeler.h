// What feels a scene from Python: an interaction, and arrays of its responses. Units: angstrom, newton.
#pragma once

#include <pybind11/numpy.h>

#include <memory>
#include <mutex>

#include "engine/haptics/interactions.h"

namespace moltact::python {

/// The responses to n poses, one row each (engine/python/moltact/__init__.pyi describes the columns).
struct Felt {
  pybind11::array_t<double> positions, orientations, forces, torques, energies;
  PerEnergyPart<pybind11::array_t<double>> parts;  // kcal/mol
  pybind11::array_t<bool> touching, at_rest, started_inside;
  pybind11::array_t<std::int32_t> contacts;
};

class Feeler {
 public:
  /// Raises ValueError for an unknown method or interaction, a missing body or chemistry, and numbers out of range.
  Feeler(InteractionInput input, double stiffness_N_per_A);

  /// Moves the hand through the poses. Other Python threads run meanwhile; a second call on this object waits. Ctrl-C
  /// ends it.
  Felt feel(const pybind11::object& poses);
  void reset();
  const InteractionInput& input() const { return input_; }
  double stiffness_N_per_A() const { return stiffness_N_per_A_; }

 private:
  InteractionInput input_;
  double stiffness_N_per_A_;
  std::unique_ptr<Interaction> felt_;
  std::mutex in_use_;
};

}  // namespace moltact::python
