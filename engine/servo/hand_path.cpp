#include "engine/servo/hand_path.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>

#include "engine/core/text.h"
#include "engine/haptics/hip_input.h"
#include "engine/haptics/sweep.h"
#include "engine/platform/read_file.h"

namespace moltact {
namespace {

constexpr std::size_t kMaxPathBytes = std::size_t{1} << 30;
constexpr std::size_t kMaxTicks = 25'000'000;  // seven hours; also the limit on rows
constexpr std::size_t kMaxLineBytes = 64 << 10, kMaxLabels = 1000;
constexpr std::array<std::string_view, 7> kColumns{"t", "x", "y", "z", "fx", "fy", "fz"};
constexpr std::string_view kBlanks = " \t,;";

std::vector<std::string> words(std::string_view line) {
  std::vector<std::string> out;
  for (std::size_t at = 0; (at = line.find_first_not_of(kBlanks, at)) != std::string_view::npos;) {
    const std::size_t end = std::min(line.find_first_of(kBlanks, at), line.size());
    out.emplace_back(line.substr(at, end - at));
    at = end;
  }
  return out;
}

std::optional<double> number(std::string_view word) {
  if (word.size() > 1 && word[0] == '+') word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

bool isComment(std::string_view line) {
  return line.starts_with('#') || line.starts_with('%') || line.starts_with(';') || line.starts_with("//");
}

// The meaning of a row's numbers; -1: ignored.
using Columns = std::vector<int>;

std::optional<Columns> columnsNamed(const std::vector<std::string>& names) {
  Columns out;
  int places = 0;
  for (const std::string& name : names) {
    const std::string key = lower(name) == "time" ? "t" : lower(name);
    const auto found = std::find(kColumns.begin(), kColumns.end(), key);
    out.push_back(found == kColumns.end() ? -1 : int(found - kColumns.begin()));
    places += out.back() >= 1 && out.back() <= 3;
  }
  if (places != 3) return std::nullopt;
  return out;
}

Columns columnsOf(std::size_t count) {
  if (count == 3) return {1, 2, 3};
  if (count == 4) return {0, 1, 2, 3};
  Columns out{0, 1, 2, 3, 4, 5, 6};
  out.resize(std::max<std::size_t>(count, 7), -1);
  return out;
}

struct Row {
  std::array<double, 7> value{};
  std::size_t line = 0;
};

// Interpolates the position at every tick from rows with their own times.
void sample(const std::vector<Row>& rows, const std::vector<double>& time_s, bool forces, double scale, HandPath& out) {
  const double length_s = time_s.back() - time_s.front();
  const auto ticks = static_cast<std::size_t>(std::floor(length_s / kTick_s + 1e-6)) + 1;
  out.places.reserve(ticks);
  std::size_t row = 0;
  for (std::size_t k = 0; k < ticks; ++k) {
    const double t = time_s.front() + double(k) * kTick_s;
    while (row + 2 < rows.size() && time_s[row + 1] < t) ++row;
    const std::size_t next = std::min(row + 1, rows.size() - 1);
    const double part = next == row ? 0.0 : std::clamp((t - time_s[row]) / (time_s[next] - time_s[row]), 0.0, 1.0);
    const auto place = [&](const Row& r) { return Vec3(r.value[1], r.value[2], r.value[3]) * scale; };
    out.places.push_back(glm::mix(place(rows[row]), place(rows[next]), part));
    const auto& f = rows[part < 0.5 ? row : next].value;
    if (forces) out.touched.push_back(std::hypot(f[4], f[5], f[6]) > 0);
  }
}

}  // namespace

Expected<HandPath> readHandPath(const std::filesystem::path& file) {
  const std::string name = file.string();
  const auto bytes = readFile(file, kMaxPathBytes, "split it into shorter ways");
  if (!bytes) return bytes.problem();
  std::string_view text = *bytes;
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // a byte order mark, written by some spreadsheets

  HandPath out;
  out.name = file.stem().string();
  std::optional<Columns> columns;
  std::vector<Row> rows;
  std::size_t line_number = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    const std::string_view line = trimmed(text.substr(at, end - at));
    at = end + 1;
    ++line_number;
    if (line.size() > kMaxLineBytes)
      return Problem{name, line_number, 1, "this line is longer than 64 KiB", "write a row a line"};
    if (line.empty()) continue;
    if (isComment(line)) {
      const std::string_view said = trimmed(line.substr(std::min(line.find_first_not_of("#%;/"), line.size())));
      const std::size_t colon = said.find(':');
      if (colon == std::string_view::npos || said.substr(0, colon).find_first_of(" \t") != std::string_view::npos)
        continue;
      const std::string key(trimmed(said.substr(0, colon))), value(trimmed(said.substr(colon + 1)));
      out.labels[key] = value;
      if (out.labels.size() > kMaxLabels)
        return Problem{name, line_number, 1, "there are more than 1000 labels", "leave some out"};
      if (key == "columns" && !(columns = columnsNamed(words(value))))
        return Problem{name, line_number, 1, "these columns do not name x, y and z once each",
                       "write for example \"# columns: t x y z\""};
      continue;
    }
    const std::vector<std::string> fields = words(line);
    if (fields.empty()) continue;  // separators only
    if (rows.empty() && !number(fields.front())) {
      if (const auto named = columnsNamed(fields)) columns = named;
      ++out.passed_over;
      continue;
    }
    if (!columns) {
      if (fields.size() < 3 || fields.size() == 5 || fields.size() == 6)
        return Problem{name, line_number, 1,
                       "what " + std::to_string(fields.size()) + " numbers in a row mean is not known",
                       "say so before the first row, for example \"# columns: x y z fx fy fz\""};
      columns = columnsOf(fields.size());
    }
    if (fields.size() < columns->size())
      return Problem{
          name, line_number, 1,
          "this row has " + std::to_string(fields.size()) + " numbers instead of " + std::to_string(columns->size()),
          "write every row alike"};
    Row row;
    row.line = line_number;
    for (std::size_t k = 0; k < columns->size(); ++k) {
      if ((*columns)[k] < 0) continue;
      const auto value = number(fields[k]);
      if (!value)
        return Problem{name, line_number, 1, "\"" + fields[k] + "\" is no finite number",
                       "write a number, with a point before its fraction"};
      row.value[std::size_t((*columns)[k])] = *value;
    }
    if (rows.size() == kMaxTicks)
      return Problem{name, line_number, 1, "there are more than 25 million rows", "split it into shorter ways"};
    rows.push_back(row);
  }
  if (rows.empty())
    return Problem{name, 0, 0, "there is no row of numbers in this file", "write a row a tick: x y z, or t x y z"};

  const std::string unit = out.label("unit").empty() ? "mm" : out.label("unit");
  const double scale = unit == "A" || unit == "mm" ? 1.0 : unit == "cm" ? 10.0 : unit == "m" ? 1000.0 : 0.0;
  if (scale == 0.0)
    return Problem{name, 0, 0, "the unit \"" + unit + "\" is not known", "write \"# unit: A\", mm, cm or m"};
  out.on_molecule = unit == "A";
  const std::string time_unit = out.label("time_unit").empty() ? "s" : out.label("time_unit");
  if (time_unit != "s" && time_unit != "ms")
    return Problem{name, 0, 0, "the time unit \"" + time_unit + "\" is not known", "write \"# time_unit: s\" or ms"};
  double tick_s = kTick_s;
  for (const auto& [key, target] : {std::pair<const char*, double*>{"tick_s", &tick_s}, {"probe_A", &out.probe_A}})
    if (const std::string said = out.label(key); !said.empty()) {
      const auto value = number(said);
      if (!value || *value < 0 || (*value == 0 && target == &tick_s))
        return Problem{name, 0, 0, "\"" + said + "\" is no " + std::string(key), "write a positive number"};
      if (target == &out.probe_A && *value > kMaxProbe_A)
        return Problem{name, 0, 0, "a probe of " + said + " A is larger than 20 A", "write 0 to 20"};
      *target = *value;
    }

  const bool timed = std::find(columns->begin(), columns->end(), 0) != columns->end();
  const bool forces = std::find(columns->begin(), columns->end(), 4) != columns->end();
  std::vector<double> time_s;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    time_s.push_back(timed ? rows[k].value[0] * (time_unit == "ms" ? 1e-3 : 1.0) : double(k) * tick_s);
    if (k > 0 && !(time_s[k] > time_s[k - 1]))
      return Problem{name, rows[k].line, 1, "the time does not go on from the row before",
                     "put the rows in order, each with a later time"};
  }
  if (!(time_s.back() - time_s.front() < double(kMaxTicks) * kTick_s))
    return Problem{name, 0, 0, "it lasts longer than 25 000 s, which is 25 million ticks",
                   "say \"# time_unit: ms\" where the times are milliseconds, or split it into shorter ways"};
  for (const Row& row : rows)
    for (int k = 1; k <= 3; ++k)
      if (!(std::abs(row.value[std::size_t(k)] * scale) <= kMaxPosition_A))
        return Problem{name, row.line, 1, "this place is farther out than 1e9 " + std::string(unit == "A" ? "A" : "mm"),
                       "say the unit of the places, for example \"# unit: mm\""};
  sample(rows, time_s, forces, scale, out);
  return out;
}

HandPath handPathOf(const ServoRecording& recording, std::string name, Interaction* felt) {
  HandPath out;
  out.name = std::move(name);
  out.labels = recording.labels;
  if (!recording.ticks.empty()) out.probe_A = usableProbe_A(recording.ticks.front().settings.probe_A, kWaterProbe_A);
  ServoStep step = recording.start.value_or(ServoStep());
  for (const RecordedTick& tick : recording.ticks) {
    if (tick.other_device) step.setDevice(tick.device);
    const ServoSample sample = step.tick(tick.settings, felt, tick.pose, tick.time);
    const bool somewhere = usableHip(sample.hip.A);
    if (!somewhere && out.places.empty()) continue;
    out.places.push_back(somewhere ? sample.hip.A : Vec3(out.places.back()));
    out.touched.push_back(sample.contact.touching());
  }
  return out;
}

std::string textOf(const HandPath& path) {
  std::string out;
  char line[120];
  constexpr std::array<std::string_view, 5> kOwn{"columns", "unit", "probe_A", "tick_s", "time_unit"};
  for (const auto& [key, value] : path.labels)
    if (std::find(kOwn.begin(), kOwn.end(), key) == kOwn.end()) out += "# " + key + ": " + value + '\n';
  std::snprintf(line, sizeof line, "# probe_A: %g\n", path.probe_A);
  out += line;
  out += path.on_molecule ? "# unit: A\n# columns: x y z\n" : "# unit: mm\n# columns: x y z\n";
  for (const Vec3& p : path.places) {
    std::snprintf(line, sizeof line, "%.3f %.3f %.3f\n", p.x, p.y, p.z);
    out += line;
  }
  return out;
}

HandPath mappedTo(const HandPath& path, const SphereGrid& scene, double A_per_mm) {
  if (path.on_molecule) return path;
  Vec3 low(1e300), high(-1e300);
  const bool some = std::find(path.touched.begin(), path.touched.end(), true) != path.touched.end();
  for (std::size_t k = 0; k < path.places.size(); ++k)
    if (!some || path.touched[k]) low = glm::min(low, path.places[k]), high = glm::max(high, path.places[k]);
  // The first surface point straight from the front.
  Vec3 at = 0.5 * (scene.low_A() + scene.high_A());
  at.z = scene.high_A().z + path.probe_A + 1;
  const double through = glm::length(scene.high_A() - scene.low_A()) + 2 * (path.probe_A + 1);
  for (double gone = 0, gap = 0; gone < through && (gap = clearance(scene, path.probe_A, at)) > 1e-6; gone += gap)
    at.z -= gap;
  HandPath out = path;
  out.on_molecule = true;
  for (Vec3& p : out.places) p = at + (p - 0.5 * (low + high)) * A_per_mm;
  return out;
}

}  // namespace moltact
