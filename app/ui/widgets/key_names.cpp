#include "app/ui/widgets/key_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>
#include <string>

#include "engine/language/catalogue.h"

namespace moltact {
namespace {

struct KeyName {
  std::string_view name;
  ImGuiKey key;
};
constexpr KeyName kKeys[] = {{"ctrl", ImGuiKey_LeftCtrl},  {"shift", ImGuiKey_LeftShift},
                             {"alt", ImGuiKey_LeftAlt},    {"space", ImGuiKey_Space},
                             {"escape", ImGuiKey_Escape},  {"esc", ImGuiKey_Escape},
                             {"enter", ImGuiKey_Enter},    {"tab", ImGuiKey_Tab},
                             {"left", ImGuiKey_LeftArrow}, {"right", ImGuiKey_RightArrow},
                             {"up", ImGuiKey_UpArrow},     {"down", ImGuiKey_DownArrow},
                             {"pageup", ImGuiKey_PageUp},  {"pagedown", ImGuiKey_PageDown},
                             {"home", ImGuiKey_Home},      {"backspace", ImGuiKey_Backspace},
                             {"plus", ImGuiKey_KeypadAdd}, {"minus", ImGuiKey_Minus},
                             {",", ImGuiKey_Comma}};

constexpr ImGuiKey kLetters[] = {ImGuiKey_A, ImGuiKey_B, ImGuiKey_C, ImGuiKey_D, ImGuiKey_E, ImGuiKey_F, ImGuiKey_G,
                                 ImGuiKey_H, ImGuiKey_I, ImGuiKey_J, ImGuiKey_K, ImGuiKey_L, ImGuiKey_M, ImGuiKey_N,
                                 ImGuiKey_O, ImGuiKey_P, ImGuiKey_Q, ImGuiKey_R, ImGuiKey_S, ImGuiKey_T, ImGuiKey_U,
                                 ImGuiKey_V, ImGuiKey_W, ImGuiKey_X, ImGuiKey_Y, ImGuiKey_Z};

ImGuiKey keyNamed(std::string_view written) {
  std::string name;
  for (const char c : written)
    if (c != ' ') name += char(std::tolower(static_cast<unsigned char>(c)));
  if (name.size() == 1 && isKey(keyOf(name[0]))) return keyOf(name[0]);
  // F1 to F12
  if (name.size() > 1 && name.size() < 4 && name[0] == 'f' &&
      std::all_of(name.begin() + 1, name.end(), [](unsigned char c) { return std::isdigit(c); }))
    if (const int number = std::stoi(name.substr(1)); number >= 1 && number <= 12)
      return ImGuiKey(int(ImGuiKey_F1) + number - 1);
  const auto known = std::find_if(std::begin(kKeys), std::end(kKeys), [&](const KeyName& k) { return k.name == name; });
  return known == std::end(kKeys) ? ImGuiKey(ImGuiKey_None) : known->key;
}

}  // namespace

ImGuiKey keyOf(char character) {
  if (character >= '0' && character <= '9') return ImGuiKey(int(ImGuiKey_0) + (character - '0'));
  if (character >= 'A' && character <= 'Z') return kLetters[character - 'A'];
  if (character >= 'a' && character <= 'z') return kLetters[character - 'a'];
  return ImGuiKey_None;
}

std::vector<ImGuiKey> keysNamed(std::string_view names) {
  std::vector<ImGuiKey> out;
  while (!names.empty()) {
    const std::size_t end = std::min(names.find('+'), names.size());
    const ImGuiKey key = keyNamed(names.substr(0, end));
    if (!isKey(key)) return {};
    out.push_back(key);
    names.remove_prefix(std::min(end + 1, names.size()));
  }
  return out;
}

std::string keysText(std::string_view names) {
  // The printed names that differ between languages; all others are the same everywhere.
  static constexpr std::array<std::string_view, 15> kPrinted{
      NC_("key", "Ctrl"), NC_("key", "Shift"), NC_("key", "Alt"),     NC_("key", "Space"),     NC_("key", "Escape"),
      NC_("key", "Esc"),  NC_("key", "Enter"), NC_("key", "Tab"),     NC_("key", "Left"),      NC_("key", "Right"),
      NC_("key", "Up"),   NC_("key", "Down"),  NC_("key", "Page Up"), NC_("key", "Page Down"), NC_("key", "Home")};
  std::string out;
  while (!names.empty()) {
    const std::size_t end = std::min(names.find('+'), names.size());
    const std::string name(names.substr(0, end));
    const bool printed = std::find(kPrinted.begin(), kPrinted.end(), name) != kPrinted.end();
    out += (out.empty() ? "" : "+") + std::string(printed ? trc("key", name.c_str()) : name.c_str());
    names.remove_prefix(std::min(end + 1, names.size()));
  }
  return out;
}

std::string withKey(std::string_view label, std::string_view names) {
  return std::string(label) + "  (" + keysText(names) + ")";
}

bool keysPressed(std::string_view names) {
  const ImGuiIO& io = ImGui::GetIO();
  if (names == "?") return io.InputQueueCharacters.contains(ImWchar('?'));
  const std::vector<ImGuiKey> keys = keysNamed(names);
  if (keys.empty()) return false;
  const auto holds = [&](ImGuiKey modifier) {
    return std::find(keys.begin(), keys.end() - 1, modifier) != keys.end() - 1;
  };
  return io.KeyCtrl == holds(ImGuiKey_LeftCtrl) && io.KeyShift == holds(ImGuiKey_LeftShift) &&
         io.KeyAlt == holds(ImGuiKey_LeftAlt) && ImGui::IsKeyPressed(keys.back(), false);
}

}  // namespace moltact
