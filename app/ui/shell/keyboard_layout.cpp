#include "app/ui/shell/keyboard_layout.h"

#include <algorithm>
#include <vector>

#include "app/ui/widgets/key_names.h"

namespace moltact {
namespace {

// A key, and the character that it writes on a US keyboard.
struct WritingKey {
  ImGuiKey key;
  char character;
};

std::vector<WritingKey> writingKeys() {
  std::vector<WritingKey> out{{ImGuiKey_Apostrophe, '\''},  {ImGuiKey_Comma, ','},       {ImGuiKey_Minus, '-'},
                              {ImGuiKey_Period, '.'},       {ImGuiKey_Slash, '/'},       {ImGuiKey_Semicolon, ';'},
                              {ImGuiKey_Equal, '='},        {ImGuiKey_LeftBracket, '['}, {ImGuiKey_Backslash, '\\'},
                              {ImGuiKey_RightBracket, ']'}, {ImGuiKey_GraveAccent, '`'}};
  for (char c = 'a'; c <= 'z'; ++c) out.push_back({keyOf(c), c});
  for (char c = '0'; c <= '9'; ++c) out.push_back({keyOf(c), c});
  return out;
}

bool isDigitKey(char c) { return c >= '0' && c <= '9'; }

// Null if ImGui has no such key.
const WritingKey* keyThatWrites(const std::vector<WritingKey>& keys, std::string_view text) {
  if (text.size() != 1) return nullptr;
  const char c = text[0] >= 'A' && text[0] <= 'Z' ? char(text[0] - 'A' + 'a') : text[0];
  const auto found = std::find_if(keys.begin(), keys.end(), [&](const WritingKey& k) { return k.character == c; });
  return found == keys.end() ? nullptr : &*found;
}

}  // namespace

ImGuiKey keyOnLayout(ImGuiKey place, const KeyboardLayout& layout) {
  static const std::vector<WritingKey> keys = writingKeys();
  const auto at = std::find_if(keys.begin(), keys.end(), [&](const WritingKey& k) { return k.key == place; });
  if (at == keys.end()) return place;
  const WritingKey* written = keyThatWrites(keys, layout(place));
  if (isDigitKey(at->character)) return written && isDigitKey(written->character) ? written->key : place;
  if (written) return written->key;
  const bool elsewhere = std::any_of(keys.begin(), keys.end(), [&](const WritingKey& other) {
    const WritingKey* there = isDigitKey(other.character) ? nullptr : keyThatWrites(keys, layout(other.key));
    return there && there->key == place;
  });
  return elsewhere ? ImGuiKey(ImGuiKey_None) : place;
}

}  // namespace moltact
