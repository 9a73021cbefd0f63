#include "app/ui/files/settings.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <system_error>

#include "engine/language/catalogue.h"
#include "engine/language/units.h"
#include "engine/platform/write_file.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

void readNumber(const nlohmann::json& from, const char* key, double& to, double min, double max) {
  if (const auto it = from.find(key); it != from.end() && it->is_number()) {
    const double value = it->get<double>();
    if (std::isfinite(value)) to = std::clamp(value, min, max);
  }
}

constexpr std::array<std::string_view, 3> kProbeLooks{"water", "ball", "stylus"};

constexpr std::array<std::string_view, 3> kDecimalSigns{"language", "point", "comma"};

std::optional<DecimalSign> decimalSignNamed(std::string_view name) {
  const auto at = std::find(kDecimalSigns.begin(), kDecimalSigns.end(), name);
  if (at == kDecimalSigns.end()) return std::nullopt;
  return DecimalSign(at - kDecimalSigns.begin());
}

void readSwitch(const nlohmann::json& from, const char* key, bool& to) {
  if (const auto it = from.find(key); it != from.end() && it->is_boolean()) to = it->get<bool>();
}

// Ignores a unit that does not belong to the dimension.
void readUnit(const std::string& dimension, const nlohmann::json& unit, std::map<std::string, std::string>& to) {
  if (unit.is_string() && UnitSet().choose(dimension, unit.get<std::string>())) to[dimension] = unit.get<std::string>();
}

}  // namespace

std::string_view probeLookName(ProbeLook look) { return kProbeLooks[std::size_t(look)]; }

std::optional<ProbeLook> probeLookNamed(std::string_view name) {
  const auto at = std::find(kProbeLooks.begin(), kProbeLooks.end(), name);
  if (at == kProbeLooks.end()) return std::nullopt;
  return ProbeLook(at - kProbeLooks.begin());
}

void Settings::remember(const fs::path& file) {
  std::error_code ignored;
  const fs::path absolute = fs::absolute(file, ignored);
  const std::string name = (absolute.empty() ? file : absolute.lexically_normal()).string();
  std::erase(recent, name);
  recent.insert(recent.begin(), name);
  if (recent.size() > kRecent) recent.resize(kRecent);
}

LoadedSettings loadSettings(const fs::path& file) {
  LoadedSettings out;
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return out;
  std::ifstream in(file, std::ios::binary);
  std::stringstream text;
  text << in.rdbuf();
  const nlohmann::json json = nlohmann::json::parse(text.str(), nullptr, false);
  if (!in || !json.is_object()) {
    out.fault =
        trf("Your settings in {0} could not be read; the defaults are used and will replace them.", file.string());
    return out;
  }
  Settings& s = out.settings;
  if (const auto theme = json.find("theme"); theme != json.end() && theme->is_string())
    s.theme = themeNamed(theme->get<std::string>()).value_or(s.theme);
  readNumber(json, "scale", s.scale, 0.75, 3.0);
  readNumber(json, "text_size", s.text_size, 1.0, 1.5);
  readNumber(json, "lesson_width", s.lesson_width, 240.0, 700.0);
  readNumber(json, "touch_width", s.touch_width, 220.0, 600.0);
  readSwitch(json, "legend", s.legend);
  readSwitch(json, "depth_gauge", s.depth_gauge);
  readSwitch(json, "expert", s.expert);
  readSwitch(json, "colour_blind_safe", s.colour_blind_safe);
  readSwitch(json, "left_handed", s.left_handed);
  if (const auto code = json.find("language"); code != json.end() && code->is_string())
    s.language = code->get<std::string>().substr(0, 8);
  // Older files have a boolean in place of the choice of three decimal signs.
  bool comma = false;
  readSwitch(json, "decimal_comma", comma);
  if (comma) s.decimal_sign = DecimalSign::Comma;
  if (const auto sign = json.find("decimal_sign"); sign != json.end() && sign->is_string())
    s.decimal_sign = decimalSignNamed(sign->get<std::string>()).value_or(s.decimal_sign);
  // Older files have a unit of length only.
  if (const auto chosen = json.find("units"); chosen != json.end() && chosen->is_object()) {
    for (const auto& [name, unit] : chosen->items()) readUnit(name, unit, s.units);
  } else if (const auto unit = json.find("length_unit"); unit != json.end()) {
    readUnit("length", *unit, s.units);
  }
  if (const auto folder = json.find("lesson_folder"); folder != json.end() && folder->is_string())
    s.lesson_folder = folder->get<std::string>();
  if (const auto look = json.find("probe_look"); look != json.end() && look->is_string())
    s.probe_look = probeLookNamed(look->get<std::string>()).value_or(s.probe_look);
  if (const auto device = json.find("device"); device != json.end() && device->is_string())
    s.device = device->get<std::string>();
  if (const auto address = json.find("device_address"); address != json.end() && address->is_string())
    s.device_address = address->get<std::string>();
  readSwitch(json, "sound", s.sound);
  readSwitch(json, "sound_asked", s.sound_asked);
  readNumber(json, "sound_volume", s.sound_volume, 0.0, 1.0);
  readSwitch(json, "reduced_motion", s.reduced_motion);
  readSwitch(json, "large_state_text", s.large_state_text);
  if (const auto recent = json.find("recent"); recent != json.end() && recent->is_array())
    for (const auto& name : *recent)
      if (name.is_string() && s.recent.size() < Settings::kRecent) s.recent.push_back(name.get<std::string>());
  return out;
}

namespace {

nlohmann::json written(const Settings& s) {
  return {{"theme", themeName(s.theme)},
          {"scale", s.scale},
          {"text_size", s.text_size},
          {"lesson_width", s.lesson_width},
          {"touch_width", s.touch_width},
          {"legend", s.legend},
          {"depth_gauge", s.depth_gauge},
          {"expert", s.expert},
          {"colour_blind_safe", s.colour_blind_safe},
          {"left_handed", s.left_handed},
          {"language", s.language},
          {"decimal_sign", kDecimalSigns[std::size_t(s.decimal_sign)]},
          {"units", s.units},
          {"lesson_folder", s.lesson_folder},
          {"probe_look", probeLookName(s.probe_look)},
          {"device", s.device},
          {"device_address", s.device_address},
          {"sound", s.sound},
          {"sound_asked", s.sound_asked},
          {"sound_volume", s.sound_volume},
          {"reduced_motion", s.reduced_motion},
          {"large_state_text", s.large_state_text},
          {"recent", s.recent}};
}

}  // namespace

std::string saveSettings(const Settings& settings, const fs::path& file, const Settings& before) {
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  // Paths may contain bytes that are not UTF-8; they are replaced instead of throwing.
  nlohmann::json kept;
  if (std::ifstream in(file, std::ios::binary); in) kept = nlohmann::json::parse(in, nullptr, false);
  nlohmann::json json = written(settings);
  if (kept.is_object()) {
    const nlohmann::json was = written(before);
    for (const auto& [key, value] : json.items())
      if (!kept.contains(key) || value != was[key]) kept[key] = value;
    json = std::move(kept);
  }
  const auto problem = writeWhole(file, json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + '\n');
  return problem ? trf("Your settings could not be saved: {0}.", problem->text()) : std::string();
}

}  // namespace moltact
