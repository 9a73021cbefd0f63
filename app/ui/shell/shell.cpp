#include "app/ui/shell/shell.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>

#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"

namespace moltact {

Shell::Shell() {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGui::GetIO().IniFilename = nullptr;  // the program keeps its own settings
  ImGui::GetIO().LogFilename = nullptr;
  ImGui::GetIO().ConfigWindowsMoveFromTitleBarOnly = true;
  input_ = std::make_unique<InputQueue>();
  ImGui_ImplOpenGL3_Init(kShaderVersion);
}

Shell::~Shell() {
  ImGui_ImplOpenGL3_Shutdown();
  ImGui::DestroyContext();
}

void Shell::setLook(ThemeChoice theme, float scale, float text) {
  scale = std::clamp(scale, 0.5f, 4.0f);
  if (theme == theme_ && scale == scale_ && text == text_) return;
  theme_ = theme;
  scale_ = scale;
  text_ = text;
  look_changed_ = true;
}

void Shell::framebufferKept(bool kept) {
  kept_ = kept;
  damage_.forget();
}

void Shell::frame(int width, int height, double dt_s, const std::function<void()>& panels, bool drawn) {
  if (look_changed_ || signsWanted()) {
    look_changed_ = false;
    const bool another = loaded_ != 0.0f && (signsWanted() || loaded_ != scale_ * text_);
    if (another) ImGui_ImplOpenGL3_DestroyFontsTexture();
    std::string fault = applyLook(theme_, scale_, text_);
    if (!fault.empty()) fault_text_ = std::move(fault);
    ImGui_ImplOpenGL3_NewFrame();  // in the first frame, creates the device objects, including the font texture
    if (another) ImGui_ImplOpenGL3_CreateFontsTexture();
    loaded_ = scale_ * text_;
    damage_.forget();  // the same letters may have moved in the font texture
  }
  ImGuiIO& io = ImGui::GetIO();
  io.DisplaySize = {float(width), float(height)};
  io.DeltaTime = float(std::clamp(dt_s, 1e-4, 0.5));
  input_->feed(io);

  ImGui_ImplOpenGL3_NewFrame();
  ImGui::NewFrame();
  widgets().clear();
  panels();
  ImGui::Render();
  if (!drawn) return;
  ImDrawData& data = *ImGui::GetDrawData();
  const ImU32 ground = look().palette.ground;
  if (!kept_) return drawWithin({{0, 0}, {float(width), float(height)}}, data, ground);
  for (const Rectangle& area : damage_.since(data)) drawWithin(area, data, ground);
}

}  // namespace moltact
