#include "app/ui/shell/scripted_user.h"

#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "app/ui/scene/view_picture.h"
#include "app/ui/shell/application_parts.h"
#include "app/ui/widgets/key_names.h"
#include "engine/core/utf8.h"
#include "engine/render/gl_objects.h"

namespace moltact {
struct ScriptedUser::Target {
  GlTarget gl;
};

ApplicationOptions ScriptedUser::framesClock() {
  ApplicationOptions options;
  options.clock = ServoClock::Frames;
  options.devices_unasked = false;  // a script does not depend on connected devices
  return options;
}

Expected<std::unique_ptr<ScriptedUser>> ScriptedUser::create(Options options) {
  Expected<std::unique_ptr<OffscreenGl>> gl = OffscreenGl::create();
  if (!gl) return gl.problem();
  std::unique_ptr<ScriptedUser> d(new ScriptedUser);
  d->options_ = std::move(options);
  d->gl_ = std::move(*gl);
  d->target_ = std::make_unique<Target>();
  d->shell_ = std::make_unique<Shell>();
  d->shell_->framebufferKept(true);
  d->app_ = std::make_unique<Application>(d->options_.application, applicationParts());
  return {std::move(d)};
}

ScriptedUser::~ScriptedUser() {
  // In this order: each holds objects of the GL context, which is destroyed last.
  app_.reset();
  shell_.reset();
  target_.reset();
}

void ScriptedUser::frame(bool drawn) {
  drawn_ = drawn;
  using Clock = std::chrono::steady_clock;
  const Clock::time_point begun = Clock::now();
  target_->gl.resize(options_.width, options_.height);
  target_->gl.bind();
  app_->picture().hold(!drawn);
  shell_->setLook(app_->settings.theme, float(options_.content_scale * app_->settings.scale),
                  float(app_->settings.text_size));
  shell_->frame(
      options_.width, options_.height, kFrame_s,
      [&] {
        app_->frame(kFrame_s, {options_.width, options_.height});
        target_->gl.bind();
      },
      drawn);
  if (drawn) glFinish();
  stats_.add(std::chrono::duration<double, std::milli>(Clock::now() - begun).count());
}

void ScriptedUser::frames(int n) {
  const auto drawn = [&](int left) {
    return options_.draws == Draws::All || (options_.draws == Draws::LastInRow && left <= 1);
  };
  do frame(drawn(n));
  while (!shell_->input().empty());
  for (int k = 1; k < n; ++k) frame(drawn(n - k));
}

void ScriptedUser::resize(int width, int height) {
  options_.width = width;
  options_.height = height;
  frames(3);
}

const WidgetRecord* ScriptedUser::seen(std::string_view widget) {
  const WidgetRecord* record = widgets().find(widget);
  if (record && !record->visible() && record->scrolls) {
    // Scrolls to a widget that is out of view with the wheel, as a user would.
    for (int tries = 0; tries < 60 && record && !record->visible(); ++tries) {
      const glm::vec2 inside = 0.5f * (record->clip_low + record->clip_high);
      shell_->input().pointer(inside.x, inside.y);
      shell_->input().wheel(0, record->centre().y > inside.y ? -1 : 1);
      frames(2);
      record = widgets().find(widget);
    }
  }
  if (record && record->visible()) return record;
  missing_ += std::string(widget) + '\n';
  return nullptr;
}

bool ScriptedUser::point(std::string_view widget, double x, double y) {
  const WidgetRecord* r = seen(widget);
  if (!r) return false;
  shell_->input().pointer(double(r->low.x) + x * double(r->high.x - r->low.x),
                          double(r->low.y) + y * double(r->high.y - r->low.y));
  frames(1);
  return true;
}

void ScriptedUser::press(int button) {
  shell_->input().button(button, true);
  frames(1);
}

void ScriptedUser::release(int button) {
  shell_->input().button(button, false);
  frames(2);
}

bool ScriptedUser::click(std::string_view widget, int button) {
  if (!point(widget)) return false;
  frames(1);
  press(button);
  release(button);
  return true;
}

bool ScriptedUser::drag(std::string_view widget, double dx, double dy, int button) {
  if (!point(widget)) return false;
  press(button);
  const ImVec2 from = ImGui::GetIO().MousePos;
  constexpr int kSteps = 8;
  for (int k = 1; k <= kSteps; ++k) {
    shell_->input().pointer(double(from.x) + dx * k / kSteps, double(from.y) + dy * k / kSteps);
    frames(1);
  }
  release(button);
  return true;
}

void ScriptedUser::wheel(double notches) {
  shell_->input().wheel(0, notches);
  frames(1);
}

void ScriptedUser::type(std::string_view utf8) {
  for (const char32_t c : charactersOf(utf8)) shell_->input().character(unsigned(c));
  frames(2);
}

bool ScriptedUser::hold(std::string_view names) {
  const std::vector<ImGuiKey> keys = keysNamed(names);
  for (const ImGuiKey key : keys) shell_->input().key(key, true);
  frames(1);
  return !keys.empty();
}

bool ScriptedUser::letGo(std::string_view names) {
  std::vector<ImGuiKey> keys = keysNamed(names);
  std::reverse(keys.begin(), keys.end());
  for (const ImGuiKey key : keys) shell_->input().key(key, false);
  frames(2);
  return !keys.empty();
}

bool ScriptedUser::tap(std::string_view names) {
  std::vector<ImGuiKey> keys = keysNamed(names);
  for (const ImGuiKey key : keys) shell_->input().key(key, true);
  std::reverse(keys.begin(), keys.end());
  for (const ImGuiKey key : keys) shell_->input().key(key, false);
  frames(2);
  return !keys.empty();
}

std::string ScriptedUser::text(std::string_view widget) const {
  const WidgetRecord* record = widgets().find(widget);
  return record ? record->text : std::string();
}

bool ScriptedUser::shows(std::string_view widget) const {
  const WidgetRecord* record = widgets().find(widget);
  return record && record->visible();
}

Picture ScriptedUser::picture() {
  if (!drawn_) frame(true);
  Picture out{options_.width, options_.height,
              std::vector<std::uint8_t>(std::size_t(options_.width) * std::size_t(options_.height) * 3)};
  std::vector<std::uint8_t> rows(out.rgb.size());
  target_->gl.bind();
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, options_.width, options_.height, GL_RGB, GL_UNSIGNED_BYTE, rows.data());
  const std::size_t row = std::size_t(options_.width) * 3;
  for (std::size_t y = 0; y < std::size_t(options_.height); ++y)
    std::copy_n(rows.begin() + std::ptrdiff_t((std::size_t(options_.height) - 1 - y) * row), row,
                out.rgb.begin() + std::ptrdiff_t(y * row));
  return out;
}

}  // namespace moltact
