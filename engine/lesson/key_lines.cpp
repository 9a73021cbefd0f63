#include "engine/lesson/key_lines.h"

#include <algorithm>

#include "engine/language/catalogue.h"
#include "engine/lesson/suggestion.h"

namespace moltact {
namespace {

Place shifted(Place place, std::string_view line, std::string_view part) {
  return {place.line,
          place.column + characterCount(line.substr(0, static_cast<std::size_t>(part.data() - line.data())))};
}

const KeySpec* find(std::span<const KeySpec* const> keys, std::string_view name) {
  for (const KeySpec* k : keys) {
    if (k->name == name && !k->named) return k;
    if (!k->named) continue;
    const std::size_t from = k->name.find_first_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ");
    const std::string_view start = k->name.substr(0, from),
                           end = k->name.substr(std::min(k->name.find(' ', from), k->name.size()));
    if (name.size() > start.size() + end.size() && name.starts_with(start) && name.ends_with(end) &&
        !stripped(name.substr(start.size(), name.size() - start.size() - end.size())).empty())
      return k;
  }
  return nullptr;
}

// Convert a place within a text to the place in the file, where the text begins at `start`.
Place inFile(Place place, Place start) { return {start.line, start.column + (place.column ? place.column - 1 : 0)}; }

Problem inFile(Problem problem, Place start) {
  const Place place = inFile(Place{0, problem.column}, start);
  problem.line = place.line;
  problem.column = place.column;
  return problem;
}

void inFile(FactSpec& fact, Place start) {
  fact.place = inFile(fact.place, start);
  for (Place& place : fact.places) place = inFile(place, start);
}

Expected<Value> listValue(const KeySpec& key, const KeyLine& line) {
  Value value;
  value.text = line.value;
  for (const ListItem& item : line.items) {
    if (key.type == ValueType::Remarks) {
      if (auto problem = addRemark(value, item.text)) return inFile(*std::move(problem), item.place);
      value.remarks.back().place = {item.place.line, item.place.column + value.remarks.back().place.column - 1};
      continue;
    }
    if (key.type == ValueType::Facts) {
      if (auto problem = addFact(key, value, item.text)) return inFile(*std::move(problem), item.place);
      inFile(value.facts.back(), item.place);
      continue;
    }
    value.words.push_back(item.text);
    value.places.push_back(item.place);
  }
  return value;
}

}  // namespace

std::vector<KeyLine> splitKeyLines(std::span<const BlockLine> lines, std::vector<Problem>& problems) {
  std::vector<KeyLine> out;
  for (const BlockLine& line : lines) {
    const std::string_view text = line.text;
    const std::string_view body = stripped(text);
    if (body.empty() || body.starts_with('#')) continue;
    if (body == "-" || body.starts_with("- ")) {
      const std::string_view item = stripped(body.substr(1));
      if (out.empty())
        problems.push_back(problemAt(shifted(line.place, text, body), tr("a list without a key"),
                                     tr("write 'key:' on the line above")));
      else if (!item.empty())
        out.back().items.push_back({std::string(item), shifted(line.place, text, item)});
      continue;
    }
    const std::size_t colon = body.find(':');
    const std::string_view key = stripped(body.substr(0, colon));
    if (colon == std::string_view::npos || key.empty()) {
      problems.push_back(problemAt(shifted(line.place, text, body), trf("'{0}' is not a key and its value", body),
                                   tr("write it as 'key: value'")));
      continue;
    }
    const std::string_view value = stripped(body.substr(colon + 1));
    out.push_back(
        {std::string(key), std::string(value), shifted(line.place, text, key), shifted(line.place, text, value), {}});
  }
  return out;
}

KeyValues readKeyValues(std::span<const KeyLine> lines, std::span<const KeySpec* const> keys, const char* block,
                        Place block_place, std::vector<Problem>& problems, const UnknownKey& unknown) {
  KeyValues out;
  std::vector<std::string_view> seen, names;
  for (const KeySpec* k : keys) names.push_back(k->name);
  for (const KeyLine& line : lines) {
    const KeySpec* key = find(keys, line.key);
    if (!key) {
      const std::string remedy = unknown ? unknown(line.key) : std::string();
      problems.push_back(problemAt(line.key_place, trf("{0} has no key '{1}'", trc("block", block), line.key),
                                   remedy.empty() ? suggest(line.key, names, tr("keys")) : remedy));
      continue;
    }
    const std::string_view name = key->named ? std::string_view(line.key) : key->name;
    if (std::find(seen.begin(), seen.end(), name) != seen.end()) {
      problems.push_back(
          problemAt(line.key_place, trf("'{0}' is given twice", line.key), tr("take one of the two out")));
      continue;
    }
    seen.push_back(name);
    const bool takes_list =
        key->type == ValueType::TextList || key->type == ValueType::Remarks || key->type == ValueType::Facts;
    if (!line.items.empty() && (!takes_list || !line.value.empty())) {
      problems.push_back(problemAt(line.items[0].place, trf("'{0}' takes no list here", line.key),
                                   takes_list ? tr("write every item on a line of its own that starts with '- '")
                                              : tr("write one value after the colon")));
      continue;
    }
    Expected<Value> value = line.items.empty() ? parseValue(*key, line.value) : listValue(*key, line);
    if (!value) {
      const Problem& p = value.problem();
      problems.push_back(p.line ? p : inFile(p, line.value_place));
      continue;
    }
    value->place = line.items.empty() ? line.value_place : line.items[0].place;
    // What stands behind the colon has places within the value so far; items have those in the file.
    const auto place = [&](Place& p) {
      if (p.line == 0 && p.column) p = inFile(p, line.value_place);
    };
    for (Place& p : value->places) place(p);
    for (Place* p : {&value->view.facing_place, &value->view.zoom_place}) place(*p);
    for (StyleSpec& style : value->styles) place(style.place);
    for (MarkSpec& mark : value->marks) place(mark.place);
    for (PlacesSpec& measure : value->measures)
      for (Place& p : measure.places) place(p);
    for (SelectionRemark& remark : value->remarks) place(remark.place);
    for (FactSpec& fact : value->facts)
      if (fact.place.line == 0) inFile(fact, line.value_place);
    out.set(name, *std::move(value));
  }
  for (const KeySpec* key : keys) {
    if (std::find(seen.begin(), seen.end(), key->name) != seen.end()) continue;
    if (key->required)
      problems.push_back(problemAt(block_place, trf("{0} needs the key '{1}'", trc("block", block), key->name),
                                   trf("add a line '{0}: …'", key->name)));
    else if (!key->fallback.empty())
      if (auto value = parseValue(*key, key->fallback)) out.set(key->name, *std::move(value));
  }
  return out;
}

std::vector<const KeySpec*> pointersTo(std::span<const KeySpec> keys) {
  std::vector<const KeySpec*> out;
  for (const KeySpec& k : keys) out.push_back(&k);
  return out;
}

}  // namespace moltact
