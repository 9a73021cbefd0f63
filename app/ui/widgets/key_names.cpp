#include "app/ui/widgets/key_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include "engine/language/catalogue.h"

namespace moltact {
namespace {

struct KeyName {
  std::string_view name;
  int key;
};
constexpr std::array kKeys{KeyName{"ctrl", GLFW_KEY_LEFT_CONTROL},
                           KeyName{"shift", GLFW_KEY_LEFT_SHIFT},
                           KeyName{"alt", GLFW_KEY_LEFT_ALT},
                           KeyName{"space", GLFW_KEY_SPACE},
                           KeyName{"escape", GLFW_KEY_ESCAPE},
                           KeyName{"esc", GLFW_KEY_ESCAPE},
                           KeyName{"enter", GLFW_KEY_ENTER},
                           KeyName{"tab", GLFW_KEY_TAB},
                           KeyName{"backspace", GLFW_KEY_BACKSPACE},
                           KeyName{"left", GLFW_KEY_LEFT},
                           KeyName{"right", GLFW_KEY_RIGHT},
                           KeyName{"up", GLFW_KEY_UP},
                           KeyName{"down", GLFW_KEY_DOWN},
                           KeyName{"pageup", GLFW_KEY_PAGE_UP},
                           KeyName{"pagedown", GLFW_KEY_PAGE_DOWN},
                           KeyName{"home", GLFW_KEY_HOME},
                           KeyName{"plus", GLFW_KEY_KP_ADD},
                           KeyName{"minus", GLFW_KEY_MINUS},
                           KeyName{",", GLFW_KEY_COMMA}};

int keyNamed(std::string_view written) {
  std::string name;
  for (const char c : written)
    if (c != ' ') name += char(std::tolower(static_cast<unsigned char>(c)));
  if (name.size() == 1 && std::isalnum(static_cast<unsigned char>(name[0])))
    return std::toupper(static_cast<unsigned char>(name[0]));
  // F1 to F12
  if (name.size() > 1 && name.size() < 4 && name[0] == 'f' &&
      std::all_of(name.begin() + 1, name.end(), [](unsigned char c) { return std::isdigit(c); }))
    if (const int number = std::stoi(name.substr(1)); number >= 1 && number <= 12) return GLFW_KEY_F1 + number - 1;
  const auto known = std::find_if(kKeys.begin(), kKeys.end(), [&](const KeyName& k) { return k.name == name; });
  return known == kKeys.end() ? -1 : known->key;
}

}  // namespace

std::vector<int> keysNamed(std::string_view names) {
  std::vector<int> out;
  while (!names.empty()) {
    const std::size_t end = std::min(names.find('+'), names.size());
    const int key = keyNamed(names.substr(0, end));
    if (key < 0) return {};
    out.push_back(key);
    names.remove_prefix(std::min(end + 1, names.size()));
  }
  return out;
}

std::string keysText(std::string_view names) {
  // As they are printed on keyboards; what is not among them is the same everywhere.
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
  const std::vector<int> keys = keysNamed(names);
  if (keys.empty()) return false;
  const auto holds = [&](int modifier) { return std::find(keys.begin(), keys.end() - 1, modifier) != keys.end() - 1; };
  return io.KeyCtrl == holds(GLFW_KEY_LEFT_CONTROL) && io.KeyShift == holds(GLFW_KEY_LEFT_SHIFT) &&
         io.KeyAlt == holds(GLFW_KEY_LEFT_ALT) && ImGui::IsKeyPressed(keys.back(), false);
}

}  // namespace moltact
