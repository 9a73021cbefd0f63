// Centre: the molecule and the probe, what is touched in words, a scale bar, and what the mouse and keys do over it.
#include <cmath>
#include <cstdio>
#include <string>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "app/ui/application.h"
#include "app/ui/contact_text.h"
#include "app/ui/controls.h"
#include "app/ui/method_chooser.h"
#include "app/ui/panels/view_overlays.h"
#include "app/ui/theme.h"
#include "app/ui/view_picture.h"
#include "app/ui/widget_map.h"

namespace moltact {
namespace {

glm::dvec2 arrows() {
  const auto down = [](int key) { return ImGui::IsKeyDown(key) ? 1.0 : 0.0; };
  return {down(GLFW_KEY_RIGHT) - down(GLFW_KEY_LEFT), down(GLFW_KEY_UP) - down(GLFW_KEY_DOWN)};
}

bool pressed(int key, bool repeat = false) { return ImGui::IsKeyPressed(key, repeat); }

void readKeys(Application& app, ViewInput& in) {
  const ImGuiIO& io = ImGui::GetIO();
  // Keys belong to a text field or an open page before they belong to the view.
  if (io.WantTextInput || ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel)) return;
  if (io.KeyCtrl && !io.KeyAlt) in.orbit_keys = arrows();
  else if (io.KeyShift && !io.KeyAlt) in.pan_keys = arrows();
  else if (!io.KeyAlt) in.probe_keys = arrows();
  in.press = in.press || (ImGui::IsKeyDown(GLFW_KEY_SPACE) && !io.KeyCtrl && !io.KeyAlt);
  if (!io.KeyCtrl) {
    if (pressed(GLFW_KEY_EQUAL, true) || pressed(GLFW_KEY_KP_ADD, true)) in.push_notches += 1.0;
    if (pressed(GLFW_KEY_MINUS, true) || pressed(GLFW_KEY_KP_SUBTRACT, true)) in.push_notches -= 1.0;
    // Layouts without a plus beside the backspace key write it as a character.
    for (const ImWchar c : io.InputQueueCharacters)
      if (c == '+' && !pressed(GLFW_KEY_EQUAL, true) && !pressed(GLFW_KEY_KP_ADD, true)) in.push_notches += 1.0;
  }
  in.zoom_keys = (ImGui::IsKeyDown(GLFW_KEY_PAGE_UP) ? 1.0 : 0.0) - (ImGui::IsKeyDown(GLFW_KEY_PAGE_DOWN) ? 1.0 : 0.0);
  in.release = ImGui::IsKeyDown(GLFW_KEY_ESCAPE);
  if (pressed(GLFW_KEY_HOME)) app.resetView();
}

ViewInput readInput(Application& app, ImVec2 low, glm::dvec2 size) {
  const ImGuiIO& io = ImGui::GetIO();
  ViewInput in;
  in.size_px = size;
  in.dt_s = app.dt_s();
  const bool active = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
  const bool panning = active && (ImGui::IsMouseDown(2) || (ImGui::IsMouseDown(1) && io.KeyShift));
  const bool turning = active && !panning && ImGui::IsMouseDown(1);
  in.press = active && ImGui::IsMouseDown(0);
  const glm::dvec2 drag(io.MouseDelta.x, io.MouseDelta.y);
  if (panning) in.pan_px = drag;
  if (turning) in.orbit_px = drag;
  if ((hovered || in.press) && !panning && !turning && ImGui::IsMousePosValid())
    in.pointer_px = glm::dvec2(io.MousePos.x - low.x, io.MousePos.y - low.y);
  readKeys(app, in);
  if (hovered || active) (in.press ? in.push_notches : in.zoom_notches) += double(io.MouseWheel);
  return in;
}

ViewScene sceneOf(const Application& app) {
  ViewScene scene;
  const ServoSample& now = app.touch.latest();
  scene.molecule = app.stage.molecule;
  scene.camera = app.camera;
  scene.shown = app.shown;
  scene.theme = look().dark ? darkTheme() : lightTheme();
  if (app.stage && now.has_tracker) {
    scene.hip = now.hip;
    scene.contact = now.contact;
    scene.force_N = app.touch.force_N();
    scene.arrow_A_per_N = app.camera.pixel_A(app.camera.distance_A, std::max(1, int(app.layout.view.size().y))) * look().px(kArrow_px_per_N);
    scene.probe_A = now.probe_A;
  }
  scene.facets = feltFacets(app.method);
  app.lesson.decorate(scene);
  return scene;
}

void savePicture(Application& app) {
  const std::filesystem::path file = freePictureName(app.options.picture_folder);
  const std::optional<Problem> problem = writePng(file, app.picture->read());
  if (problem) app.messages.error(problem->text());
  else app.messages.notice("Picture saved as " + file.string());
}

}  // namespace

void drawViewPanel(Application& app) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  const bool shown = beginPanel("view", app.layout.view, ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  if (!shown) return;
  const Rectangle& r = app.layout.view;
  const glm::dvec2 size = r.size();
  const ImVec2 low{r.low.x, r.low.y}, high{r.high.x, r.high.y};
  ImGui::SetItemAllowOverlap();
  ImGui::InvisibleButton("view", {r.size().x, r.size().y},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
  ImGui::SetItemAllowOverlap();
  recordItem("view");
  const ViewInput in = readInput(app, low, size);
  app.controls.update(in, app.camera, app.stage.balls.get(), app.touch_settings, app.touch.touching(),
                      app.touch.force_N(), app.servo.mouse());
  if (app.controls.pressing() && (ImGui::IsItemHovered() || ImGui::IsItemActive())) ImGui::SetMouseCursor(ImGuiMouseCursor_None);

  ViewPicture& picture = *app.picture;
  picture.draw(sceneOf(app), int(size.x), int(size.y), app.controls.cameraMoved(), look().scale);
  // GL's rows begin at the bottom.
  if (picture.texture()) ImGui::GetWindowDrawList()->AddImage(picture.texture(), low, high, {0, 1}, {1, 0});
  if (app.take_picture) {
    app.take_picture = false;
    savePicture(app);
  }
  drawViewOverlays(app, r);
  endPanel();
}

}  // namespace moltact
