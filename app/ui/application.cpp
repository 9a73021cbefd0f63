#include "app/ui/application.h"

#include <algorithm>
#include <cmath>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include "app/ui/library.h"
#include "app/ui/panels/panels.h"
#include "app/ui/theme.h"
#include "app/ui/view_picture.h"
#include "engine/haptics/sweep.h"
#include "engine/molecule/catalogue.h"

namespace moltact {
namespace {

constexpr double kLeftBehind_s = 0.4;   // contact without cause for so long is let go
constexpr double kSaveAfter_s = 1.0;    // settings are written when they have rested for so long
constexpr double kHintFade_s = 0.6;
constexpr double kProbeRoom = 2.0;      // so many radii of the probe are seen round the molecule
constexpr double kStill_A = 2e-3;       // a hand slower than this in a frame is at rest

}  // namespace

Application::Application(ApplicationOptions given)
    : servo(given.clock), method(methods().front().name), picture(std::make_unique<ViewPicture>()), options(std::move(given)) {
  if (options.settings_file.empty()) return;
  LoadedSettings loaded = loadSettings(options.settings_file);
  settings = saved_settings_ = std::move(loaded.settings);
  if (!loaded.trouble.empty()) messages.warning(loaded.trouble);
}

Application::~Application() {
  if (!options.settings_file.empty() && !(settings == saved_settings_)) moltact::saveSettings(settings, options.settings_file);
}

void Application::open(const std::filesystem::path& file) {
  if (looksLikeLesson(file)) {
    if (const std::optional<std::string> problem = lesson.open(file)) {
      messages.error(*problem);
      return;
    }
    messages.clearErrors();
    settings.remember(file);
    panels.lesson = panels.lesson_first = true;
    enterScene();
    return;
  }
  const Expected<std::filesystem::path> found = findMolecule(file.string(), MoleculeFolders::ofThisComputer());
  if (!found) {
    messages.error(found.problem().text());
    return;
  }
  step_scene_ = false;
  loader_.begin(*found);
  if (options.clock == ServoClock::Frames) finishLoading();
}

void Application::openFirst() {
  const auto& all = lessons();
  const auto first = std::find_if(all.begin(), all.end(), [](const LibraryItem& l) { return l.id == "first-touch"; });
  if (first != all.end()) open(first->file);
  else if (!all.empty()) open(all.front().file);
  else if (!library().empty()) open(library().front().file);
}

void Application::enterScene() {
  const SceneSpec* scene = lesson.takeNewScene();
  if (!scene) return;
  panels.hints = false;
  touch_settings.probe_A = scene->probe_A;
  touch_settings.stiffness_N_per_mm = scene->stiffness_N_per_mm;
  touch_settings.force_on = scene->force;
  if (findMethod(scene->method) && scene->method != method) useMethod(scene->method);
  shown = lesson.shapes();
  const bool asks = lesson.wantsPanel("methods");
  if (asks || panels.methods_by_step) {
    const bool by_hand = panels.methods && !panels.methods_by_step;
    showMethods(asks);
    panels.methods_by_step = asks && !by_hand;
  }
  if (stage) lesson.meet(stage.molecule, stage_file);
  const Expected<std::filesystem::path> file = lesson.moleculeFile();
  if (!file) {
    messages.error(file.problem().text());
    return;
  }
  if (*file == stage_file && stage && !loader_.busy()) {
    touch.clear();
    resetView();
    servo.beginAgain(touch_settings);
    return;
  }
  step_scene_ = true;
  loader_.begin(*file);
  if (options.clock == ServoClock::Frames) finishLoading();
}

void Application::finishLoading() {
  if (std::optional<Loaded> loaded = loader_.wait()) takeUp(std::move(*loaded));
}

void Application::takeUp(Loaded loaded) {
  const bool from_step = std::exchange(step_scene_, false);
  if (!loaded.stage) {
    messages.error(loaded.stage.problem().text());
    return;
  }
  messages.clearErrors();
  // A lesson's author knows what the file leaves out.
  if (!from_step) {
    for (const std::string& warning : loaded.stage->molecule->warnings) messages.notice(warning);
    settings.remember(loaded.file);
  }
  show(*std::move(loaded.stage), loaded.file);
}

void Application::show(Stage next, const std::filesystem::path& file) {
  stage = std::move(next);
  stage_file = file;
  lesson.meet(stage.molecule, file);
  touch_settings.workspace = stage.workspace;
  touch.clear();
  watch.begin(stage, touch_settings.probe_A);
  resetView();
  servo.begin(touch_settings, makeTracker(stage, *findMethod(method), touch_settings.probe_A, Contact{}, PointA{}));
}

void Application::resetView() {
  if (!stage) return;
  camera.orientation = glm::dquat(1, 0, 0, 0);
  // Round the molecule there is room for the probe, which hovers before it and beside it.
  const auto fit = [&] { camera.fit(*stage.molecule, view_aspect_, 0.08, kProbeRoom * touch_settings.probe_A); };
  fit();
  lesson.face(camera, *stage.molecule);
  // Another side of the molecule may be wider.
  fit();
  ++touch_settings.placements;
  controls.begin(camera, stage.middle, stage.workspace, std::min(stage.reach_A, camera.distance_A), servo.mouse());
  servo.setSettings(touch_settings);
}

void Application::useMethod(std::string_view name) {
  const Method* m = findMethod(name);
  if (!m) return;
  method = m->name;
  // Each method goes on from the true contact, so that none inherits what another got wrong.
  const Contact& contact = watch.exact().touching() ? watch.exact() : touch.latest().contact;
  servo.setTracker(makeTracker(stage, *m, touch_settings.probe_A, contact, touch.latest().hip));
}

void Application::showMethods(bool on) {
  panels.methods = panels.methods_first = on;
  panels.methods_by_step = false;
  if (on) panels.touch = true;
}

void Application::watchLeftBehind() {
  const ServoSample& now = touch.latest();
  const bool free = stage && touch.touching() && clearance(*stage.balls, now.probe_A, now.hip.A) > 0.0;
  touch.countLeftBehind(free && !controls.pressing(), dt_s_);
  if (touch.leftBehind_s() <= kLeftBehind_s) return;
  ++touch_settings.placements;
  touch.countLeftBehind(false, dt_s_);
}

void Application::shortcuts() {
  const ImGuiIO& io = ImGui::GetIO();
  const auto pressed = [](int key) { return ImGui::IsKeyPressed(key, false); };
  if (io.KeyCtrl && !io.KeyShift && !io.KeyAlt) {
    if (pressed(GLFW_KEY_O)) panels.open_page = true;
    if (pressed(GLFW_KEY_Q)) quit = true;
    if (pressed(GLFW_KEY_S) && stage) take_picture = true;
  }
  if (pressed(GLFW_KEY_F1)) panels.controls_page = true;
  if (io.KeyAlt && !io.KeyCtrl && !io.WantTextInput) {
    if (pressed(GLFW_KEY_RIGHT) && lesson.canGoOn()) lesson.next();
    if (pressed(GLFW_KEY_LEFT) && lesson.canGoBack()) lesson.back();
  }
}

double Application::hintStrength() const { return std::clamp(hint_left_s_ / kHintFade_s, 0.0, 1.0); }

void Application::frame(double dt_s, glm::vec2 window_px, double content_scale) {
  dt_s_ = dt_s;
  now_s_ += dt_s;
  content_scale_ = content_scale;
  if (std::optional<Loaded> loaded = loader_.take()) takeUp(std::move(*loaded));

  const PointA hand_before = touch.latest().hip;
  for (const ServoSample& sample : servo.advance(dt_s)) {
    touch.add(sample);
    const Method& m = *findMethod(method);
    lesson.feed(sample, m.name, watch.add(sample, m));
  }
  touch.measure(now_s_);
  servo.timeTicks(methodsInFront());
  hand_moved_ = glm::distance(hand_before.A, touch.latest().hip.A) > kStill_A;
  watchLeftBehind();
  servo.setSettings(touch_settings);
  messages.age(dt_s);
  if (controls.hasPressed() && controls.hasTurned()) hint_left_s_ -= dt_s;

  shortcuts();
  layout = layOut({.window = window_px, .scale = look().scale, .lesson = panels.lesson && lesson.session(), .touch = panels.touch,
                   .lesson_width = float(settings.lesson_width), .touch_width = float(settings.touch_width)},
                  panels.lesson_first);
  // The first picture of a scene is fitted to the view as it really is.
  const glm::vec2 view = layout.view.size();
  const double aspect = view.y > 0 ? double(view.x) / double(view.y) : 1.0;
  if (aspect_guessed_ && stage) {
    view_aspect_ = aspect;
    aspect_guessed_ = false;
    resetView();
  }
  view_aspect_ = aspect;

  for (const Panel& panel : allPanels()) panel.draw(*this);
  enterScene();
  saveSettingsSoon();
}

void Application::saveSettingsSoon() {
  if (options.settings_file.empty() || settings == saved_settings_) return;
  since_change_s_ = settings == changing_settings_ ? since_change_s_ + dt_s_ : 0.0;
  changing_settings_ = settings;
  if (since_change_s_ < kSaveAfter_s) return;
  if (const std::string trouble = moltact::saveSettings(settings, options.settings_file); !trouble.empty()) messages.warning(trouble);
  saved_settings_ = settings;
}

bool Application::live() const {
  const bool hint_fades = hint_left_s_ > 0.0 && hint_left_s_ < kHintFade_s;
  return touch.touching() || controls.pressing() || controls.cameraMoved() || hand_moved_ || loader_.busy() || messages.fading() ||
         hint_fades || picture->unfinished();
}

}  // namespace moltact
