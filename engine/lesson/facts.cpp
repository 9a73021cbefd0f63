#include "engine/lesson/facts.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "engine/language/catalogue.h"
#include "engine/lesson/reading_keys.h"
#include "engine/lesson/touch_keys.h"
#include "engine/lesson/value_parts.h"

namespace moltact {
namespace {

using values::at;

constexpr std::size_t kMaxFacts = 200;  // of one kind in a block
constexpr double kRounding = 1e-9;

KeySpec fact(std::string_view name, std::string_view meaning, Dimension dimension, int least = 1, int most = 0) {
  return {.name = name,
          .type = ValueType::Facts,
          .meaning = meaning,
          .dimension = dimension,
          .min = double(least),
          .max = double(std::max(least, most))};
}

struct Stated {
  double value = 0.0, half_digit = 0.0;
};

// "9.3 Å" to 9.3 and 0.05, in the code's unit; a count has no half digit.
Expected<Stated> statedNumber(const KeySpec& key, std::string_view text) {
  const bool counted = key.dimension == Dimension::None;
  const auto number = counted ? parseNumber(text) : parseQuantity(text, key.dimension);
  if (!number) return number.problem();
  if (counted) {
    if (*number != std::floor(*number)) return at(text, text, trf("'{0}' is not a whole number", text));
    return Stated{*number, 0.0};
  }
  const std::size_t end = std::min(text.find_first_not_of("+-.0123456789"), text.size()), point = text.find('.');
  const auto decimals = point < end ? double(end - point - 1) : 0.0;
  const auto unit = parseQuantity("1" + std::string(text.substr(end)), key.dimension);
  return Stated{*number, unit ? 0.5 * *unit * std::pow(10.0, -decimals) : 0.0};
}

// The last '=', '<' or '>' between blanks outside of quotes.
std::size_t relationIn(std::string_view line) {
  bool quoted = false;
  std::size_t last = std::string_view::npos;
  for (std::size_t i = 0; i < line.size(); ++i) {
    quoted = quoted != (line[i] == '"');
    if (!quoted && i > 0 && line[i - 1] == ' ' && i + 1 < line.size() && line[i + 1] == ' ' &&
        (line[i] == '=' || line[i] == '<' || line[i] == '>'))
      last = i;
  }
  return last;
}

const char* example(const KeySpec& key) {
  switch (key.dimension) {
    case Dimension::Length:
      return key.min > 1 ? N_("write it as 'residue 35 - residue 52 = 5.8 Å'") : N_("write it as 'residue 35 = 1.4 Å'");
    case Dimension::Angle:
      return N_("write it as 'name N - name CA - name C = 110°'");
    case Dimension::Share:
      return N_("write it as 'residue 35 and name OE1 = 36 %'");
    default:
      return N_("write it as 'chain A and name CA = 146'");
  }
}

}  // namespace

bool FactSpec::holds(double computed) const {
  if (relation == Relation::Less) return computed < high;
  if (relation == Relation::More) return computed > low;
  return computed >= low - half_digit - kRounding && computed <= high + half_digit + kRounding;
}

std::vector<KeySpec> factKeys() {
  std::vector<KeySpec> out{
      {.name = "molecule",
       .type = ValueType::Text,
       .meaning =
           "The molecule of the facts, read with the options of this block. By default the scene's molecule with the "
           "scene's options, without the atoms that the scene removes."}};
  for (const ReadingOption& option : readingOptions()) {
    out.push_back(readingKey(option));
    out.back().fallback = {};  // the scene's
  }
  const KeySpec others[]{
      {.name = "remove",
       .type = ValueType::Target,
       .meaning = "Atoms that are taken out before anything is computed. 'none' keeps all.",
       .words = {"none"}},
      {.name = "probe",
       .type = ValueType::Quantity,
       .meaning =
           "The radius of the probe of `turn`, `touched`, `reached` and `share`. By default that of the scene's probe.",
       .dimension = Dimension::Length,
       .max = 20.0},
      fact("atoms", "The number of atoms.", Dimension::None),
      fact("residues", "The number of residues that have such an atom.", Dimension::None),
      fact("chains", "The number of chains that have such an atom.", Dimension::None),
      fact("nearest", "The smallest distance between the centres of two atoms, one of each selection.",
           Dimension::Length, 2),
      fact("farthest", "The largest distance between the centres of two atoms, one of each selection.",
           Dimension::Length, 2),
      fact("distance", "The distance between the middles of two selections.", Dimension::Length, 2),
      fact("gap",
           "The smallest distance between the van der Waals surfaces of two atoms, one of each selection; "
           "negative where they overlap.",
           Dimension::Length, 2),
      fact("out-of-plane", "The distance of the middle of the first selection from the mean plane of the second.",
           Dimension::Length, 2),
      fact("radius", "The van der Waals radius of every atom.", Dimension::Length),
      fact("angle", "The angle at the second of three middles, or the torsion of four, from -180° to 180°.",
           Dimension::Angle, 3, 4),
      fact("turn", "The angle by which the force turns where the probe crosses from one atom to the other.",
           Dimension::Angle, 2),
      fact("touched", "The number of atoms that the probe touches on a straight line from outside, in any direction.",
           Dimension::None),
      fact("reached", "The number of atoms that the probe touches on any path from outside.", Dimension::None),
      fact("share", "How much of an atom's sphere the probe can touch, on any path from outside.", Dimension::Share),
      fact("largest", "The radius of the largest probe that touches any of the atoms on a straight line from outside.",
           Dimension::Length),
  };
  out.insert(out.end(), std::begin(others), std::end(others));
  return out;
}

std::optional<Problem> addFact(const KeySpec& key, Value& value, std::string_view line) {
  const std::size_t sign = relationIn(line);
  if (sign == std::string_view::npos)
    return at(line, line, tr("no ' = ' separates the atoms from the number"), tr(example(key)));
  FactSpec out;
  out.relation = line[sign] == '='   ? FactSpec::Relation::Equal
                 : line[sign] == '<' ? FactSpec::Relation::Less
                                     : FactSpec::Relation::More;
  const std::string_view atoms = stripped(line.substr(0, sign)), number = stripped(line.substr(sign + 1));
  for (const std::string_view part : values::unquotedParts(atoms, " - ")) {
    Expected<Selection> read = values::selectionIn(line, part);
    if (!read) return read.problem();
    out.atoms.push_back(*std::move(read));
    out.places.push_back({0, at(line, part, {}).column});
  }
  if (double(out.atoms.size()) < key.min || double(out.atoms.size()) > key.max)
    return at(line, line,
              trf("'{0}' is computed from {1} selections, not from {2}", key.name, int(key.min), out.atoms.size()),
              tr(example(key)));
  const std::size_t to = out.relation == FactSpec::Relation::Equal ? number.find(" to ") : std::string_view::npos;
  const std::string_view high = to == std::string_view::npos ? number : stripped(number.substr(to + 4));
  for (const std::string_view bound : {number.substr(0, to), high}) {
    const Expected<Stated> read = statedNumber(key, stripped(bound));
    if (!read) {
      Problem p = read.problem();
      p.column += at(line, stripped(bound), {}).column - 1;
      return p;
    }
    (bound.data() == number.data() ? out.low : out.high) = read->value;
    if (bound.data() == high.data()) out.high = read->value;
    out.half_digit = read->half_digit;
  }
  if (out.low > out.high)
    return at(line, number, tr("the range ends below its start"), tr("write the smaller value first"));
  if (value.facts.size() == kMaxFacts) return at(line, line, tr("more than 200 of them"), tr("take some out"));
  out.stated = std::string(number);
  out.place = {0, at(line, stripped(line), {}).column};
  value.facts.push_back(std::move(out));
  return std::nullopt;
}

std::string computedText(const KeySpec& kind, const FactSpec& fact, double computed) {
  const double unit = kind.dimension == Dimension::Share ? 0.01 : 1.0;
  const int decimals =
      fact.half_digit > 0.0 ? std::clamp(1 - int(std::floor(std::log10(2.0 * fact.half_digit / unit) + 0.5)), 0, 6) : 0;
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, computed / unit);
  const std::string_view symbol = kind.dimension == Dimension::Share ? "%" : codeUnit(kind.dimension);
  return std::string(text) + (symbol.empty() || symbol == "°" ? "" : " ") + std::string(symbol);
}

}  // namespace moltact
