#include "engine/python/feeler.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "engine/haptics/methods.h"
#include "engine/python/arrays.h"

namespace py = pybind11;

namespace moltact::python {
namespace {

constexpr std::size_t kPosesBetweenSignals = 100'000;  // some milliseconds with the slowest method

// The names as "'exact', 'paper'".
template <class Rows>
std::string namesOf(const Rows& rows) {
  std::string out;
  for (const auto& row : rows) out += (out.empty() ? "'" : ", '") + std::string(row.name) + "'";
  return out;
}

// Where the columns of one pose are written. The arrays outlive it, so that no lock of Python is needed.
struct Rows {
  explicit Rows(Felt& felt)
      : positions(felt.positions.mutable_data()),
        orientations(felt.orientations.mutable_data()),
        forces(felt.forces.mutable_data()),
        torques(felt.torques.mutable_data()),
        energies(felt.energies.mutable_data()),
        touching(felt.touching.mutable_data()),
        at_rest(felt.at_rest.mutable_data()),
        started_inside(felt.started_inside.mutable_data()),
        contacts(felt.contacts.mutable_data()) {
    for (std::size_t k = 0; k < kEnergyParts; ++k) parts.values[k] = felt.parts.values[k].mutable_data();
  }

  void write(std::size_t row, const PoseA& shown, const FeltForce& force, const Response& response) {
    for (int axis = 0; axis < 3; ++axis) {
      const std::size_t at = 3 * row + std::size_t(axis);
      positions[at] = shown.place.A[axis];
      forces[at] = force.force_N[axis];
      torques[at] = force.torque_N_A[axis];
      contacts[at] = response.contact.atoms[std::size_t(axis)];
    }
    const Quat& q = shown.orientation;
    const std::array<double, 4> wxyz{q.w, q.x, q.y, q.z};
    std::copy(wxyz.begin(), wxyz.end(), orientations + 4 * row);
    energies[row] = force.energy_N_A;
    const MolecularEnergy energy = response.molecular_energy.value_or(MolecularEnergy{});
    for (std::size_t k = 0; k < kEnergyParts; ++k) parts.values[k][row] = energy.parts.values[k];
    touching[row] = response.contact.touching();
    at_rest[row] = response.at_rest;
    started_inside[row] = response.contact.fault == Fault::StartedInside;
  }

  double *positions, *orientations, *forces, *torques, *energies;
  PerEnergyPart<double*> parts;
  bool *touching, *at_rest, *started_inside;
  std::int32_t* contacts;
};

}  // namespace

Feeler::Feeler(InteractionInput input, double stiffness_N_per_A)
    : input_(std::move(input)), stiffness_N_per_A_(stiffness_N_per_A) {
  if (!(std::isfinite(stiffness_N_per_A) && stiffness_N_per_A > 0.0))
    throw py::value_error("stiffness_N_per_A must be a positive number");
  if (!(input_.touch.probe_A >= 0.0 && input_.touch.probe_A <= kMaxProbe_A))
    throw py::value_error("probe_A must be a number from 0 to 20");
  if (!findMethod(input_.touch.method))
    throw py::value_error("there is no method '" + input_.touch.method + "'; choose from " + namesOf(methods()));
  const InteractionKind* kind = findInteractionKind(input_.touch.interaction);
  if (!kind || kind->holds_body != (input_.body != nullptr)) {
    std::vector<InteractionKind> fitting(interactionKinds().begin(), interactionKinds().end());
    std::erase_if(fitting, [&](const InteractionKind& k) { return k.holds_body != (input_.body != nullptr); });
    throw py::value_error("there is no interaction '" + input_.touch.interaction + "' here; choose from " +
                          namesOf(fitting));
  }
  if (needsChemistry(input_.touch) && !input_.chemistry)
    throw py::value_error("the interaction '" + input_.touch.interaction +
                          "' needs the atoms' chemistry; give a Molecule as the scene, or chemistry");
  felt_ = makeInteraction(input_);
}

Felt Feeler::feel(const py::object& poses) {
  const std::vector<PoseA> hand = posesOf(poses);
  const std::size_t n = hand.size();
  Felt out{.positions = newArray<double>(n, 3),
           .orientations = newArray<double>(n, 4),
           .forces = newArray<double>(n, 3),
           .torques = newArray<double>(n, 3),
           .energies = newArray<double>(n, 0),
           .parts = {},
           .touching = newArray<bool>(n, 0),
           .at_rest = newArray<bool>(n, 0),
           .started_inside = newArray<bool>(n, 0),
           .contacts = newArray<std::int32_t>(n, 3)};
  for (py::array_t<double>& part : out.parts.values) part = newArray<double>(n, 0);
  Rows rows(out);
  std::unique_lock used(in_use_, std::defer_lock);
  {
    const py::gil_scoped_release released;
    used.lock();
  }
  for (std::size_t from = 0; from < n; from += kPosesBetweenSignals) {
    {
      const py::gil_scoped_release released;
      for (std::size_t row = from; row < std::min(n, from + kPosesBetweenSignals); ++row) {
        const Response response = felt_->respond(hand[row]);
        rows.write(row, response.shownBody(hand[row]), response.total(stiffness_N_per_A_), response);
      }
    }
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
  return out;
}

void Feeler::reset() {
  const py::gil_scoped_release released;
  const std::lock_guard used(in_use_);
  felt_->reset();
}

}  // namespace moltact::python
