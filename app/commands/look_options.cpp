#include "app/commands/look_options.h"

#include <algorithm>
#include <memory>
#include <vector>

#include "engine/lesson/keys.h"
#include "engine/lesson/scene_atoms.h"
#include "engine/render/molecule_model.h"

namespace moltact {
namespace {

std::vector<std::string> schemeNames() {
  std::vector<std::string> names;
  for (const ColouringScheme& scheme : colouringSchemes()) names.emplace_back(scheme.name);
  return names;
}

AtomList listOf(std::vector<std::uint32_t> atoms) {
  return std::make_shared<const std::vector<std::uint32_t>>(std::move(atoms));
}

std::vector<StyleSpec> stylesOf(const std::string& text) {
  const std::vector<KeySpec>& keys = keysOf(KeyBlock::Scene);
  const auto spec = std::find_if(keys.begin(), keys.end(), [](const KeySpec& k) { return k.name == "style"; });
  Expected<Value> read = parseValue(*spec, text);
  if (!read) throw CLI::ValidationError("--style", read.problem().text());
  return read->styles;
}

}  // namespace

void LookOptions::addTo(CLI::App& command) {
  std::string styles =
      "Style of the atoms, in the syntax of the key 'style' of a scene: 'surface 40% for chain A, spheres for ligand'; "
      "the styles are:";
  for (const DrawStyleInfo& s : drawStyles()) styles += "\n" + std::string(s.name) + ": " + std::string(s.sentence);
  command.add_option("--style", style, styles)->capture_default_str();
  command.add_option("--hide", hide, "Selection of atoms that are not drawn: 'water', 'chain B'");
  left_out.addTo(command);
  command
      .add_option("--colour", colour,
                  "Colouring of the atoms; by default by chain if the molecule has several chains, else by element")
      ->check(CLI::IsMember(schemeNames()));
}

AtomsLook LookOptions::look(const Molecule& molecule, const ColouringInput& colours) const {
  AtomsLook out;
  for (const StyleSpec& s : stylesOf(style))
    out.styles.push_back({s.style,
                          s.atoms.given() ? listOf(selectedAtoms("--style", s.atoms.text(), molecule)) : nullptr,
                          float(s.opacity)});
  std::vector<std::uint32_t> hidden = left_out.removed(molecule);
  if (!hide.empty() && hide != "none") hidden = atomsOfEither(hidden, selectedAtoms("--hide", hide, molecule));
  if (!hidden.empty()) out.hidden = listOf(std::move(hidden));
  if (!colour.empty()) out.colouring = schemeColouring(molecule, colour, colours);
  return out;
}

ColourBy LookOptions::colourBy(const Molecule& molecule) const {
  if (colour.empty()) return usualColourBy(molecule);
  return colour == "chain" ? ColourBy::Chain : ColourBy::Element;
}

}  // namespace moltact
