#include "app/ui/extensions/own_look.h"

#include <algorithm>
#include <utility>

#include "app/ui/lesson/lesson_guide.h"
#include "app/ui/lesson/scene_marks.h"
#include "engine/core/text.h"
#include "engine/language/catalogue.h"
#include "engine/render/molecule_model.h"

namespace moltact {
namespace {

struct Key : OwnLookKey {
  void (*take)(const Value&, SceneSpec&);
  // The selections in a value; each must match at least one atom.
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

std::optional<Problem> faultOf(std::size_t key, const std::string& text, const Molecule& molecule) {
  if (trimmed(text).empty()) return std::nullopt;
  const Expected<Value> value = read(key, text);
  const auto refused = [](Problem why) {
    why.line = why.column = 0;  // a value has a single line
    return why;
  };
  if (!value) return refused(value.problem());
  for (const Selection& atoms : kTable[key].atoms(*value))
    if (atoms.given() && atoms.select(molecule).empty()) return refused(atoms.whyEmpty(molecule));
  return std::nullopt;
}

}  // namespace

std::span<const OwnLookKey> OwnLook::keys() { return kOffered; }

const std::array<std::string, OwnLook::kKeys>& OwnLook::faults(const std::shared_ptr<const Molecule>& molecule) {
  const bool another = std::exchange(checked_molecule_, molecule) != molecule;
  for (std::size_t k = 0; k < kKeys; ++k) {
    if (!another && checked_[k] == values[k]) continue;
    checked_[k] = values[k];
    const std::optional<Problem> problem = faultOf(k, values[k], *molecule);
    faults_[k] = problem ? problem->text() : std::string();
  }
  return faults_;
}

void OwnLook::show(HapticSession& scene) {
  if (!scene.stage()) return;
  const std::shared_ptr<const Molecule> molecule = scene.stage().molecule;
  for (const std::string& fault : faults(molecule))
    if (!fault.empty()) return;
  SceneSpec spec;
  spec.colour.clear();
  for (std::size_t k = 0; k < kKeys; ++k)
    if (!trimmed(values[k]).empty()) kTable[k].take(*read(k, values[k]), spec);
  const AtomsLook written = looksOf(spec, *molecule, true);
  if (!spec.styles.empty()) scene.look.atoms.styles = written.styles;
  if (!spec.colour.empty()) {
    scene.look.atoms.colouring = written.colouring;
    scene.look.colour_by = colourBy(spec);
  }
  scene.look.atoms.hidden = written.hidden;
  scene.look.atoms.marks = written.marks;
  scene.look.atoms.annotations = annotationsOf(spec, *molecule);
}

void OwnLook::sceneChanged() {
  if (std::exchange(molecule_, scene_.stage().molecule) != molecule_) values = {};
}

}  // namespace moltact
