#include "app/ui/widgets/input_queue.h"

#include <type_traits>

#include "app/ui/widgets/key_names.h"

namespace moltact {
namespace {

constexpr std::size_t kButtons = std::extent_v<decltype(ImGuiIO::MouseDown)>;

// Keys that produce a character.
std::bitset<kKeyCount> typingKeys() {
  std::bitset<kKeyCount> out;
  out.set(indexOf(ImGuiKey_Space));
  for (char c = '0'; c <= '9'; ++c) out.set(indexOf(keyOf(c)));
  for (char c = 'A'; c <= 'Z'; ++c) out.set(indexOf(keyOf(c)));
  for (std::size_t k = indexOf(ImGuiKey_Apostrophe); k <= indexOf(ImGuiKey_GraveAccent); ++k) out.set(k);
  return out;
}

bool writes(ImGuiKey key) {
  static const std::bitset<kKeyCount> all = typingKeys();
  return all[indexOf(key)];
}

}  // namespace

InputQueue::InputQueue() { prepareInput(ImGui::GetIO()); }

void InputQueue::tell(ImGuiIO& io, ImGuiKey key, bool down) {
  feedKey(io, key, down);
  held_[indexOf(key)] = down;
  const auto either = [&](ImGuiKey left, ImGuiKey right) { return held_[indexOf(left)] || held_[indexOf(right)]; };
  feedModifiers(io, {.ctrl = either(ImGuiKey_LeftCtrl, ImGuiKey_RightCtrl),
                     .shift = either(ImGuiKey_LeftShift, ImGuiKey_RightShift),
                     .alt = either(ImGuiKey_LeftAlt, ImGuiKey_RightAlt),
                     .super = either(ImGuiKey_LeftSuper, ImGuiKey_RightSuper)});
}

void InputQueue::feed(ImGuiIO& io) {
  keepTab();
  // The next frame activates a field. Later input is for that field, so it waits.
  if (itemAwaitsActivation()) return;
  // Within a frame, no key or button changes twice, and no event overtakes an earlier change.
  std::bitset<kKeyCount> keys_changed;
  std::bitset<kButtons> buttons_changed;
  bool wheeled = false, wrote = false;
  while (!events_.empty()) {
    const InputEvent e = events_.front();
    switch (e.kind) {
      case InputEvent::Kind::Pointer:
        if (buttons_changed.any() || wheeled) return;
        feedPointer(io, float(e.place.x), float(e.place.y));
        break;
      case InputEvent::Kind::PointerLeft:
        if (buttons_changed.any() || wheeled) return;
        feedPointerLeft(io);
        break;
      case InputEvent::Kind::Button:
        if (e.code >= 0 && std::size_t(e.code) < kButtons) {
          if (buttons_changed[std::size_t(e.code)] || wheeled || keys_changed.any()) return;
          buttons_changed.set(std::size_t(e.code));
          feedButton(io, e.code, e.down);
        }
        break;
      case InputEvent::Kind::Wheel:
        if (buttons_changed.any()) return;
        wheeled = true;
        feedWheel(io, float(e.place.x), float(e.place.y));
        break;
      case InputEvent::Kind::Key:
        if (isKey(e.key)) {
          const bool after_others = isModifier(e.key) && keys_changed.any();
          if (keys_changed[indexOf(e.key)] || after_others || buttons_changed.any() || (wrote && !writes(e.key)))
            return;
          // Auto-repeat of a key that is already down is ignored, because ImGui repeats keys itself.
          if (held_[indexOf(e.key)] == e.down) break;
          keys_changed.set(indexOf(e.key));
          tell(io, e.key, e.down);
        }
        break;
      case InputEvent::Kind::Character:
        for (std::size_t k = 0; k < kKeyCount; ++k)
          if (keys_changed[k] && !writes(keyAt(k)) && !isModifier(keyAt(k))) return;
        wrote = true;
        io.AddInputCharacter(unsigned(e.code));
        break;
      case InputEvent::Kind::FocusLost:
        if (keys_changed.any() || buttons_changed.any()) return;
        for (std::size_t k = 0; k < kKeyCount; ++k)
          if (held_[k]) tell(io, keyAt(k), false);
        for (int button = 0; button < int(kButtons); ++button) feedButton(io, button, false);
        keys_changed.set();
        buttons_changed.set();
        break;
    }
    events_.pop_front();
  }
}

}  // namespace moltact
