#include "engine/python/chemistry.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>
#include <vector>

#include "engine/molecule/elements.h"
#include "engine/python/arrays.h"
#include "engine/structure/atom_charges.h"

namespace py = pybind11;

namespace moltact::python {
namespace {

constexpr double kMaxAtomicNumber = 118.0, kMaxCharge_e = 1000.0;

void requireCount(const char* name, std::size_t count, std::size_t atoms) {
  if (count != atoms)
    throw py::value_error(std::string(name) + " must have one entry for each of the " + std::to_string(atoms) +
                          " atoms, not " + std::to_string(count));
}

[[noreturn]] void refuseEntry(const char* name, std::size_t at, const char* why) {
  throw py::value_error(std::string(name) + "[" + std::to_string(at) + "] " + why);
}

SharedChemistry makeChemistry(const py::object& atomic_numbers, const py::object& types, const py::object& charges_e) {
  AtomChemistry out;
  for (const double z : numbersIn(atomic_numbers, "atomic_numbers")) {
    if (!(z >= 0.0 && z <= kMaxAtomicNumber && z == std::floor(z)))
      refuseEntry("atomic_numbers", out.atomic_numbers.size(), "is not a whole number from 0 to 118");
    out.atomic_numbers.push_back(std::uint8_t(z));
  }
  const std::size_t atoms = out.atomic_numbers.size();
  std::vector<std::string> names;
  if (types.is_none())
    for (const std::uint8_t z : out.atomic_numbers) names.emplace_back(element(z).symbol);
  else
    names = types.cast<std::vector<std::string>>();
  requireCount("types", names.size(), atoms);
  std::unordered_map<std::string, std::uint16_t> known;
  for (const std::string& name : names) {
    const auto [at, added] = known.emplace(name, std::uint16_t(out.type_names.size()));
    if (added) out.type_names.push_back(name);
    if (out.type_names.size() > std::numeric_limits<std::uint16_t>::max())
      throw py::value_error("types has more than 65535 different names");
    out.types.push_back(at->second);
  }
  if (charges_e.is_none()) return std::make_shared<AtomChemistry>(std::move(out));
  for (const double charge_e : numbersIn(charges_e, "charges_e")) {
    if (!(std::abs(charge_e) <= kMaxCharge_e))
      refuseEntry("charges_e", out.charges_e.size(), "is not a number from -1000 to 1000");
    out.charges_e.push_back(float(charge_e));
  }
  requireCount("charges_e", out.charges_e.size(), atoms);
  return std::make_shared<AtomChemistry>(std::move(out));
}

template <class T>
py::array_t<T> arrayOf(const std::vector<T>& values) {
  auto out = newArray<T>(values.size(), 0);
  std::copy(values.begin(), values.end(), out.mutable_data());
  return out;
}

std::vector<std::string> typesOf(const AtomChemistry& chemistry) {
  std::vector<std::string> out;
  for (const std::uint16_t type : chemistry.types) out.push_back(chemistry.type_names[type]);
  return out;
}

}  // namespace

void addChemistry(py::module_& m) {
  py::class_<AtomChemistry, SharedChemistry>(
      m, "Chemistry", "Element, type and charge of a scene's atoms, for forces beyond contact; immutable.")
      .def(py::init(&makeChemistry), py::arg("atomic_numbers"), py::kw_only(), py::arg("types") = py::none(),
           py::arg("charges_e") = py::none(),
           "atomic_numbers: 0 where unknown, shape (n,). types: n names for tables of force fields, such as "
           "\"ASP OD1\"; without them, the elements' symbols. charges_e: in elementary charges, shape (n,).")
      .def("__len__", [](const AtomChemistry& self) { return self.atomic_numbers.size(); })
      .def_property_readonly(
          "atomic_numbers", [](const AtomChemistry& self) { return arrayOf(self.atomic_numbers); },
          "Atomic number of each atom, 0 where unknown, shape (n,).")
      .def_property_readonly("types", &typesOf, "Name of each atom in tables of force fields: \"ASP OD1\".")
      .def_property_readonly(
          "charges_e",
          [](const AtomChemistry& self) -> py::object {
            if (self.charges_e.empty()) return py::none();
            return arrayOf(self.charges_e);
          },
          "Charge of each atom in elementary charges, shape (n,); None without charges.");
}

SharedChemistry chemistryOfMolecule(const Molecule& molecule, const std::string& charges) {
  const auto sources = chargeSources();
  if (std::none_of(sources.begin(), sources.end(), [&](const ChargeSource& s) { return s.name == charges; })) {
    std::string names;
    for (const ChargeSource& s : sources) names += (names.empty() ? "'" : ", '") + std::string(s.name) + "'";
    throw py::value_error("there is no source of charges '" + charges + "'; choose from " + names);
  }
  if (charges == kFileCharges && molecule.charges_e.empty())
    throw py::value_error("the file of this molecule has no charges; choose 'none' or 'formal', or give charges_e");
  return std::make_shared<AtomChemistry>(atomChemistry(molecule, charges));
}

std::shared_ptr<const AtomChemistry> chemistryOf(const py::object& scene, const SharedChemistry& given,
                                                 const TouchSetup& touch, std::size_t atoms) {
  if (given) {
    requireCount("chemistry", given->atomic_numbers.size(), atoms);
    return given;
  }
  return py::isinstance<Molecule>(scene) ? chemistryFor(touch, *scene.cast<std::shared_ptr<Molecule>>()) : nullptr;
}

}  // namespace moltact::python
