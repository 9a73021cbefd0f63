#include "engine/structure/map_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <limits>

#include "engine/language/catalogue.h"
#include "engine/platform/read_file.h"

namespace moltact {
namespace {

constexpr double kMapCeiling = 1e5;

constexpr const char* kMapRemedy =
    N_("the first six lines are GRID_PARAMETER_FILE, GRID_DATA_FILE, MACROMOLECULE, SPACING, NELEMENTS and CENTER; "
       "write the map again with autogrid4 or with moltact grid");

// Words of a text, line by line.
class MapWords {
 public:
  explicit MapWords(std::string_view text) : rest_(text) {}

  bool nextLine(std::string_view& line) {
    if (rest_.empty()) return false;
    ++number_;
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    line = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    return true;
  }
  std::size_t number() const { return number_; }

 private:
  std::string_view rest_;
  std::size_t number_ = 0;
};

// Takes the next word of a line; empty at its end.
std::string_view mapWord(std::string_view& line) {
  constexpr std::string_view kMapBlank = " \t\r";
  line.remove_prefix(std::min(line.find_first_not_of(kMapBlank), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(kMapBlank));
  line.remove_prefix(word.size());
  return word;
}

template <class Number>
bool mapNumber(std::string_view word, Number& value) {
  if (word.size() > 1 && word[0] == '+') word.remove_prefix(1);
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  return error == std::errc{} && end == word.data() + word.size();
}

struct MapHeader {
  double spacing_A = 0;
  std::array<int, 3> intervals{};
  Vec3 centre_A{0.0};
  std::string molecule;
};

std::optional<Problem> readMapHeader(MapWords& words, const std::string& file, MapHeader& out) {
  constexpr const char* kKeys[6] = {"GRID_PARAMETER_FILE", "GRID_DATA_FILE", "MACROMOLECULE", "SPACING",
                                    "NELEMENTS",           "CENTER"};
  for (int k = 0; k < 6; ++k) {
    std::string_view line;
    if (!words.nextLine(line))
      return Problem{file, words.number(), 0, trf("the map ends before its line {0}", kKeys[k]), tr(kMapRemedy)};
    if (mapWord(line) != kKeys[k])
      return Problem{file, words.number(), 1, trf("expected the line {0} of an AutoGrid map", kKeys[k]),
                     tr(kMapRemedy)};
    const auto bad = [&] {
      return Problem{file, words.number(), 0, trf("the line {0} is not of numbers", kKeys[k]), tr(kMapRemedy)};
    };
    if (k == 2) out.molecule = std::string(mapWord(line));
    if (k == 3 && !mapNumber(mapWord(line), out.spacing_A)) return bad();
    if (k < 4) continue;
    for (int axis = 0; axis < 3; ++axis) {
      const std::string_view word = mapWord(line);
      if (k == 4 ? !mapNumber(word, out.intervals[std::size_t(axis)]) : !mapNumber(word, out.centre_A[axis]))
        return bad();
    }
    if (k == 5 && (!finite(out.centre_A) || glm::length(out.centre_A) > 1e6))
      return Problem{file, words.number(), 0, tr("the centre of the map is not within 1e6 Å"), tr(kMapRemedy)};
  }
  return std::nullopt;
}

std::optional<Problem> checkMapBox(const MapHeader& header, const std::string& file, GridBox& box) {
  if (!(header.spacing_A >= kMinGridSpacing_A && header.spacing_A <= kMaxGridSpacing_A))
    return Problem{file, 4, 0, tr("the spacing of the grid is not from 0.05 to 10 Å"), tr("0.375 Å is customary")};
  double count = 1.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const int n = header.intervals[axis];
    if (n < 3 || n > int(kMaxGridNodes))
      return Problem{file, 5, 0, trf("a map has at least 3 intervals along each axis, not {0}", n), tr(kMapRemedy)};
    box.nodes[axis] = n + 1;
    count *= double(n) + 1.0;
  }
  if (count > double(kMaxGridNodes))
    return Problem{file, 5, 0, tr("the grid would have more than 67 million points"),
                   tr("choose a wider spacing or a smaller box")};
  box.spacing_A = header.spacing_A;
  box.first_A =
      header.centre_A - 0.5 * header.spacing_A * Vec3(header.intervals[0], header.intervals[1], header.intervals[2]);
  return std::nullopt;
}

}  // namespace

Expected<MapFile> readMap(std::string_view text, const std::string& file) {
  MapWords words(text);
  MapHeader header;
  MapFile out;
  if (auto problem = readMapHeader(words, file, header)) return *std::move(problem);
  if (auto problem = checkMapBox(header, file, out.box)) return *std::move(problem);
  out.molecule = std::move(header.molecule);
  const std::size_t count = out.box.count();
  // A header of millions of points before a short text reserves no memory for them.
  out.values.reserve(std::min(count, text.size() / 2 + 1));
  for (std::string_view line; words.nextLine(line);)
    for (std::string_view word; !(word = mapWord(line)).empty();) {
      double value = 0;
      if (!mapNumber(word, value) || !(std::abs(value) <= kMaxMapValue))
        return Problem{file, words.number(), 0,
                       trf("expected an energy in kcal/mol, found \"{0}\"", word.substr(0, 24)),
                       tr("write the map again with autogrid4 or with moltact grid")};
      if (out.values.size() == count)
        return Problem{file, words.number(), 0, trf("the map has more values than its {0} points", count),
                       tr("NELEMENTS gives the intervals: one less than the points along each axis")};
      out.values.push_back(float(value));
    }
  if (out.values.size() < count)
    return Problem{file, words.number(), 0,
                   trf("the map has only {0} of the {1} values of its points", out.values.size(), count),
                   tr("the file is cut short; copy it or write it again")};
  return out;
}

Expected<MapFile> readMapFile(const std::filesystem::path& file) {
  const auto text = readFile(file, kMaxMapBytes, tr("choose a wider spacing or a smaller box"));
  if (!text) return text.problem();
  return readMap(*text, file.string());
}

Expected<GridBox> mapBoxRound(const Vec3& low, const Vec3& high, double spacing_A) {
  const auto round = gridBoxRound(low, high, spacing_A);
  if (!round) return round;
  // A cell more for the centre's rounding and for an even number of intervals.
  GridBox box = *round;
  double count = 1.0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    box.nodes[axis] += box.nodes[axis] % 2 ? 2 : 1;
    count *= box.nodes[axis];
  }
  if (count > double(kMaxGridNodes)) return gridBoxRound(Vec3(0.0), Vec3(1e6), spacing_A);  // its Problem
  const Vec3 intervals(box.nodes[0] - 1, box.nodes[1] - 1, box.nodes[2] - 1);
  const Vec3 centre = glm::round(0.5e3 * (low + high)) / 1e3;
  box.first_A = centre - 0.5 * spacing_A * intervals;
  return box;
}

std::string mapText(const GridBox& box, std::span<const float> values, std::string_view stem,
                    std::string_view molecule) {
  const auto number = [](double value, int decimals) {
    char text[64];
    const int length = std::snprintf(text, sizeof text, "%.*f", decimals, value);
    return std::string(text, std::size_t(std::max(length, 0)));
  };
  char spacing[32]{};
  const auto [end, error] = std::to_chars(spacing, spacing + sizeof spacing, box.spacing_A);
  const Vec3 centre = box.first_A + 0.5 * box.spacing_A * Vec3(box.nodes[0] - 1, box.nodes[1] - 1, box.nodes[2] - 1);
  std::string out = "GRID_PARAMETER_FILE none\nGRID_DATA_FILE " + std::string(stem) + ".maps.fld\nMACROMOLECULE " +
                    std::string(molecule) + "\nSPACING " + std::string(spacing, end) + "\nNELEMENTS";
  for (const int n : box.nodes) out += ' ' + std::to_string(n - 1);
  out += "\nCENTER";
  for (int axis = 0; axis < 3; ++axis) out += ' ' + number(centre[axis], 3);
  out += '\n';
  out.reserve(out.size() + 10 * values.size());
  for (const float value : values) {
    char text[64];
    const int length = std::snprintf(text, sizeof text, "%.4f\n", std::clamp(double(value), -kMapCeiling, kMapCeiling));
    out.append(text, std::size_t(std::max(length, 0)));
  }
  return out;
}

std::string mapFieldText(const GridBox& box, std::string_view stem, std::string_view molecule,
                         std::span<const std::string> names) {
  std::string out =
      "# AVS field file\n#\n# Created by moltact grid.\n#\n#MACROMOLECULE " + std::string(molecule) + "\n#\nndim=3\n";
  for (std::size_t axis = 0; axis < 3; ++axis)
    out += "dim" + std::to_string(axis + 1) + '=' + std::to_string(box.nodes[axis]) + '\n';
  out += "nspace=3\nveclen=" + std::to_string(names.size()) + "\ndata=float\nfield=uniform\n";
  for (int axis = 0; axis < 3; ++axis)
    out += "coord " + std::to_string(axis + 1) + " file=" + std::string(stem) +
           ".maps.xyz filetype=ascii offset=" + std::to_string(2 * axis) + '\n';
  for (const std::string& name : names) out += "label=" + (name == "e" ? "Electrostatics" : name + "-affinity") + '\n';
  for (std::size_t k = 0; k < names.size(); ++k)
    out += "variable " + std::to_string(k + 1) + " file=" + std::string(stem) + '.' + names[k] +
           ".map filetype=ascii skip=6\n";
  return out;
}

std::string mapCornersText(const GridBox& box) {
  const Vec3 last = box.node(box.nodes[0] - 1, box.nodes[1] - 1, box.nodes[2] - 1);
  std::string out;
  for (int axis = 0; axis < 3; ++axis) {
    char text[96];
    const int length = std::snprintf(text, sizeof text, "%.4f %.4f\n", box.first_A[axis], last[axis]);
    out.append(text, std::size_t(std::max(length, 0)));
  }
  return out;
}

MapAgreement mapAgreement(std::span<const float> map, std::span<const float> other,
                          const std::function<bool(std::size_t)>& counts) {
  MapAgreement out;
  double x = 0, y = 0, xx = 0, yy = 0, xy = 0;
  for (std::size_t k = 0; k < map.size(); ++k) {
    if (!counts(k)) continue;
    const double a = other[k], b = map[k];
    ++out.points;
    x += a, y += b, xx += a * a, yy += b * b, xy += a * b;
  }
  if (out.points == 0) return out;
  const double n = double(out.points), spread = (xx - x * x / n) * (yy - y * y / n);
  if (spread > 0.0) out.correlation = (xy - x * y / n) / std::sqrt(spread);
  if (xx > 0.0) out.factor = xy / xx;
  double squares = 0.0;
  for (std::size_t k = 0; k < map.size(); ++k) {
    if (!counts(k)) continue;
    const double off = std::abs(double(map[k]) - out.factor * double(other[k]));
    squares += off * off;
    out.largest = std::max(out.largest, off);
  }
  out.rms = std::sqrt(squares / n);
  return out;
}

}  // namespace moltact
