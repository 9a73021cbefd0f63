// The Python module `moltact` over engine/haptics, engine/molecule and engine/structure. engine/python/moltact/__init__.pyi lists what it
// offers, with types; a test compares the two.
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "engine/haptics/body/held_body.h"
#include "engine/haptics/field/force_choices.h"
#include "engine/haptics/methods.h"
#include "engine/molecule/catalogue.h"
#include "engine/molecule/elements.h"
#include "engine/molecule/radius_tables.h"
#include "engine/python/arrays.h"
#include "engine/python/chemistry.h"
#include "engine/python/feeler.h"
#include "engine/structure/interaction_input.h"

namespace py = pybind11;

namespace moltact::python {
namespace {

using SharedMolecule = std::shared_ptr<Molecule>;

struct MoleculeError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

SharedMolecule load(const py::object& file, int model, bool waters, const std::string& assembly,
                    const std::string& beside, const std::string& radii) {
  const std::string name = py::str(py::module_::import("os").attr("fspath")(file));
  if (model < 1 || model > kMaxReadNumber) throw py::value_error("model must be a number from 1 to 100000");
  if (radiusTable(radii).word.name != radii) throw py::value_error("radii must be one of radius_tables()");
  const ReadOptions options{model, waters, assembly, beside, radii};
  Expected<Molecule> read = [&] {
    const py::gil_scoped_release released;
    return openMolecule(name, options);
  }();
  if (!read) throw MoleculeError(read.problem().text());
  return std::make_shared<Molecule>(*std::move(read));
}

py::array_t<double> sphereArray(const SharedArray<Sphere>& spheres) {
  auto out = newArray<double>(spheres.size(), 4);
  double* at = out.mutable_data();
  for (const Sphere& s : spheres) {
    *at++ = s.centre_A.x;
    *at++ = s.centre_A.y;
    *at++ = s.centre_A.z;
    *at++ = s.radius_A;
  }
  return out;
}

// A property of each atom as an array.
template <class T, class Get>
py::array_t<T> atomArray(const Molecule& molecule, Get get) {
  auto out = newArray<T>(molecule.atoms.size(), 0);
  for (std::size_t k = 0; k < molecule.atoms.size(); ++k) out.mutable_data()[k] = T(get(k));
  return out;
}

template <class Get>
std::vector<std::string> atomWords(const Molecule& molecule, Get get) {
  std::vector<std::string> out;
  for (std::size_t k = 0; k < molecule.atoms.size(); ++k) out.emplace_back(get(k));
  return out;
}

std::string describe(const Molecule& molecule, const py::object& atom) {
  return molecule.describe(indicesOf(py::make_tuple(atom), molecule.atoms.size(), "atom").front());
}

// The spheres of a scene: a molecule's, or an array's.
SharedArray<Sphere> sceneSpheres(const py::object& scene) {
  if (py::isinstance<Molecule>(scene)) return scene.cast<SharedMolecule>()->spheres;
  return spheresOf(scene);
}

// The classes of Python share everything but their constructors.
struct Tracker : Feeler {
  using Feeler::Feeler;
};
struct Body : Feeler {
  using Feeler::Feeler;
};

// The choice of that name, or ValueError.
template <class Choices>
void checkChoice(const char* argument, const std::string& name, const Choices& choices) {
  std::string known;
  for (const auto& choice : choices) {
    if (choice.name == name) return;
    known += (known.empty() ? "'" : ", '") + std::string(choice.name) + "'";
  }
  throw py::value_error(std::string(argument) + " must be one of " + known);
}

// The forces between atoms, as both classes take them.
struct Forces {
  std::string forces, dielectric;
  double coupling_N_per_mm;
};

// Completes the input that is common to both classes.
void finish(InteractionInput& input, const py::object& scene, const std::string& method, const std::string& interaction,
            const SharedChemistry& chemistry, const Forces& forces) {
  input.touch.method = method;
  input.touch.interaction =
      interaction.empty() ? resolveInteraction({}, input.body != nullptr).interaction : interaction;
  checkChoice("forces", forces.forces, forceChoices());
  checkChoice("dielectric", forces.dielectric, dielectricChoices());
  if (!(forces.coupling_N_per_mm >= 0.0 && forces.coupling_N_per_mm <= kMaxCoupling_N_per_mm))
    throw py::value_error("coupling_N_per_mm must be a number from 0 to " + std::to_string(kMaxCoupling_N_per_mm));
  input.touch.forces = forces.forces;
  input.touch.dielectric = forces.dielectric;
  input.touch.coupling_N_per_mm = forces.coupling_N_per_mm;
  input.chemistry = chemistryOf(scene, chemistry, input.touch, input.spheres->size());
  if (!forceChoice(forces.forces).any()) return;
  if (!py::isinstance<Molecule>(scene)) throw py::value_error("forces between atoms need a Molecule as the scene");
  input.pairs = pairField(input.touch, *scene.cast<SharedMolecule>(), *input.spheres, input.body.get());
}

std::unique_ptr<Tracker> makeTracker(const py::object& scene, const std::string& method, double probe_A,
                                     const std::string& interaction, double stiffness_N_per_A,
                                     const py::object& untouchable, const SharedChemistry& chemistry,
                                     const std::string& forces, const std::string& dielectric, double probe_charge_e,
                                     double coupling_N_per_mm) {
  if (!(std::abs(probe_charge_e) <= kMaxProbeCharge_e))
    throw py::value_error("probe_charge_e must be a number from -2 to 2");
  const SharedArray<Sphere> spheres = sceneSpheres(scene);
  const std::vector<std::uint32_t> left_out = indicesOf(untouchable, spheres.size(), "untouchable");
  InteractionInput input{.spheres = std::make_shared<const SphereGrid>(spheres, left_out)};
  input.touch.probe_A = probe_A;
  input.touch.probe_charge_e = probe_charge_e;
  finish(input, scene, method, interaction, chemistry, {forces, dielectric, coupling_N_per_mm});
  return std::make_unique<Tracker>(std::move(input), stiffness_N_per_A);
}

std::unique_ptr<Body> makeBody(const py::object& scene, const py::object& atoms, const py::object& shape,
                               const std::string& method, const std::string& interaction, double stiffness_N_per_A,
                               double rotational_stiffness_N_A, const SharedChemistry& chemistry,
                               const std::string& forces, const std::string& dielectric, double coupling_N_per_mm) {
  if (atoms.is_none() == shape.is_none()) throw py::value_error("give either atoms or spheres of the body");
  if (!(rotational_stiffness_N_A >= 0.0 && rotational_stiffness_N_A <= 1e9))
    throw py::value_error("rotational_stiffness_N_A must be a number from 0 to 1e9");
  const SharedArray<Sphere> spheres = sceneSpheres(scene);
  std::vector<std::uint32_t> held;
  InteractionInput input;
  if (atoms.is_none()) {
    input.body = bodyOfSpheres(spheresOf(shape));
  } else {
    held = indicesOf(atoms, spheres.size(), "atoms");
    input.body = py::isinstance<Molecule>(scene) ? heldBody(*scene.cast<SharedMolecule>(), held)
                                                 : heldBody({spheres.data(), spheres.size()}, held);
  }
  if (!input.body) throw py::value_error("a body has 1 to " + std::to_string(kMaxHeldAtoms) + " atoms");
  input.spheres = std::make_shared<const SphereGrid>(spheres, held);
  // The response is divided by the stiffness, so it equals that of a spring of 1 N/A.
  if (stiffness_N_per_A > 0.0) input.rotational_stiffness_N_A = rotational_stiffness_N_A / stiffness_N_per_A;
  finish(input, scene, method, interaction, chemistry, {forces, dielectric, coupling_N_per_mm});
  return std::make_unique<Body>(std::move(input), stiffness_N_per_A);
}

py::array_t<double> middleOf(const Body& body) {
  auto out = newArray<double>(3, 0);
  for (int axis = 0; axis < 3; ++axis) out.mutable_data()[axis] = body.input().body->middle.A[axis];
  return out;
}

void addMolecule(py::module_& m) {
  py::class_<Molecule, SharedMolecule>(m, "Molecule", "The atoms of a file. Made by load(); immutable.")
      .def("__len__", [](const Molecule& self) { return self.atoms.size(); })
      .def("__repr__",
           [](const Molecule& self) {
             return "<moltact.Molecule " + self.id + ", " + std::to_string(self.atoms.size()) + " atoms>";
           })
      .def("chemistry", &chemistryOfMolecule, py::arg("charges") = kNoCharges,
           "Element, type and charge of each atom. charges: 'none', 'file' (of a file with charges) or 'formal' "
           "(at pH 7).")
      .def("describe", &describe, py::arg("atom"), "The atom in words: \"O of Asp 52 (chain A)\".")
      .def_property_readonly(
          "id", [](const Molecule& self) { return self.id; }, "A short name: \"1UBQ\".")
      .def_property_readonly(
          "title", [](const Molecule& self) { return self.title; }, "One line; may be empty.")
      .def_property_readonly(
          "warnings",
          [](const Molecule& self) { return std::vector<std::string>(self.warnings.begin(), self.warnings.end()); },
          "What was left out, replaced or guessed in reading, one sentence each.")
      .def_property_readonly(
          "spheres", [](const Molecule& self) { return sphereArray(self.spheres); },
          "Centre and van der Waals radius of each atom in A, shape (n, 4).")
      .def_property_readonly(
          "positions",
          [](const Molecule& self) {
            auto out = newArray<double>(self.spheres.size(), 3);
            double* at = out.mutable_data();
            for (const Sphere& s : self.spheres)
              for (int axis = 0; axis < 3; ++axis) *at++ = s.centre_A[axis];
            return out;
          },
          "Centre of each atom in A, shape (n, 3).")
      .def_property_readonly(
          "radii",
          [](const Molecule& self) {
            return atomArray<double>(self, [&](std::size_t k) { return self.spheres[k].radius_A; });
          },
          "Van der Waals radius of each atom in A, shape (n,).")
      .def_property_readonly(
          "atomic_numbers",
          [](const Molecule& self) {
            return atomArray<std::uint8_t>(self, [&](std::size_t k) { return self.atoms[k].atomic_number; });
          },
          "Atomic number of each atom, 0 where unknown, shape (n,).")
      .def_property_readonly(
          "elements",
          [](const Molecule& self) {
            return atomWords(self, [&](std::size_t k) { return element(self.atoms[k].atomic_number).symbol; });
          },
          "Symbol of each atom's element, \"?\" where unknown.")
      .def_property_readonly(
          "names",
          [](const Molecule& self) { return atomWords(self, [&](std::size_t k) { return self.atoms[k].nameText(); }); },
          "Name of each atom within its residue: \"CA\".")
      .def_property_readonly(
          "residues",
          [](const Molecule& self) {
            return atomWords(self, [&](std::size_t k) -> std::string_view {
              const std::uint32_t residue = self.atoms[k].residue;
              return residue == kNoResidue ? std::string_view() : std::string_view(self.residues[residue].name);
            });
          },
          "Residue name of each atom: \"ASP\"; empty for a file without residues.")
      .def_property_readonly(
          "residue_numbers",
          [](const Molecule& self) {
            return atomArray<std::int32_t>(self, [&](std::size_t k) {
              const std::uint32_t residue = self.atoms[k].residue;
              return residue == kNoResidue ? 0 : self.residues[residue].number;
            });
          },
          "Residue number of each atom in the file, shape (n,); 0 for a file without residues.");
  m.def("load", &load, py::arg("file"), py::kw_only(), py::arg("model") = 1, py::arg("waters") = false,
        py::arg("assembly") = "", py::arg("beside") = "", py::arg("radii") = "bondi",
        "Reads a molecule: a file (PDB, mmCIF, SDF, MOL2, PQR, PDBQT, GRO, XYZR, also gzipped) or a name of Moltact's "
        "library, such "
        "as \"1ubq\". Raises MoleculeError.");
}

template <EnergyPart part>
const py::array_t<double>& energyOf(const Felt& felt) {
  return felt.parts[part];
}

void addFelt(py::module_& m) {
  py::class_<Felt>(m, "Felt", "What a hand feels at n poses; one row for each. Made by feel().")
      .def("__len__", [](const Felt& self) { return self.touching.size(); })
      .def_readonly(
          "positions", &Felt::positions,
          "Where the probe or the middle of the body rests, in A, shape (n, 3); the hand's own position while "
          "nothing is touched.")
      .def_readonly("orientations", &Felt::orientations,
                    "Orientation of the body that rests there, as quaternions w, x, y, z, shape (n, 4).")
      .def_readonly("forces", &Felt::forces, "Force on the hand in N, shape (n, 3).")
      .def_readonly("torques", &Felt::torques, "Torque about the hand's position in N A, shape (n, 3).")
      .def_readonly("energies", &Felt::energies, "Potential energy of the hand's spring in N A, shape (n,).")
      .def_property_readonly(
          "van_der_waals", &energyOf<EnergyPart::VanDerWaals>,
          "Van der Waals energy with the molecule in kcal/mol, shape (n,); 0 without forces between atoms.")
      .def_property_readonly(
          "electrostatic", &energyOf<EnergyPart::Electrostatic>,
          "Electrostatic energy with the molecule in kcal/mol, shape (n,); 0 without forces between atoms.")
      .def_readonly("touching", &Felt::touching, "True where a surface is touched, shape (n,).")
      .def_readonly("contacts", &Felt::contacts,
                    "The atoms that block the contact point, ascending, -1 where there are fewer, shape (n, 3).")
      .def_readonly("at_rest", &Felt::at_rest,
                    "False where the search for the rest of a body goes on in the next row, shape (n,).")
      .def_readonly("started_inside", &Felt::started_inside,
                    "True where there is no force because the hand has been inside since the start, shape (n,).");
}

void addFeelers(py::module_& m) {
  py::class_<Feeler>(m, "_Feeler", "What Tracker and HeldBody have in common.")
      .def(
          "feel", &Feeler::feel, py::arg("poses"),
          "Moves the hand through poses in A, of shape (n, 3), or (n, 7) with quaternions w, x, y, z, and returns what "
          "it feels. The contact goes on from call to call; the force begins after the hand has been outside once.")
      .def("reset", &Feeler::reset, "Discards the contact: the next pose is a start.")
      .def_property_readonly(
          "method", [](const Feeler& self) { return self.input().touch.method; },
          "Name of the haptic method, one of methods().")
      .def_property_readonly(
          "interaction", [](const Feeler& self) { return self.input().touch.interaction; },
          "Name of the interaction, one of interactions().")
      .def_property_readonly("stiffness_N_per_A", &Feeler::stiffness_N_per_A, "Stiffness of the spring in N/A.");

  py::class_<Tracker, Feeler>(m, "Tracker", "A spherical probe at the hand.")
      .def(
          py::init(&makeTracker), py::arg("scene"), py::arg("method") = "exact", py::arg("probe_A") = kWaterProbe_A,
          py::kw_only(), py::arg("interaction") = "", py::arg("stiffness_N_per_A") = 1.0,
          py::arg("untouchable") = py::tuple(), py::arg("chemistry") = py::none(), py::arg("forces") = "none",
          py::arg("dielectric") = "water", py::arg("probe_charge_e") = 0.0, py::arg("coupling_N_per_mm") = 0.0,
          "scene: a Molecule, or spheres of shape (n, 4): centre and radius in A. interaction: one of "
          "interactions(body=False); empty: the first. untouchable: indices of atoms that are not felt. chemistry: of "
          "the scene's atoms, for an interaction that needs it; without it, that of the Molecule without charges. "
          "forces: 'none', 'all', 'van-der-waals' or 'electrostatic' between the atoms of a Molecule and the probe, an "
          "oxygen of water with probe_charge_e. dielectric: 'water', 'distance' or 'vacuum'. coupling_N_per_mm: "
          "stiffness in the molecule of the spring between the hand and the probe; 0: the default.")
      .def_property_readonly(
          "probe_A", [](const Tracker& self) { return self.input().touch.probe_A; }, "Radius of the probe in A.");

  py::class_<Body, Feeler>(m, "HeldBody", "A rigid body in the hand.")
      .def(py::init(&makeBody), py::arg("scene"), py::arg("atoms") = py::none(), py::kw_only(),
           py::arg("spheres") = py::none(), py::arg("method") = "exact", py::arg("interaction") = "",
           py::arg("stiffness_N_per_A") = 1.0, py::arg("rotational_stiffness_N_A") = 0.0,
           py::arg("chemistry") = py::none(), py::arg("forces") = "none", py::arg("dielectric") = "water",
           py::arg("coupling_N_per_mm") = 0.0,
           "scene, chemistry, forces, dielectric and coupling_N_per_mm: as for Tracker. atoms: indices of the scene's "
           "atoms that are held and no longer felt; "
           "or spheres: "
           "the body's own, of shape (m, 4), relative to its middle. interaction: one of interactions(); empty: the "
           "first.")
      .def_property_readonly("middle", &middleOf, "Where the middle of the body is in the scene, in A, shape (3,).")
      .def_property_readonly(
          "spheres", [](const Body& self) { return sphereArray(self.input().body->spheres); },
          "The body relative to its middle, radii as they are felt, in A, shape (m, 4).");
}

}  // namespace

PYBIND11_MODULE(_moltact, m) {
  m.doc() = "Feel molecules: Moltact's haptic methods over numpy arrays.";
  py::register_exception<MoleculeError>(m, "MoleculeError", PyExc_ValueError);
  m.attr("__version__") = MOLTACT_VERSION;
  m.def("methods", &methodNames, "Names of the haptic methods, the default first.");
  m.def(
      "radius_tables",
      [] {
        std::vector<std::string> out;
        for (const RadiusTable& table : radiusTables()) out.emplace_back(table.word.name);
        return out;
      },
      "Names of the tables of van der Waals radii, the default first.");
  m.def(
      "interactions",
      [](bool body) {
        std::vector<std::string> out;
        for (const InteractionKind& kind : interactionKinds())
          if (kind.holds_body == body) out.emplace_back(kind.name);
        return out;
      },
      py::arg("body") = true, "Names of the ways to feel a scene with a body, or with a probe; the default first.");
  addChemistry(m);
  addMolecule(m);
  addFelt(m);
  addFeelers(m);
}

}  // namespace moltact::python
