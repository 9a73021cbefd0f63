// The centre: the molecule and the probe, the contact in words, a scale bar, and the input of mouse and keys.
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/panels/dark_view.h"
#include "app/ui/panels/lesson/lesson_keys.h"
#include "app/ui/panels/method_chooser.h"
#include "app/ui/panels/pose_list.h"
#include "app/ui/panels/push_pads.h"
#include "app/ui/panels/residue_forces.h"
#include "app/ui/panels/view_overlays.h"
#include "app/ui/scene/contact_text.h"
#include "app/ui/scene/view_picture.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/damage.h"
#include "app/ui/widgets/fingers.h"
#include "app/ui/widgets/imgui_versions.h"
#include "app/ui/widgets/key_focus.h"
#include "app/ui/widgets/theme.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/language/catalogue.h"
#include "engine/platform/hand_over.h"
#include "engine/render/label_painter.h"

namespace moltact {
namespace {

glm::dvec2 arrows() {
  const auto down = [](ImGuiKey key) { return ImGui::IsKeyDown(key) ? 1.0 : 0.0; };
  return {down(ImGuiKey_RightArrow) - down(ImGuiKey_LeftArrow), down(ImGuiKey_UpArrow) - down(ImGuiKey_DownArrow)};
}

bool pressed(ImGuiKey key, bool repeat = false) { return ImGui::IsKeyPressed(key, repeat); }

// Switches to the method `by` places further in the list, cyclically. The key also works if the panel has no room.
void switchMethod(Application& app, int by) {
  const auto all = methods();
  const auto count = static_cast<std::ptrdiff_t>(all.size());
  useMethod(
      app.scene,
      all[static_cast<std::size_t>((findMethod(app.scene.touch().method) - all.data() + by + count) % count)].name);
}

void readKeys(Application& app, ViewInput& in) {
  const ImGuiIO& io = ImGui::GetIO();
  // A text field, an open page or a panel with the focus receives the keys first.
  if (!keysFree()) return;
  if (io.KeyCtrl && io.KeyShift && !io.KeyAlt && app.scene.servo().loop().hasOrientation())
    in.hand_keys = arrows();
  else if (io.KeyCtrl && !io.KeyAlt)
    in.orbit_keys = arrows();
  else if (app.scene.playedHand().on())
    return;  // the keys belong to the bar
  else if (io.KeyShift && !io.KeyAlt)
    in.pan_keys = arrows();
  else if (!io.KeyAlt && !app.panels.arrows_draw)
    in.probe_keys = arrows();
  // A press continues while Ctrl and the arrows rotate the molecule.
  in.press =
      in.press || (ImGui::IsKeyDown(ImGuiKey_Space) && !io.KeyAlt && (!io.KeyCtrl || app.scene.controls.pressing()));
  if (!io.KeyCtrl) {
    if (pressed(ImGuiKey_Equal, true) || pressed(ImGuiKey_KeypadAdd, true)) in.push_notches += 1.0;
    if (pressed(ImGuiKey_Minus, true) || pressed(ImGuiKey_KeypadSubtract, true)) in.push_notches -= 1.0;
    // On layouts where another key writes plus or minus, only the character arrives.
    for (const ImWchar c : io.InputQueueCharacters) {
      if (c == '+' && !ImGui::IsKeyDown(ImGuiKey_Equal) && !ImGui::IsKeyDown(ImGuiKey_KeypadAdd))
        in.push_notches += 1.0;
      if (c == '-' && !ImGui::IsKeyDown(ImGuiKey_Minus) && !ImGui::IsKeyDown(ImGuiKey_KeypadSubtract))
        in.push_notches -= 1.0;
    }
  }
  if (!io.KeyCtrl)
    in.zoom_keys = (ImGui::IsKeyDown(ImGuiKey_PageUp) ? 1.0 : 0.0) - (ImGui::IsKeyDown(ImGuiKey_PageDown) ? 1.0 : 0.0);
  in.release = ImGui::IsKeyDown(ImGuiKey_Escape);
  if (app.panels.tabs.has("methods") && !app.lesson.locks("method") && !app.extensions().task_stager.dark() &&
      lessonKeyPressed('M'))
    switchMethod(app, io.KeyShift ? -1 : 1);
}

// The wheel and the keys Page Up and Page Down move the cutting plane away from the viewer and back.
void moveCut(Application& app, double notches) {
  constexpr double kNotch = 0.02, kKeys_per_s = 0.25;  // shares of the molecule's extent
  if (keysFree())
    notches +=
        (ImGui::IsKeyDown(ImGuiKey_PageUp) - ImGui::IsKeyDown(ImGuiKey_PageDown)) * (kKeys_per_s / kNotch) * app.dt_s();
  CutPlane& cut = *app.scene.look.atoms.cut;
  const double reach_A = app.scene.stage().reach_A, middle_A = glm::dot(cut.normal, app.scene.stage().middle.A);
  cut.offset_A = std::clamp(cut.offset_A - notches * kNotch * reach_A, middle_A - reach_A, middle_A + reach_A);
}

ViewInput readInput(Application& app, ImVec2 low, glm::dvec2 size) {
  const ImGuiIO& io = ImGui::GetIO();
  ViewInput in;
  in.size_px = size;
  in.dt_s = app.dt_s();
  const bool active = ImGui::IsItemActive(), hovered = ImGui::IsItemHovered();
  const int push = app.settings.left_handed && !app.panels.window.fingers ? 1 : 0, turn = 1 - push;
  const bool panning = active && (ImGui::IsMouseDown(2) || (ImGui::IsMouseDown(turn) && io.KeyShift));
  const bool view_fingers = hovered && app.panels.window.fingers && ImGui::IsMouseDown(Fingers::kViewButton);
  const bool turning = !panning && ((active && ImGui::IsMouseDown(turn)) || view_fingers);
  Measuring& tool = app.extensions().measuring;
  const bool measuring = tool.on() && !app.extensions().task_stager.dark();
  in.press = active && ImGui::IsMouseDown(push) && !app.scene.playedHand().on() && !measuring;
  if (measuring && hovered && ImGui::IsMouseReleased(push) && app.scene.stage() &&
      io.MouseDragMaxDistanceSqr[push] < look().px(4) * look().px(4)) {
    if (const auto atom = atomAt(app.scene, {double(io.MousePos.x - low.x), double(io.MousePos.y - low.y)}, size))
      tool.take(*app.scene.stage().molecule, *atom);
    else
      tool.finish();
  }
  // A double click on an atom moves the camera close to it.
  if (!measuring && !app.extensions().task_stager.dark() && hovered && app.scene.stage() &&
      !app.scene.playedHand().on() && ImGui::IsMouseReleased(push) && io.MouseClickedLastCount[push] == 2 &&
      io.MouseDragMaxDistanceSqr[push] < look().px(4) * look().px(4))
    if (const auto atom = atomAt(app.scene, {double(io.MousePos.x - low.x), double(io.MousePos.y - low.y)}, size)) {
      const std::uint32_t only[] = {*atom};
      app.zoomTo(only);
    }
  // The motion up to the place where the button was pressed is not part of the drag.
  const bool begins = ImGui::IsMouseClicked(turn) || ImGui::IsMouseClicked(2) ||
                      (view_fingers && ImGui::IsMouseClicked(Fingers::kViewButton));
  const glm::dvec2 drag = begins ? glm::dvec2(0.0) : glm::dvec2(io.MouseDelta.x, io.MouseDelta.y);
  if (panning) in.pan_px = drag;
  const bool turns_hand = turning && !view_fingers && (io.KeyCtrl || app.panels.window.fingers) &&
                          app.scene.servo().loop().hasOrientation() && !app.scene.playedHand().on();
  if (turning) (turns_hand ? in.hand_px : in.orbit_px) = drag;
  if (turns_hand && app.panels.window.fingers) in.hand_roll_rad = double(io.MouseWheelH) * Fingers::kTwistNotch_rad;
  if ((hovered || in.press) && !panning && !turning && ImGui::IsMousePosValid())
    in.pointer_px = glm::dvec2(io.MousePos.x - low.x, io.MousePos.y - low.y);
  in.over_control = !hovered && !active && ImGui::IsMousePosValid() && !app.panels.window.fingers &&
                    io.MousePos.x >= low.x && io.MousePos.x < low.x + float(size.x) && io.MousePos.y >= low.y &&
                    io.MousePos.y < low.y + float(size.y);
  readKeys(app, in);
  // If a task changes the stiffness, the hand keeps the depth of its press, so that the change is felt.
  if (app.extensions().task_stager.changesStiffness())
    in.expected_N_per_mm = app.lesson.session()->scene().touch.stiffness_N_per_mm;
  if (app.scene.look.atoms.cut && io.KeyCtrl && !in.press && !app.lesson.locks("show")) {
    moveCut(app, hovered || active ? double(io.MouseWheel) : 0.0);
    return in;
  }
  if (hovered || active) (in.press ? in.push_notches : in.zoom_notches) += double(io.MouseWheel);
  return in;
}

}  // namespace

ViewScene seenScene(const Application& app) {
  ViewScene scene;
  const ServoSample& now = app.scene.log().latest();
  scene.molecule = app.scene.atoms().drawn();
  scene.camera = app.scene.camera;
  scene.shown = app.extensions().reveal_policy.shownParts();
  scene.theme = look().viewTheme();
  scene.elements = elementColoursOf(app.settings);
  scene.colour_by = app.scene.look.colour_by;
  scene.look = app.scene.look.atoms;
  scene.strongest_N = app.scene.servo_settings.max_force_N;
  if (app.scene.stage() && now.has_interaction) {
    scene.hip = now.hip;
    scene.contact = now.contact;
    scene.coupled = now.molecular_energy.has_value();
    if (now.contact.touching()) scene.named_atoms = app.extensions().state_text.namedAtoms();
    scene.force_N = app.scene.log().force_N();
    if (now.inField() && now.felt()) scene.field_direction = now.forceDirection();
    scene.arrow_A_per_N =
        app.scene.camera.pixel_A(app.scene.camera.distance_A, std::max(1, int(app.layout().view.size().y))) *
        look().px(kArrow_px_per_N);
    scene.probe_A = now.probe_A;
    if (now.holds_body) {
      scene.body = app.scene.stage().body;
      const PoseA shown = now.shownBody();
      scene.body_place = shown.place;
      scene.body_orientation = shown.orientation;
      scene.hand_orientation = now.orientation;
      const LoadedAtoms& contacts = app.scene.bodyContacts();
      scene.body_stopped = contacts.body;
      if (app.extensions().reveal_policy.names(now.contact)) scene.stopped_by = contacts.scene;
      scene.torque_N_A = now.shownTorque_N_A();
    }
  }
  // The ghost stands in for the force that a mouse cannot give.
  if (const LessonSession* session = app.lesson.session(); session && app.lesson.onStage() && scene.hip)
    if (const std::optional<TaskGuide> guide = session->taskGuide();
        guide && !app.scene.playedHand().on() && (guide->ghost_with_device || !app.scene.leads()))
      scene.ghost = guide->ghost;
  showForces(app, scene);
  showPose(app, scene);
  app.extensions().surface_scan.showIn(scene);
  scene.water = app.settings.probe_look != ProbeLook::Sphere;
  scene.hand = app.extensions().hand_model.model();
  scene.left_hand = app.settings.left_handed;
  scene.facets = feltFacets(app.scene.touch().method);
  app.lesson.decorate(scene);
  const TouchPaint& paint = app.extensions().touch_paint;
  scene.touched = paint.painted();
  scene.touched_now = paint.fresh();
  for (const auto& written : {app.extensions().measuring.drawn(), app.scene.look.atoms.annotations, paint.trail()})
    if (written) scene.annotations.push_back(written);
  return scene;
}

namespace {

void savePicture(Application& app, glm::dvec2 size, std::filesystem::path file) {
  if (file.empty()) file = freePictureName(app.options().picture_folder);
  const ViewScene scene = seenScene(app);
  Picture picture = app.picture().take(scene, int(size.x), int(size.y), look().scale);
  if (!scene.annotations.empty() || scene.held_lines)
    paintLabels(picture, scene, app.scene.stage().spheres.get(), double(look().px(1)));
  const std::optional<Problem> problem = writePng(file, picture);
  if (problem)
    app.messages.error(problem->text());
  else
    app.messages.notice(trf("Picture saved as {0}", file.string()));
  if (!problem) handOver(file);
}

}  // namespace

void drawViewPanel(Application& app) {
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
  // The picture covers the whole view; a background would double the cost with software rendering.
  const bool shown =
      beginPanel("view", app.layout().view,
                 ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse);
  ImGui::PopStyleVar();
  if (!shown) return;
  const Rectangle& r = app.layout().view;
  const glm::dvec2 size = r.size();
  const ImVec2 low{r.low.x, r.low.y}, high{r.high.x, r.high.y};
  buttonUnderOthers(
      "view", {r.size().x, r.size().y},
      ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight | ImGuiButtonFlags_MouseButtonMiddle);
  recordRectangle("view", r.low, r.high);
  const ViewInput in = readInput(app, low, size);
  app.scene.controls.update(in, app.scene.camera, app.scene.scanned().underPointer(), app.scene.servo_settings,
                            app.scene.log().latest(), app.scene.servo().mouse(), app.scene.stage().body.get());
  if (app.scene.controls.pressing() && (ImGui::IsItemHovered() || ImGui::IsItemActive()))
    ImGui::SetMouseCursor(ImGuiMouseCursor_None);

  if (app.extensions().task_stager.dark()) {
    drawDarkView(app, r);
    drawPushPads(app, r);
    if (app.takePictureRequest()) app.messages.notice(tr("The screen is dark: there is nothing to save as a picture."));
    endPanel();
    return;
  }
  ViewPicture& picture = app.picture();
  const SceneChange& change = app.extensions().scene_change;
  const ViewScene scene = seenScene(app);
  picture.draw(scene, int(size.x), int(size.y),
               app.scene.controls.cameraMoved() || change.gliding() || app.scene.atoms().moving(), look().scale);
  if (picture.texture()) addPicture(*ImGui::GetWindowDrawList(), picture.texture(), r, picture.version());
  if (change.oldPicture() > 0 && picture.kept())
    ImGui::GetWindowDrawList()->AddImage(picture.kept(), low, high, {0, 1}, {1, 0},
                                         faded(IM_COL32_WHITE, float(change.oldPicture())));
  if (std::optional<std::filesystem::path> file = app.takePictureRequest()) savePicture(app, size, std::move(*file));
  drawViewLabels(app, scene, r);
  if (const RevealPolicy& policy = app.extensions().reveal_policy; policy.veil() > 0.0) {
    if (policy.veilIsDark())
      drawDarkVeil(r, float(policy.veil()));
    else if (picture.kept())
      ImGui::GetWindowDrawList()->AddImage(picture.kept(), low, high, {0, 1}, {1, 0},
                                           faded(IM_COL32_WHITE, float(policy.veil())));
  }
  drawViewOverlays(app, r);
  drawPushPads(app, r);
  endPanel();
}

}  // namespace moltact
