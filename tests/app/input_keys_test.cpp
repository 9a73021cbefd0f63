// Keys from the window to ImGui, the same in every version of ImGui.
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <doctest/doctest.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "app/ui/shell/glfw_keys.h"
#include "app/ui/shell/keyboard_layout.h"
#include "app/ui/widgets/input_queue.h"
#include "app/ui/widgets/key_focus.h"
#include "app/ui/widgets/key_names.h"

namespace moltact {
namespace {

// ImGui without anything on its screen.
class BareImGui {
 public:
  BareImGui() {
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui::GetIO().DisplaySize = {100, 100};
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsAlpha8(&pixels, &width, &height);
  }
  ~BareImGui() { ImGui::DestroyContext(); }
  BareImGui(const BareImGui&) = delete;
  BareImGui& operator=(const BareImGui&) = delete;

  template <class Draw>
  void frame(InputQueue& input, Draw draw) {
    ImGui::GetIO().DeltaTime = 1.0f / 60.0f;
    input.feed(ImGui::GetIO());
    ImGui::NewFrame();
    draw();
    ImGui::EndFrame();
  }
  void frame(InputQueue& input) {
    frame(input, [] {});
  }
};

std::vector<ImGuiKey> keysDown() {
  std::vector<ImGuiKey> out;
  for (std::size_t k = 0; k < kKeyCount; ++k)
    if (ImGui::IsKeyDown(keyAt(k))) out.push_back(keyAt(k));
  return out;
}

// What the rows of a keyboard write without Shift, place by place, the digits' row without the key left of 1.
constexpr int kPlaces[] = {GLFW_KEY_1,
                           GLFW_KEY_2,
                           GLFW_KEY_3,
                           GLFW_KEY_4,
                           GLFW_KEY_5,
                           GLFW_KEY_6,
                           GLFW_KEY_7,
                           GLFW_KEY_8,
                           GLFW_KEY_9,
                           GLFW_KEY_0,
                           GLFW_KEY_MINUS,
                           GLFW_KEY_EQUAL,
                           GLFW_KEY_Q,
                           GLFW_KEY_W,
                           GLFW_KEY_E,
                           GLFW_KEY_R,
                           GLFW_KEY_T,
                           GLFW_KEY_Y,
                           GLFW_KEY_U,
                           GLFW_KEY_I,
                           GLFW_KEY_O,
                           GLFW_KEY_P,
                           GLFW_KEY_LEFT_BRACKET,
                           GLFW_KEY_RIGHT_BRACKET,
                           GLFW_KEY_A,
                           GLFW_KEY_S,
                           GLFW_KEY_D,
                           GLFW_KEY_F,
                           GLFW_KEY_G,
                           GLFW_KEY_H,
                           GLFW_KEY_J,
                           GLFW_KEY_K,
                           GLFW_KEY_L,
                           GLFW_KEY_SEMICOLON,
                           GLFW_KEY_APOSTROPHE,
                           GLFW_KEY_Z,
                           GLFW_KEY_X,
                           GLFW_KEY_C,
                           GLFW_KEY_V,
                           GLFW_KEY_B,
                           GLFW_KEY_N,
                           GLFW_KEY_M,
                           GLFW_KEY_COMMA,
                           GLFW_KEY_PERIOD,
                           GLFW_KEY_SLASH};
using Rows = std::vector<std::string>;

KeyboardLayout layoutOf(const Rows& written) {
  REQUIRE(written.size() == std::size(kPlaces));
  return [written](ImGuiKey place) -> std::string_view {
    for (std::size_t k = 0; k < written.size(); ++k)
      if (keyOfGlfw(kPlaces[k]) == place) return written[k];
    return {};
  };
}

const Rows kQwerty{"1", "2", "3", "4", "5", "6", "7", "8", "9", "0", "-", "=", "q", "w", "e",
                   "r", "t", "y", "u", "i", "o", "p", "[", "]", "a", "s", "d", "f", "g", "h",
                   "j", "k", "l", ";", "'", "z", "x", "c", "v", "b", "n", "m", ",", ".", "/"};
const Rows kQwertz{"1", "2", "3", "4", "5", "6", "7", "8", "9", "0", "ß", "´", "q", "w", "e",
                   "r", "t", "z", "u", "i", "o", "p", "ü", "+", "a", "s", "d", "f", "g", "h",
                   "j", "k", "l", "ö", "ä", "y", "x", "c", "v", "b", "n", "m", ",", ".", "-"};
const Rows kAzerty{"&", "é", "\"", "'", "(", "-", "è", "_", "ç", "à", ")", "=", "a", "z", "e",
                   "r", "t", "y",  "u", "i", "o", "p", "^", "$", "q", "s", "d", "f", "g", "h",
                   "j", "k", "l",  "m", "ù", "w", "x", "c", "v", "b", "n", ",", ";", ":", "!"};
const Rows kTurkishF{"1", "2", "3", "4", "5", "6", "7", "8", "9", "0", "/", "-", "f", "g", "ğ",
                     "ı", "o", "d", "r", "n", "h", "p", "q", "w", "u", "i", "e", "a", "ü", "t",
                     "k", "m", "l", "y", "ş", "j", "ö", "v", "c", "ç", "z", "s", "b", ".", ","};
const Rows kRussian{"1", "2", "3", "4", "5", "6", "7", "8", "9", "0", "-", "=", "й", "ц", "у",
                    "к", "е", "н", "г", "ш", "щ", "з", "х", "ъ", "ф", "ы", "в", "а", "п", "р",
                    "о", "л", "д", "ж", "э", "я", "ч", "с", "м", "и", "т", "ь", "б", "ю", "."};

ImGuiKey keyAtPlace(const Rows& layout, int glfw_key) { return keyOnLayout(keyOfGlfw(glfw_key), layoutOf(layout)); }

}  // namespace

TEST_CASE(
    "a letter goes by what its key writes, not by its place: on QWERTZ the place of Y is Z and undoes, on AZERTY that "
    "of Q "
    "is A and selects all, and quits nothing") {
  CHECK(keyAtPlace(kQwerty, GLFW_KEY_Z) == ImGuiKey_Z);
  CHECK(keyAtPlace(kQwertz, GLFW_KEY_Y) == ImGuiKey_Z);
  CHECK(keyAtPlace(kQwertz, GLFW_KEY_Z) == ImGuiKey_Y);
  CHECK(keyAtPlace(kQwertz, GLFW_KEY_SLASH) == ImGuiKey_Minus);
  CHECK(keyAtPlace(kQwertz, GLFW_KEY_COMMA) == ImGuiKey_Comma);
  // "ß" stands where a keyboard of the United States has the minus, which another key writes.
  CHECK_FALSE(isKey(keyAtPlace(kQwertz, GLFW_KEY_MINUS)));
  CHECK(keyAtPlace(kQwertz, GLFW_KEY_SEMICOLON) == ImGuiKey_Semicolon);

  CHECK(keyAtPlace(kAzerty, GLFW_KEY_Q) == ImGuiKey_A);
  CHECK(keyAtPlace(kAzerty, GLFW_KEY_A) == ImGuiKey_Q);
  CHECK(keyAtPlace(kAzerty, GLFW_KEY_W) == ImGuiKey_Z);
  CHECK(keyAtPlace(kAzerty, GLFW_KEY_SEMICOLON) == ImGuiKey_M);
  CHECK(keyAtPlace(kAzerty, GLFW_KEY_M) == ImGuiKey_Comma);
  // The digits need Shift there; the keys are the digits' all the same, "'" and "-" of that row included.
  for (int digit = 0; digit <= 9; ++digit) CHECK(keyAtPlace(kAzerty, GLFW_KEY_0 + digit) == keyOf(char('0' + digit)));

  CHECK(keyAtPlace(kRussian, GLFW_KEY_Z) == ImGuiKey_Z);
  CHECK_FALSE(isKey(keyAtPlace(kTurkishF, GLFW_KEY_E)));  // "ğ"; the E is where D was
}

TEST_CASE(
    "on QWERTY, QWERTZ, AZERTY, the Turkish F keyboard and the Russian one each letter and each digit has one key, no "
    "two "
    "places are the same key, and a key that writes a Latin letter is that letter") {
  for (const Rows& rows : {kQwerty, kQwertz, kAzerty, kTurkishF, kRussian}) {
    const KeyboardLayout layout = layoutOf(rows);
    std::map<ImGuiKey, std::string> written;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const ImGuiKey key = keyOnLayout(keyOfGlfw(kPlaces[k]), layout);
      CAPTURE(rows[k]);
      if (rows[k].size() == 1 && isKey(keyOf(rows[k][0]))) CHECK(key == keyOf(rows[k][0]));
      if (isKey(key)) CHECK_MESSAGE(written.emplace(key, rows[k]).second, "also ", written[key]);
    }
    for (char c = '0'; c <= '9'; ++c) CHECK(written.count(keyOf(c)) == 1);
    // The Turkish F keyboard has its X outside of these rows.
    for (char c = 'a'; c <= 'z'; ++c)
      if (c != 'x') CHECK(written.count(keyOf(c)) == 1);
  }
}

TEST_CASE("a key that writes nothing keeps its name on any keyboard, and each key that GLFW names is found again") {
  for (std::size_t k = 0; k < kKeyCount; ++k) {
    const ImGuiKey key = keyAt(k);
    const bool named = glfwKeyOf(key) != GLFW_KEY_UNKNOWN;
    if (named) CHECK(keyOfGlfw(glfwKeyOf(key)) == key);
    CHECK(keyOnLayout(key, [](ImGuiKey) { return std::string_view{}; }) == key);
  }
  CHECK(keyAtPlace(kAzerty, GLFW_KEY_KP_1) == ImGuiKey_Keypad1);
  CHECK(keyAtPlace(kAzerty, GLFW_KEY_ESCAPE) == ImGuiKey_Escape);
  CHECK_FALSE(isKey(keyAtPlace(kAzerty, GLFW_KEY_UNKNOWN)));
}

TEST_CASE(
    "each of GLFW's keys but those of other countries and F13 to F25 is one of ImGui's, and no two are the same") {
  std::map<ImGuiKey, int> from;
  int named = 0;
  for (int code = -1; code <= GLFW_KEY_LAST + 1; ++code) {
    const ImGuiKey key = keyOfGlfw(code);
    if (!isKey(key)) continue;
    ++named;
    CHECK_MESSAGE(from.emplace(key, code).second, code, " and ", from[key]);
  }
  // GLFW's header has 121 constants, less GLFW_KEY_UNKNOWN, two keys of other countries and thirteen function keys.
  CHECK(named == 105);
  CHECK_FALSE(isKey(keyOfGlfw(GLFW_KEY_UNKNOWN)));
  CHECK_FALSE(isKey(keyOfGlfw(GLFW_KEY_WORLD_1)));
  for (char c = 'A'; c <= 'Z'; ++c) CHECK(keyOfGlfw(c) == keyOf(c));
  for (char c = '0'; c <= '9'; ++c) CHECK(keyOfGlfw(c) == keyOf(c));
  CHECK(keyOf('q') == ImGuiKey_Q);
  CHECK(keyOfGlfw(GLFW_KEY_F12) == ImGuiKey_F12);
  CHECK(keyOfGlfw(GLFW_KEY_KP_9) == ImGuiKey_Keypad9);
}

TEST_CASE(
    "each key alone is down in the frame that it is fed, newly for that frame only, and up in the frame after it is "
    "let go; modifiers follow both sides") {
  BareImGui imgui;
  InputQueue input;
  imgui.frame(input);
  for (std::size_t k = 0; k < kKeyCount; ++k) {
    const ImGuiKey key = keyAt(k);
    CAPTURE(k);
    input.key(key, true);
    imgui.frame(input);
    CHECK(keysDown() == std::vector<ImGuiKey>{key});
    CHECK(ImGui::IsKeyPressed(key, false));
    CHECK(takeKey(key));
    CHECK_FALSE(takeKey(key));
    CHECK_FALSE(ImGui::IsKeyPressed(key, true));
    CHECK(ImGui::IsKeyDown(key));
    CHECK(ImGui::GetIO().KeyCtrl == (key == ImGuiKey_LeftCtrl || key == ImGuiKey_RightCtrl));
    CHECK(ImGui::GetIO().KeyShift == (key == ImGuiKey_LeftShift || key == ImGuiKey_RightShift));
    CHECK(ImGui::GetIO().KeyAlt == (key == ImGuiKey_LeftAlt || key == ImGuiKey_RightAlt));
    CHECK(ImGui::GetIO().KeySuper == (key == ImGuiKey_LeftSuper || key == ImGuiKey_RightSuper));
    imgui.frame(input);
    CHECK_FALSE(ImGui::IsKeyPressed(key, false));
    input.key(key, false);
    imgui.frame(input);
    CHECK(ImGui::IsKeyReleased(key));
    CHECK(keysDown().empty());
  }
}

TEST_CASE(
    "a key pressed and let go within one frame is seen for one frame; two keys within one frame are seen in it; a "
    "window that loses the keyboard lets go of all") {
  BareImGui imgui;
  InputQueue input;
  imgui.frame(input);
  input.key(ImGuiKey_A, true);
  input.key(ImGuiKey_A, false);
  imgui.frame(input);
  CHECK(ImGui::IsKeyPressed(ImGuiKey_A, false));
  imgui.frame(input);
  CHECK(ImGui::IsKeyReleased(ImGuiKey_A));
  CHECK(input.empty());

  input.key(ImGuiKey_LeftCtrl, true);
  input.key(ImGuiKey_O, true);
  input.button(1, true);
  imgui.frame(input);
  CHECK(keysPressed("Ctrl+O"));
  CHECK_FALSE(keysPressed("O"));
  CHECK_FALSE(ImGui::IsMouseDown(1));
  imgui.frame(input);
  CHECK(ImGui::IsMouseDown(1));
  input.focusLost();
  imgui.frame(input);
  CHECK(keysDown().empty());
  CHECK_FALSE(ImGui::GetIO().KeyCtrl);
  CHECK_FALSE(ImGui::IsMouseDown(1));
}

TEST_CASE(
    "A asks for a field in another window than the one that has the keys; 3.8, typed in the same frame as A, stands in "
    "the field whole, and nothing else has seen the 3") {
  for (const bool lines : {false, true}) {
    CAPTURE(lines);
    BareImGui imgui;
    InputQueue input;
    std::string written;
    bool seen = false;
    int led_to = 0;  // frames in which Tab could lead to the field
    const auto draw = [&] {
      ImGui::Begin("view");
      ImGui::Button("one");
      ImGui::End();
      ImGui::SetNextWindowSize({80, 60});
      ImGui::Begin("lesson");
      ImGui::Button("two", {40, 400});  // the field is out of sight below
      if (lines)
        inputLines("##field", written, {60, 40});
      else
        ImGui::InputText("##field", &written);
      led_to += lastItemForKeys().usable && lastItemForKeys().field;
      if (!ImGui::GetIO().WantTextInput) {
        seen = seen || ImGui::IsKeyPressed(ImGuiKey_3, false);
        if (takeKey(ImGuiKey_A)) writeInLastField("##field");
      }
      if (ImGui::GetFrameCount() == 1) ImGui::SetWindowFocus("view");
      ImGui::End();
    };
    for (int k = 0; k < 3; ++k) imgui.frame(input, draw);
    led_to = 0;
    for (const char c : {'A', '3', '.', '8'}) {
      const ImGuiKey key = c == '.' ? ImGuiKey_Period : keyOf(c);
      input.key(key, true);
      input.character(unsigned(c));
      input.key(key, false);
    }
    for (int k = 0; k < 20; ++k) imgui.frame(input, draw);
    CHECK(input.empty());
    CHECK(written == "3.8");
    CHECK(led_to == 20);
    CHECK_FALSE(seen);
  }
}

}  // namespace moltact
