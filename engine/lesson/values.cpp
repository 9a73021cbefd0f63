#include <algorithm>
#include <cmath>
#include <sstream>

#include "engine/haptics/methods.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/keys.h"
#include "engine/lesson/selection_slips.h"
#include "engine/lesson/suggestion.h"
#include "engine/lesson/value_parts.h"

namespace moltact {
namespace values {

Problem at(std::string_view text, std::string_view part, std::string message, std::string remedy) {
  const auto offset = static_cast<std::size_t>(part.data() - text.data());
  return {{}, 0, characterCount(text.substr(0, offset)) + 1, std::move(message), std::move(remedy)};
}

std::vector<std::string_view> unquotedParts(std::string_view text, std::string_view separator) {
  std::vector<std::string_view> parts;
  for (bool more = true; more;) {
    bool quoted_name = false;
    std::size_t end = 0;
    while (end < text.size() && (quoted_name || !text.substr(end).starts_with(separator)))
      quoted_name = quoted_name != (text[end++] == '"');
    more = end < text.size();
    parts.push_back(stripped(text.substr(0, end)));
    if (more) text.remove_prefix(end + separator.size());
  }
  return parts;
}

Expected<Selection> selectionIn(std::string_view text, std::string_view part) {
  auto selection = parseSelection(part);
  if (selection) return selection;
  Problem p = selection.problem();
  p.column += at(text, part, {}).column - 1;
  return p;
}

}  // namespace values

namespace {

using values::at;
using values::selectionIn;

std::string plain(double value, Dimension dimension) {
  std::ostringstream out;
  out << value;
  if (dimension != Dimension::None) out << ' ' << codeUnit(dimension);
  return out.str();
}

std::vector<std::string_view> commaParts(std::string_view text) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t comma = text.find(',');
    parts.push_back(stripped(text.substr(0, comma)));
    if (comma == std::string_view::npos) return parts;
    text.remove_prefix(comma + 1);
  }
}

Expected<Value> bounded(const KeySpec& key, std::string_view text, Value value, double low, double high) {
  if (low < key.min)
    return at(text, text, trf("'{0}' is too small", text), trf("the smallest is {0}", plain(key.min, key.dimension)));
  if (high > key.max)
    return at(text, text, trf("'{0}' is too large", text), trf("the largest is {0}", plain(key.max, key.dimension)));
  return value;
}

Expected<Value> countValue(const KeySpec& key, std::string_view text, Value value) {
  const auto number = parseNumber(text);
  if (!number) {
    Problem p = number.problem();
    if (p.remedy.empty()) p.remedy = tr("write a whole number and nothing else, as in '10'");
    return p;
  }
  if (*number != std::floor(*number)) return at(text, text, trf("'{0}' is not a whole number", text));
  value.number = *number;
  return bounded(key, text, std::move(value), *number, *number);
}

Expected<Value> numberValue(std::string_view text, Value value) {
  const auto bare = parseNumber(text);
  if (bare) {
    value.number = *bare;
    return value;
  }
  for (const Dimension d : {Dimension::Length, Dimension::Force, Dimension::Time, Dimension::Stiffness})
    if (const auto with_unit = parseQuantity(text, d)) {
      value.number = *with_unit;
      value.words = {std::string(codeUnit(d))};
      return value;
    }
  return bare.problem();
}

// The present word for one that lessons of earlier versions contain: a method's former name.
std::string_view presentWord(const KeySpec& key, std::string_view word) {
  const Method* method = findMethod(word);
  return method && std::find(key.words.begin(), key.words.end(), method->name) != key.words.end() ? method->name : word;
}

Expected<Value> wordsValue(const KeySpec& key, std::string_view text, Value value, bool list) {
  const std::vector<std::string_view> parts = list ? commaParts(text) : std::vector<std::string_view>{text};
  for (const std::string_view part : parts) {
    if (part.empty()) return at(text, part, tr("a word is missing"), tr("take out the comma"));
    const std::string_view word = presentWord(key, part);
    if (std::find(key.words.begin(), key.words.end(), word) == key.words.end())
      return at(text, part, trf("'{0}' cannot be '{1}'", key.name, part), suggest(part, key.words, tr("known")));
    value.words.emplace_back(word);
    value.places.push_back({0, at(text, part, {}).column});
  }
  return value;
}

Expected<Value> selectionValue(std::string_view text, std::string_view part, Value value) {
  Expected<Selection> read = selectionIn(text, part);
  if (!read) return read.problem();
  value.selection = *std::move(read);
  return value;
}

Expected<Value> targetValue(const KeySpec& key, std::string_view text, Value value) {
  if (std::find(key.words.begin(), key.words.end(), text) != key.words.end()) {
    value.words = {std::string(text)};
    return value;
  }
  auto selected = selectionValue(text, text, value);
  // A single misspelt word is more likely a word of the key than the start of a selection.
  if (!selected && text.find(' ') == std::string_view::npos)
    for (const std::string_view word : key.words)
      if (editDistance(word, text) <= std::max<std::size_t>(1, word.size() / 3))
        return at(text, text, trf("'{0}' cannot be '{1}'", key.name, text), didYouMean(word));
  return selected;
}

// "then" is not a word of the selection language: outside quotes it always separates two places.
Expected<Value> pathValue(const KeySpec& key, std::string_view text, Value value) {
  if (std::find(key.words.begin(), key.words.end(), text) != key.words.end()) {
    value.words = {std::string(text)};
    return value;
  }
  for (const std::string_view part : values::unquotedParts(text, " then ")) {
    if (part.empty() || part == "then" || part.starts_with("then ") || part.ends_with(" then"))
      return at(text, part, tr("a place is missing beside 'then'"), tr("name atoms on both sides of it"));
    auto read = selectionIn(text, part);
    if (!read) return read.problem();
    value.path.push_back(*std::move(read));
    value.places.push_back({0, at(text, part, {}).column});
  }
  return value;
}

// "STYLE", "STYLE 40%", "STYLE for SELECTION", "STYLE 40% for SELECTION", separated by commas. A comma in quotes
// belongs to a name.
Expected<Value> stylesValue(const KeySpec& key, std::string_view text, Value value) {
  constexpr double kMin_percent = 5.0, kMax_percent = 100.0;
  for (const std::string_view part : values::unquotedParts(text, ",")) {
    if (part.empty()) return at(text, part, tr("a style is missing"), tr("take out the comma"));
    const std::string_view name = part.substr(0, part.find(' '));
    const DrawStyleInfo* info = findDrawStyle(name);
    if (!info)
      return at(text, name, trf("'{0}' cannot be '{1}'", key.name, name), suggest(name, key.words, tr("known")));
    StyleSpec spec{.style = info->style, .opacity = 1.0, .atoms = {}, .place = {}};
    std::string_view after = stripped(part.substr(name.size()));
    if (const std::size_t percent = after.find('%'); percent != std::string_view::npos && !after.starts_with("for ")) {
      const std::string_view figure = stripped(after.substr(0, percent));
      const auto number = parseNumber(figure);
      if (!number || *number < kMin_percent || *number > kMax_percent)
        return at(text, figure, trf("'{0}' is no opacity", figure),
                  tr("write 5\u00a0% to 100\u00a0%, as in 'surface 40%'"));
      spec.opacity = *number / 100.0;
      after = stripped(after.substr(percent + 1));
    }
    if (after.starts_with("for ")) {
      const std::string_view atoms = stripped(after.substr(4));
      auto read = selectionIn(text, atoms);
      if (!read) return read.problem();
      spec.atoms = *std::move(read);
      spec.place = {0, at(text, atoms, {}).column};
    } else if (!after.empty()) {
      return at(text, after, trf("'{0}' is not understood after the style", after),
                tr("write 'for' and the atoms, as in 'sticks for ligand'"));
    }
    value.styles.push_back(std::move(spec));
  }
  return value;
}

// The atoms of a view without its keyword, as a selection: "residue 35 52" for "residue 35 52" and for "resi 35+52".
// Empty for other texts.
std::string atomsMeant(const KeySpec& key, std::string_view text) {
  const std::size_t blank = text.find(' ');
  if (blank == std::string_view::npos || std::find(key.words.begin(), key.words.end(), text) != key.words.end())
    return {};
  for (const std::string& atoms :
       {std::string(text), withBlanks(text), inOurLanguage(text.substr(0, blank), stripped(text.substr(blank)))})
    if (!atoms.empty() && parseSelection(atoms)) return atoms;
  return {};
}

// "front", "facing SELECTION" or "turned 30 10 0", optionally followed by ", zoom SELECTION"; or "zoom SELECTION"
// alone. A comma in quotes belongs to a name.
Expected<Value> viewValue(const KeySpec& key, std::string_view text, Value value) {
  constexpr std::string_view kZoom = "zoom ", kFacing = "facing ", kTurned = "turned ";
  ViewSpec view;
  view.text = std::string(text);
  bool quoted_name = false;
  std::size_t comma = 0;
  while (comma < text.size() && (quoted_name || text[comma] != ','))
    quoted_name = quoted_name != (text[comma++] == '"');
  std::string_view way = stripped(text.substr(0, comma)), zoom;
  if (comma < text.size()) zoom = stripped(text.substr(comma + 1));
  if (way.starts_with(kZoom) && zoom.empty()) std::swap(way, zoom);
  if (comma < text.size() && !zoom.starts_with(kZoom))
    return at(text, zoom, trf("'{0}' is not understood after the comma", zoom),
              tr("write 'zoom' and the atoms, as in 'front, zoom ligand'"));
  if (!zoom.empty()) {
    const std::string_view atoms = stripped(zoom.substr(kZoom.size()));
    auto read = selectionValue(text, atoms, {});
    if (!read) return read.problem();
    view.zoom = read->selection;
    view.zoom_place = {0, at(text, atoms, {}).column};
  }
  if (way.starts_with(kFacing)) {
    const std::string_view atoms = stripped(way.substr(kFacing.size()));
    auto read = selectionValue(text, atoms, {});
    if (!read) return read.problem();
    view.side.clear();
    view.facing = read->selection;
    view.facing_place = {0, at(text, atoms, {}).column};
  } else if (way.starts_with(kTurned)) {
    view.side.clear();
    view.turned_deg = std::array{0.0, 0.0, 0.0};
    std::string_view rest = stripped(way.substr(kTurned.size()));
    std::size_t count = 0;
    while (!rest.empty()) {
      const std::string_view word = rest.substr(0, rest.find(' '));
      rest = stripped(rest.substr(word.size()));
      const auto degrees = parseNumber(word.ends_with("°") ? word.substr(0, word.size() - 2) : word);
      if (!degrees || std::abs(*degrees) > 360.0 || count == 3)
        return at(
            text, word, trf("'{0}' is no angle of a view", word),
            tr("write two or three angles: to the right, above, and round the line of sight, as in 'turned 30 10 0'"));
      (*view.turned_deg)[count++] = *degrees;
    }
    if (count < 2)
      return at(text, way, tr("a view is turned by two or three angles"),
                tr("write them as in 'turned 30 10': to the right, and above"));
  } else if (!way.empty()) {
    const auto word = wordsValue(key, way, {}, false);
    if (!word) {
      Problem p = word.problem();
      p.column += at(text, way, {}).column - 1;
      return p;
    }
    view.side = word->words[0];
  }
  value.view = std::move(view);
  return value;
}

// "go to STEP", "skip STEP", "skip #one, #another". Headings may contain commas; links do not.
Expected<Value> wayValue(std::string_view text, Value value) {
  constexpr std::string_view kGoTo = "go to ", kSkip = "skip ";
  value.skips = text.starts_with(kSkip);
  if (!value.skips && !text.starts_with(kGoTo))
    return at(text, text, trf("'{0}' does not say where to go", text),
              tr("write 'go to' or 'skip' and a step's heading, as in 'go to #aside-what-a-crease-is'"));
  const std::string_view steps = stripped(text.substr(value.skips ? kSkip.size() : kGoTo.size()));
  const auto parts = steps.starts_with('#') ? commaParts(steps) : std::vector<std::string_view>{steps};
  for (const std::string_view part : parts) {
    if (part.empty()) return at(text, part, tr("a step is missing"), tr("take out the comma"));
    value.words.emplace_back(part);
    value.places.push_back({0, at(text, part, {}).column});
  }
  if (!value.skips && parts.size() > 1)
    return at(text, parts[1], tr("one can go to one step only"), tr("take the others out, or write 'skip'"));
  return value;
}

}  // namespace

std::optional<Problem> addRemark(Value& value, std::string_view line) {
  for (const std::string_view arrow : {std::string_view("→"), std::string_view("->")}) {
    const std::size_t at_arrow = line.find(arrow);
    if (at_arrow == std::string_view::npos) continue;
    const std::string_view atoms = stripped(line.substr(0, at_arrow)),
                           text = stripped(line.substr(at_arrow + arrow.size()));
    if (text.empty()) return at(line, line, tr("nothing is said to this touch"), tr("write the sentence after '->'"));
    auto read = selectionValue(line, atoms, {});
    if (!read) return read.problem();
    value.remarks.push_back({read->selection, std::string(text), {0, at(line, atoms, {}).column}});
    return std::nullopt;
  }
  return at(line, line, tr("no '->' separates the atoms from the feedback to their touch"),
            tr("write it as 'residue 35 -> That is the other acid.'"));
}

Expected<Value> parseValue(const KeySpec& key, std::string_view text) {
  Value value;
  value.text = std::string(text);
  if (text.empty()) return Problem{{}, 0, 1, trf("'{0}' has no value", key.name), tr("write it after the colon")};
  switch (key.type) {
    case ValueType::Text:
      return value;
    case ValueType::TextList:
      for (const std::string_view part : commaParts(text))
        if (!part.empty()) {
          value.words.emplace_back(part);
          value.places.push_back({0, at(text, part, {}).column});
        }
      return value;
    case ValueType::Count:
      return countValue(key, text, std::move(value));
    case ValueType::Number:
      return numberValue(text, std::move(value));
    case ValueType::Quantity: {
      const auto number = key.dimension == Dimension::None ? parseNumber(text) : parseQuantity(text, key.dimension);
      if (!number) return number.problem();
      value.number = *number;
      return bounded(key, text, std::move(value), *number, *number);
    }
    case ValueType::Range: {
      const auto range = parseRange(text, key.dimension);
      if (!range) return range.problem();
      value.low = range->low;
      value.high = range->high;
      return bounded(key, text, std::move(value), range->low, range->high);
    }
    case ValueType::Word:
      return wordsValue(key, text, std::move(value), false);
    case ValueType::WordList:
      return wordsValue(key, text, std::move(value), true);
    case ValueType::Selection:
      return selectionValue(text, text, std::move(value));
    case ValueType::Target:
      return targetValue(key, text, std::move(value));
    case ValueType::Path:
      return pathValue(key, text, std::move(value));
    case ValueType::View:
      // Atoms without the keyword.
      if (const std::string atoms = atomsMeant(key, text); !atoms.empty())
        return at(text, text, trf("'{0}' cannot be '{1}'", key.name, text), trf("write 'facing {0}'", atoms));
      return viewValue(key, text, std::move(value));
    case ValueType::Remarks:
      if (auto problem = addRemark(value, text)) return *std::move(problem);
      return value;
    case ValueType::Facts:
      if (auto problem = addFact(key, value, text)) return *std::move(problem);
      return value;
    case ValueType::Counts:
      for (const std::string_view part : commaParts(text)) {
        const auto one = countValue(key, part, {});
        if (!one) {
          Problem p = one.problem();
          p.column = at(text, part, {}).column;
          return p;
        }
        value.counts.push_back(static_cast<std::size_t>(one->number));
        value.places.push_back({0, at(text, part, {}).column});
      }
      return value;
    case ValueType::Way:
      return wayValue(text, std::move(value));
    case ValueType::Styles:
      return stylesValue(key, text, std::move(value));
    case ValueType::Marks:
      return values::marksValue(key, text, std::move(value));
    case ValueType::Places:
      return values::placesValue(key, text, std::move(value));
  }
  return value;
}

}  // namespace moltact
