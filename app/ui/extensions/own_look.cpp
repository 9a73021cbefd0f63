#include "app/ui/extensions/own_look.h"

#include <algorithm>

#include "app/ui/lesson/lesson_guide.h"
#include "app/ui/lesson/scene_marks.h"
#include "engine/core/text.h"
#include "engine/language/catalogue.h"
#include "engine/render/molecule_model.h"

namespace moltact {
namespace {

struct Key : OwnLookKey {
  void (*take)(const Value&, SceneSpec&);
  // The selections of a value, each of which has to find atoms.
  std::vector<Selection> (*atoms)(const Value&);
};

std::vector<Selection> ofMarks(const Value& value) {
  std::vector<Selection> all;
  for (const MarkSpec& m : value.marks) all.push_back(m.atoms);
  return all;
}

constexpr std::array<Key, OwnLook::kKeys> kTable{{
    {{"style", N_("Drawn as"), "cartoon, sticks for ligand"},
     [](const Value& v, SceneSpec& scene) { scene.styles = v.styles; },
     [](const Value& v) {
       std::vector<Selection> all;
       for (const StyleSpec& s : v.styles) all.push_back(s.atoms);
       return all;
     }},
    {{"hide", N_("Not drawn"), "chain B"},
     [](const Value& v, SceneSpec& scene) { scene.hide = v.selection; },
     [](const Value& v) { return std::vector{v.selection}; }},
    {{"colour", N_("Colours"), "charge"},
     [](const Value& v, SceneSpec& scene) { scene.colour = v.words[0]; },
     [](const Value&) { return std::vector<Selection>{}; }},
    {{"mark", N_("In colours of their own"), "teal \"acid\" for residue 35"},
     [](const Value& v, SceneSpec& scene) { scene.marks = v.marks; },
     ofMarks},
    {{"label", N_("Names"), "residue for ligand"},
     [](const Value& v, SceneSpec& scene) { scene.labels = v.marks; },
     ofMarks},
    {{"hydrogen-bonds", N_("Hydrogen bonds"), "all"},
     [](const Value& v, SceneSpec& scene) { scene.hydrogen_bonds = v.selection; },
     [](const Value& v) { return std::vector{v.selection}; }},
}};

constexpr auto kOffered = [] {
  std::array<OwnLookKey, OwnLook::kKeys> offered;
  for (std::size_t k = 0; k < offered.size(); ++k) offered[k] = kTable[k];
  return offered;
}();

Expected<Value> read(std::size_t key, const std::string& text) {
  const std::vector<KeySpec>& keys = keysOf(KeyBlock::Scene);
  const auto spec = std::find_if(keys.begin(), keys.end(), [&](const KeySpec& k) { return k.name == kTable[key].key; });
  return parseValue(*spec, trimmed(text));
}

}  // namespace

std::span<const OwnLookKey> OwnLook::keys() { return kOffered; }

std::optional<Problem> OwnLook::fault(std::size_t key, const Molecule& molecule) const {
  if (trimmed(values[key]).empty()) return std::nullopt;
  const Expected<Value> value = read(key, values[key]);
  const auto told = [](Problem why) {
    why.line = why.column = 0;  // there is one line
    return why;
  };
  if (!value) return told(value.problem());
  for (const Selection& atoms : kTable[key].atoms(*value))
    if (atoms.given() && atoms.select(molecule).empty()) return told(atoms.whyEmpty(molecule));
  return std::nullopt;
}

void OwnLook::show(TouchScene& scene) {
  if (!scene.stage()) return;
  const Molecule& molecule = *scene.stage().molecule;
  SceneSpec spec;
  spec.colour = usualColourBy(molecule) == ColourBy::Chain ? "chain" : "element";
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (fault(k, molecule)) return;
    if (!trimmed(values[k]).empty()) kTable[k].take(*read(k, values[k]), spec);
  }
  const std::optional<CutPlane> cut = scene.look.cut;
  scene.look = looksOf(spec, molecule);
  scene.look.cut = cut;
  scene.colour_by = colourBy(spec);
  drawn_ = annotationsOf(spec, molecule);
}

void OwnLook::sceneChanged() {
  if (scene_.stage().molecule == molecule_) return;
  molecule_ = scene_.stage().molecule;
  drawn_ = nullptr;
  values = {};
}

}  // namespace moltact
