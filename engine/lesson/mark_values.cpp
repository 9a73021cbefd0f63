// Parses a scene's marks and measurements: "residue for chain A, "the cleft" for residue 35", "residue 35 - residue
// 52".
#include <algorithm>

#include "engine/language/catalogue.h"
#include "engine/lesson/suggestion.h"
#include "engine/lesson/value_parts.h"
#include "engine/molecule/molecule.h"

namespace moltact::values {
namespace {

constexpr std::size_t kMaxItems = 200, kLongestName = 80;

// WORD, "NAME" or both, then "for SELECTION".
Expected<MarkSpec> markOf(const KeySpec& key, std::string_view text, std::string_view part) {
  MarkSpec mark;
  std::string_view rest = part;
  if (!rest.starts_with('"')) {
    const std::string_view word = rest.substr(0, rest.find(' '));
    if (std::find(key.words.begin(), key.words.end(), word) == key.words.end())
      return at(text, word, trf("'{0}' cannot be '{1}'", key.name, word), suggest(word, key.words, tr("known")));
    mark.word = word;
    rest = stripped(rest.substr(word.size()));
  }
  if (rest.starts_with('"')) {
    const std::size_t end = rest.find('"', 1);
    if (end == std::string_view::npos)
      return at(text, rest, tr("the name has no end"), tr("close it with a double quote"));
    mark.name = stripped(rest.substr(1, end - 1));
    if (mark.name.empty() || characterCount(mark.name) > kLongestName)
      return at(text, rest, tr("a name has 1 to 80 characters"), tr("write it between double quotes"));
    rest = stripped(rest.substr(end + 1));
  }
  if (rest.starts_with("for ")) {
    const std::string_view atoms = stripped(rest.substr(4));
    Expected<Selection> read = selectionIn(text, atoms);
    if (!read) return read.problem();
    mark.atoms = *std::move(read);
    mark.place = {0, at(text, atoms, {}).column};
  } else if (!rest.empty()) {
    return at(text, rest, trf("'{0}' is not understood here", rest),
              tr("write 'for' and the atoms, as in 'residue for chain A'"));
  } else if (!mark.name.empty()) {
    return at(text, part, tr("a name needs its atoms"),
              tr("write 'for' and the atoms, as in '\"the cleft\" for residue 35'"));
  }
  return mark;
}

}  // namespace

Expected<Value> marksValue(const KeySpec& key, std::string_view text, Value value) {
  if (text == "none") {
    value.words = {"none"};
    return value;
  }
  for (const std::string_view part : unquotedParts(text, ",")) {
    if (part.empty()) return at(text, part, tr("a word is missing"), tr("take out the comma"));
    if (part == "none") return at(text, part, tr("'none' stands alone"), tr("take it out, or the others"));
    Expected<MarkSpec> mark = markOf(key, text, part);
    if (!mark) return mark.problem();
    if (value.marks.size() == kMaxItems) return at(text, part, tr("more than 200 of them"), tr("take some out"));
    value.marks.push_back(*std::move(mark));
  }
  return value;
}

Expected<Value> placesValue(const KeySpec& key, std::string_view text, Value value) {
  if (text == "none") {
    value.words = {"none"};
    return value;
  }
  for (const std::string_view part : unquotedParts(text, ",")) {
    PlacesSpec spec;
    for (const std::string_view atoms : unquotedParts(part, " - ")) {
      if (atoms.empty() || atoms == "-" || atoms.starts_with("- ") || atoms.ends_with(" -"))
        return at(text, part, tr("a place is missing beside '-'"), tr("name atoms on both sides of it"));
      Expected<Selection> read = selectionIn(text, atoms);
      if (!read) return read.problem();
      spec.atoms.push_back(*std::move(read));
      spec.places.push_back({0, at(text, atoms, {}).column});
    }
    const auto count = double(spec.atoms.size());
    if (count < key.min || count > key.max)
      return key.max > key.min ? at(text, part, trf("'{0}' is between three places or four", key.name),
                                    tr("write three for an angle, four for a torsion, with ' - ' between them"))
                               : at(text, part, trf("'{0}' is between two places", key.name),
                                    tr("write two with ' - ' between them"));
    if (value.measures.size() == kMaxItems) return at(text, part, tr("more than 200 of them"), tr("take some out"));
    value.measures.push_back(std::move(spec));
  }
  return value;
}

}  // namespace moltact::values
