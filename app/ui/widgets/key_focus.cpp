#include "app/ui/widgets/key_focus.h"

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "app/ui/widgets/imgui_versions.h"
#include "app/ui/widgets/key_names.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"

namespace moltact {
namespace {

struct KeyStop {
  ImGuiID id = 0;
  ImGuiWindow* window = nullptr;
  ImRect place;
  bool field = false;  // it is a text field
};

// In the order of drawing: of the current frame so far, and of the previous frame.
struct KeyStops {
  std::vector<KeyStop> now, before;
};
KeyStops& stops() {
  static KeyStops all;
  return all;
}

bool popupOpen() { return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel); }

// The controls that Tab cycles through: those of the open page, else those of the panels.
std::vector<KeyStop> ring() {
  const ImGuiWindow* page = ImGui::GetTopMostPopupModal();
  std::vector<KeyStop> out;
  for (const KeyStop& s : stops().before)
    if (page ? s.window->RootWindow == page : !(s.window->RootWindow->Flags & ImGuiWindowFlags_Popup)) out.push_back(s);
  return out;
}

void leadTo(const KeyStop& s) {
  ImGuiContext& g = *GImGui;
  ImGui::ClearActiveID();
  ImGui::FocusWindow(s.window);
  ImGui::SetNavID(s.id, ImGuiNavLayer_Main, 0, ImGui::WindowRectAbsToRel(s.window, s.place));
  ImGui::ScrollToBringRectIntoView(s.window, s.place);
  showKeysPlace(true);
  if (!s.field) return;
  g.NavInputSource = ImGuiInputSource_Keyboard;
  activateItem(s.id);
}

// Moves the focus from the current control to the next, or with `panel` to the first control of another panel. Returns
// false past the last.
bool move(int by, bool panel, bool round) {
  const ImGuiContext& g = *GImGui;
  const std::vector<KeyStop> all = ring();
  if (all.empty()) return false;
  const int count = int(all.size());
  const ImGuiID at_id = g.ActiveId ? g.ActiveId : keysLeadControls() ? g.NavId : 0;
  int at = int(std::find_if(all.begin(), all.end(), [&](const KeyStop& s) { return s.id == at_id; }) - all.begin());
  if (at == count) at = by > 0 ? -1 : count;  // no focus yet, or its item no longer exists
  const auto rootOf = [&](int k) { return k >= 0 && k < count ? all[std::size_t(k)].window->RootWindow : nullptr; };
  const ImGuiWindow* from = rootOf(at);
  do at += by;
  while (panel && from && rootOf(at) == from);
  if (panel && by < 0)
    while (at > 0 && rootOf(at - 1) == rootOf(at)) --at;
  if (round) at = (at + count) % count;
  if (at < 0 || at >= count) return false;
  leadTo(all[std::size_t(at)]);
  return true;
}

// Alt was pressed and released with no other key in between.
bool altTapped(KeyFocus& panels) {
  const ImGuiIO& io = ImGui::GetIO();
  const auto isAlt = [](ImGuiKey key) { return key == ImGuiKey_LeftAlt || key == ImGuiKey_RightAlt; };
  bool other = ImGui::IsAnyMouseDown() || io.InputQueueCharacters.Size > 0, newly = false, let_go = false;
  for (std::size_t k = 0; k < kKeyCount; ++k) {
    const ImGuiKey key = keyAt(k);
    if (isAlt(key)) {
      newly = newly || ImGui::IsKeyPressed(key, false);
      let_go = let_go || ImGui::IsKeyReleased(key);
    } else {
      other = other || ImGui::IsKeyDown(key);
    }
  }
  if (newly) panels.alt_alone = true;
  if (other) panels.alt_alone = false;
  return let_go && std::exchange(panels.alt_alone, false);
}

void openMenus(KeyFocus& panels, std::string_view menu_letters) {
  const int menus = int(menu_letters.size());
  const ImGuiIO& io = ImGui::GetIO();
  const bool tapped = altTapped(panels);
  if (ImGui::GetTopMostPopupModal()) return;
  if (tapped || (!io.KeyCtrl && !io.KeyAlt && !io.KeyShift && takeKey(ImGuiKey_F10))) {
    // A second press closes the menus.
    if (popupOpen())
      ImGui::ClosePopupToLevel(0, true);
    else
      panels.menu_wanted = 0;
  }
  // The arrows switch between menus, unless they open or close a submenu.
  if (panels.menu_open >= 0 && GImGui->OpenPopupStack.Size == 1) {
    const int by = int(ImGui::IsKeyPressed(ImGuiKey_RightArrow, true) && !panels.at_submenu) -
                   int(ImGui::IsKeyPressed(ImGuiKey_LeftArrow, true));
    if (by) {
      ImGui::NavMoveRequestCancel();
      panels.menu_wanted = (panels.menu_open + by + menus) % menus;
    }
  }
  if (!io.KeyAlt || io.KeyCtrl || io.WantTextInput) return;
  for (int menu = 0; menu < menus; ++menu)
    if (ImGui::IsKeyPressed(keyOf(menu_letters[std::size_t(menu)]), false)) panels.menu_wanted = menu;
}

}  // namespace

bool keysLeadControls() { return ImGui::GetIO().ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard; }

bool keysFree() { return !ImGui::GetIO().WantTextInput && !keysLeadControls() && !popupOpen(); }

void leadByKeys(KeyFocus& panels, std::string_view menu_letters) {
  ImGuiContext& g = *GImGui;
  ImGuiIO& io = g.IO;
  bool& in_panels = panels.keys_in_panels;
  if (ImGui::GetFrameCount() <= 1) stops() = {};  // left from another ImGui context
  stops().before = std::exchange(stops().now, {});
  // Escape has closed a menu or list before the first line of this frame.
  if (panels.popup_open && !popupOpen()) takeKey(ImGuiKey_Escape);
  openMenus(panels, menu_letters);
  const bool page = ImGui::GetTopMostPopupModal() != nullptr, menu = popupOpen() && !page;
  for (int button = 0; button < IM_ARRAYSIZE(io.MouseDown); ++button)
    in_panels = in_panels && !ImGui::IsMouseClicked(button);
  if (!page && !menu && in_panels && !io.WantTextInput && takeKey(ImGuiKey_Escape)) in_panels = false;
  const bool tab = ImGui::IsKeyPressed(ImGuiKey_Tab, true), panel = !page && takeKey(ImGuiKey_F6);
  if (!menu && !io.KeyCtrl && !io.KeyAlt && (tab || panel)) {
    const bool moved = move(io.KeyShift ? -1 : 1, panel, page);
    if (!page) in_panels = moved;
    if (!moved) ImGui::ClearActiveID();
  }
  panels.popup_open = page || menu;
  const bool on = page || menu || in_panels || panels.menu_wanted >= 0;
  io.ConfigFlags =
      on ? io.ConfigFlags | ImGuiConfigFlags_NavEnableKeyboard : io.ConfigFlags & ~ImGuiConfigFlags_NavEnableKeyboard;
  if (!on) showKeysPlace(false);
  const bool enter = ImGui::IsKeyPressed(ImGuiKey_Enter, false) || ImGui::IsKeyPressed(ImGuiKey_KeypadEnter, false);
  if (on && enter && !io.WantTextInput && g.NavId && keysPlaceShown()) pressByEnter(g.NavId);
}

unsigned keyStop() {
  const ImGuiContext& g = *GImGui;
  const ImGuiLastItemData& item = g.LastItemData;
  const ItemForKeys for_keys = lastItemForKeys();
  ImGuiWindow* window = g.CurrentWindow;
  if (!item.ID || window->DC.NavLayerCurrent != ImGuiNavLayer_Main || !for_keys.usable ||
      window->Flags & ImGuiWindowFlags_NoNavInputs)
    return 0;
  std::vector<KeyStop>& all = stops().now;
  if (all.empty() || all.back().id != item.ID) all.push_back({item.ID, window, item.Rect, for_keys.field});
  // In a menu or list, the background marks the focused line.
  const bool menu = window->Flags & ImGuiWindowFlags_Popup && !(window->Flags & ImGuiWindowFlags_Modal);
  if (keysAtItem() && !menu) {
    const float off = look().px(2);
    window->DrawList->AddRect({item.Rect.Min.x - off, item.Rect.Min.y - off},
                              {item.Rect.Max.x + off, item.Rect.Max.y + off}, look().palette.accent, look().px(6), 0,
                              look().px(2));
  }
  return item.ID;
}

namespace {

// ImGui 1.86 leaves a group behind: without a name or, during input, with the field's name but not its type.
void nameLinesItem(const char* label) {
  if (const ImGuiLastItemData item = GImGui->LastItemData; !(item.InFlags & ImGuiItemFlags_Inputable))
    ImGui::SetLastItemData(ImGui::GetID(label), GImGui->CurrentItemFlags | ImGuiItemFlags_Inputable, item.StatusFlags,
                           item.Rect);
}

}  // namespace

bool inputLines(const char* label, std::string& text, ImVec2 size, ImGuiInputTextFlags flags) {
  const bool entered = ImGui::InputTextMultiline(label, &text, size, flags);
  nameLinesItem(label);
  return entered;
}

namespace {

// A line end that breakLines() has inserted follows a space.
bool isBreak(std::string_view text, std::size_t k) { return k > 0 && text[k] == '\n' && text[k - 1] == ' '; }

// Inserts a line end after the last space of each line that is wider than `width`.
std::string breakLines(std::string_view text, float width) {
  std::string out;
  std::size_t line = 0, space = 0;  // the start of the line, and the place after its last space; 0: it has none
  for (const char c : text) {
    out += c;
    if (c == '\n') {
      line = out.size(), space = 0;
      continue;
    }
    if (space > 0 && ImGui::CalcTextSize(out.data() + line, out.data() + out.size()).x > width) {
      out.insert(space, 1, '\n');
      line = space + 1, space = 0;
    }
    if (c == ' ') space = out.size();
  }
  return out;
}

struct Wrapping {
  std::string* text;
  float width;
};

int wrapAsTyped(ImGuiInputTextCallbackData* data) {
  const Wrapping& of = *static_cast<Wrapping*>(data->UserData);
  if (data->EventFlag == ImGuiInputTextFlags_CallbackResize) {
    of.text->resize(std::size_t(data->BufTextLen));
    data->Buf = of.text->data();
    return 0;
  }
  const std::string_view now(data->Buf, std::size_t(data->BufTextLen));
  // Converts the cursor's position to one without inserted line ends, and back.
  std::size_t letters = 0;
  for (std::size_t k = 0; k < std::size_t(data->CursorPos); ++k) letters += !isBreak(now, k);
  const std::string next = breakLines(unbrokenLines(now), of.width);
  if (next == now) return 0;
  std::size_t cursor = 0;
  for (std::size_t left = letters; cursor < next.size() && (left > 0 || isBreak(next, cursor)); ++cursor)
    left -= !isBreak(next, cursor);
  data->DeleteChars(0, data->BufTextLen);
  data->InsertChars(0, next.data(), next.data() + next.size());
  data->CursorPos = data->SelectionStart = data->SelectionEnd = int(cursor);
  return 0;
}

}  // namespace

std::string unbrokenLines(std::string_view text) {
  std::string out;
  for (std::size_t k = 0; k < text.size(); ++k)
    if (!isBreak(text, k)) out += text[k];
  return out;
}

bool inputWrapped(const char* label, std::string& text, ImVec2 size, ImGuiInputTextFlags flags) {
  const ImGuiStyle& style = ImGui::GetStyle();
  const float all = size.x > 0 ? size.x : ImGui::GetContentRegionAvail().x;
  Wrapping wrapping{&text, all - 2 * style.FramePadding.x - style.ScrollbarSize};
  const std::string before = text;
  flags |= ImGuiInputTextFlags_CallbackResize | ImGuiInputTextFlags_CallbackEdit;
  const bool entered =
      ImGui::InputTextMultiline(label, text.data(), text.capacity() + 1, size, flags, wrapAsTyped, &wrapping);
  nameLinesItem(label);
  keepOnEscape(text, before);
  return entered;
}

void keepOnEscape(std::string& text, const std::string& before) {
  if (text != before && ImGui::IsItemDeactivated() && ImGui::IsKeyPressed(ImGuiKey_Escape, false)) text = before;
}

void writeInLastField(const char* label) {
  // By the label: ImGui 1.86 treats a multi-line field as a group and does not keep its id.
  ImGuiWindow* window = GImGui->CurrentWindow;
  leadTo({window->GetID(label), window, GImGui->LastItemData.Rect, true});
}

bool keysAtItem() { return keysLeadControls() && keysPlaceShown() && ImGui::IsItemFocused(); }

int arrowsAtItem() {
  if (!keysAtItem()) return 0;
  const bool right = ImGui::IsKeyPressed(ImGuiKey_RightArrow, true),
             left = ImGui::IsKeyPressed(ImGuiKey_LeftArrow, true);
  if (right || left) ImGui::NavMoveRequestCancel();
  return int(right) - int(left);
}

std::string controlOfKeys() {
  if (!keysLeadControls() || !keysPlaceShown() || !GImGui->NavId) return {};
  for (const auto& [name, record] : widgets().all())
    if (record.key_stop == GImGui->NavId) return name;
  return {};
}

}  // namespace moltact
