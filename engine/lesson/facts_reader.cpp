// Reads a facts block.
#include <algorithm>

#include "engine/language/catalogue.h"
#include "engine/lesson/reading.h"
#include "engine/lesson/reading_keys.h"

namespace moltact::reading {

FactsSpec readFacts(Reading& reading, const MarkdownBlock& block, const Lesson& lesson, const SceneSpec& scene) {
  std::vector<Problem> problems;
  const std::vector<KeySpec>& table = keysOf(KeyBlock::Facts);
  const KeyValues values = readKeyValues(splitKeyLines(block.lines, problems), pointersTo(table),
                                         blockName(KeyBlock::Facts), block.place, problems);
  const bool understood = problems.empty();
  reading.add(std::move(problems));
  FactsSpec out;
  const bool own = values.has("molecule");
  out.probe_A = scene.touch.probe_A;
  out.molecule_place = out.remove_place = block.place;
  if (own) {
    out.molecule.name = values["molecule"].text;
    out.molecule_place = values["molecule"].place;
    mustBeListed(reading, lesson, out.molecule.name, out.molecule_place);
  } else {
    out.molecule = scene.molecule;
    out.remove = scene.remove;
    if (scene.molecule.name.empty())
      reading.error(block.place, tr("these facts are about no molecule"),
                    tr("put a scene block above them, or add a line 'molecule: …'"));
  }
  for (const ReadingOption& option : readingOptions())
    if (const Value& value = values[option.name]; value.place.line) readValue(out.molecule.reading, option, value);
  if (values.has("remove")) {
    out.remove = values["remove"].selection;
    out.remove_place = values["remove"].place;
  }
  if (values.has("probe")) out.probe_A = values["probe"].number;
  for (const KeySpec& key : table)
    for (const FactSpec& fact : values[key.name].facts) out.facts.emplace_back(key.name, fact);
  std::stable_sort(out.facts.begin(), out.facts.end(),
                   [](const auto& a, const auto& b) { return a.second.place.line < b.second.place.line; });
  if (understood && out.facts.empty())
    reading.warning(block.place, tr("this block states no fact"), tr("add one, or take the block out"));
  return out;
}

}  // namespace moltact::reading
