// Keys on their way from the window to ImGui, in every version of ImGui alike.
#include <map>
#include <string>
#include <vector>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <doctest/doctest.h>

#include "app/ui/shell/glfw_keys.h"
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

}  // namespace

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
  // 121 constants stand in GLFW's header, less GLFW_KEY_UNKNOWN, the two of other countries and thirteen function keys.
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
    char written[16] = "";
    bool seen = false;
    const auto draw = [&] {
      ImGui::Begin("view");
      ImGui::Button("one");
      ImGui::End();
      ImGui::Begin("lesson");
      ImGui::Button("two");
      if (lines)
        ImGui::InputTextMultiline("##field", written, sizeof written);
      else
        ImGui::InputText("##field", written, sizeof written);
      if (!ImGui::GetIO().WantTextInput) {
        seen = seen || ImGui::IsKeyPressed(ImGuiKey_3, false);
        if (takeKey(ImGuiKey_A)) writeInLastField();
      }
      if (ImGui::GetFrameCount() == 1) ImGui::SetWindowFocus("view");
      ImGui::End();
    };
    for (int k = 0; k < 3; ++k) imgui.frame(input, draw);
    for (const char c : {'A', '3', '.', '8'}) {
      const ImGuiKey key = c == '.' ? ImGuiKey_Period : keyOf(c);
      input.key(key, true);
      input.character(unsigned(c));
      input.key(key, false);
    }
    for (int k = 0; k < 20; ++k) imgui.frame(input, draw);
    CHECK(input.empty());
    CHECK(std::string(written) == "3.8");
    CHECK_FALSE(seen);
  }
}

}  // namespace moltact
