// The window in a browser page: a canvas with WebGL 2. app/web/page.js receives the events of mouse, keys, fingers and
// pens, requests a frame whenever the browser draws, and calls the functions below. Everything runs on the page's only
// thread.
#include <emscripten.h>
#include <emscripten/html5.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/ui/application/application.h"
#include "app/ui/extensions/extensions.h"
#include "app/ui/extensions/learner_known.h"
#include "app/ui/files/user_folders.h"
#include "app/ui/shell/application_parts.h"
#include "app/ui/shell/keyboard_layout.h"
#include "app/ui/shell/page_keys.h"
#include "app/ui/shell/pointers.h"
#include "app/ui/shell/shell.h"
#include "app/ui/shell/window.h"
#include "app/ui/widgets/widget_map.h"
#include "engine/core/utf8.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/class_hold.h"
#include "engine/lesson/lesson_files.h"
#include "engine/lesson/reader.h"
#include "engine/pack/pack_file.h"
#include "engine/platform/storage_web.h"
#include "engine/render/gl.h"
#include "engine/results/attempt_file.h"
#include "engine/results/learning_link.h"
#include "engine/results/learning_record.h"
#include "engine/results/suspended.h"

// Functions of page.js that the program calls.
EM_JS(void, copyText, (const char* text), { Module.page.copy(UTF8ToString(text)); })
EM_JS(void, showCursor, (int shape), { Module.page.cursor(shape); })
EM_JS(void, vibrate, (int ms), { Module.page.vibrate(ms); })
EM_JS(int, hasTouchScreen, (void), { return Module.page.fingers() ? 1 : 0; })
EM_JS(void, leavePlatform, (void), { Module.page.leavePlatform(); })
EM_JS(void, showFullScreen, (int on), { Module.page.fullScreen(on); })

namespace moltact {
namespace {

struct Page {
  Shell shell;
  Application app;
  Pointers pointers{app, shell.input()};
  std::string clipboard, words;
  std::map<ImGuiKey, std::string> layout;  // the characters of the keys that the user has pressed so far
  std::array<std::int32_t, 3> touched{-1, -1, -1};
  double pen_N = 0.0;  // the force for the pen's present pressure; 0: no pressure
  int cursor = ImGuiMouseCursor_Arrow;

  explicit Page(const WindowOptions& options)
      : app({.clock = ServoClock::Page,
             .devices_unasked = false,
             .language = options.language,
             .settings_file = settingsFile(),
             .attempts_folder = attemptsFolder(),
             .cache_folder = cacheFolder(),
             .picture_folder = "/tmp"},
            applicationParts()) {}
};

std::unique_ptr<Page> page;

// The lesson of a learning platform (app/web/platform.js), if the page was packed for one.
struct PlatformLesson {
  GrowingAttempt attempt;
  std::string json;
  MessageId lost = 0;
};
std::optional<PlatformLesson> platform_lesson;

// The lesson that the pack's manifest names, whose ids the platform sees in every language.
LessonOutline manifestOutline(const std::filesystem::path& pack, const std::filesystem::path& folder) {
  const Expected<PackFile> opened = PackFile::open(pack);
  const LessonReading reading = opened ? readLesson(folder / opened->lesson()) : LessonReading();
  return reading.lesson ? outlineOf(*reading.lesson, {}) : LessonOutline();
}

void openInPlatform(const std::filesystem::path& pack, const std::string& suspended) {
  Application& app = page->app;
  learnerKnownFlag() = true;
  const std::filesystem::path lesson = app.extensions().lesson_list.add(pack);
  if (lesson.empty()) {
    app.panels.pages.welcome = true;
    return;
  }
  LessonOutline outline = manifestOutline(pack, lesson.parent_path());
  std::filesystem::path attempt;
  if (!suspended.empty()) {
    Expected<std::filesystem::path> found = attemptToResume(attemptsFolder(), suspended, outline);
    if (found)
      attempt = *std::move(found);
    else
      app.messages.warning(trf("{0}. The lesson begins anew.", found.problem().text()));
  }
  app.extensions().recorder.resume(lesson, attempt);
  platform_lesson.emplace(PlatformLesson{GrowingAttempt(std::move(outline)), {}});
}

// If the device can vibrate, it signals a contact and each crossing to other atoms. A field has no such instants: it
// begins and ends gradually, so it gives no pulse.
void feel() {
  const Contact& contact = page->app.scene.log().latest().contact;
  const std::array<std::int32_t, 3> now = contact.touching() ? contact.atoms : std::array<std::int32_t, 3>{-1, -1, -1};
  if (now == page->touched) return;
  page->touched = now;
  constexpr int kShort_ms = 12;
  if (contact.touching() && page->app.scene.controls.pressing()) vibrate(kShort_ms);
}

bool makeContext() {
  EmscriptenWebGLContextAttributes wanted;
  emscripten_webgl_init_context_attributes(&wanted);
  wanted.majorVersion = 2;
  wanted.alpha = wanted.depth = wanted.antialias = false;
  wanted.preserveDrawingBuffer = true;  // only the changes of a frame are drawn
  const EMSCRIPTEN_WEBGL_CONTEXT_HANDLE made = emscripten_webgl_create_context("#view", &wanted);
  return made > 0 && emscripten_webgl_make_context_current(made) == EMSCRIPTEN_RESULT_SUCCESS;
}

}  // namespace

int runWindow(const WindowOptions& options) {
  if (!makeContext()) return 1;
  page = std::make_unique<Page>(options);
  ImGuiIO& io = ImGui::GetIO();
  io.SetClipboardTextFn = [](void*, const char* text) {
    page->clipboard = text;
    copyText(text);
  };
  io.GetClipboardTextFn = [](void*) { return page->clipboard.c_str(); };
  page->shell.framebufferKept(true);
  page->app.extensions().state_text.writeTo("-");
  page->app.panels.window.fingers = hasTouchScreen() != 0;
  if (options.file.empty())
    page->app.panels.pages.welcome = true;
  else
    page->app.open(options.file);
  return 0;
}

}  // namespace moltact

using moltact::page;

extern "C" {

// Runs one frame of the given size. Returns bits: 1 the next frame will differ, 2 a text field has the focus.
EMSCRIPTEN_KEEPALIVE int moltact_frame(int width, int height, double content_scale, double dt_s) {
  moltact::Application& app = page->app;
  if (const std::string fault = moltact::takeStorageFault(); !fault.empty())
    app.messages.ask(moltact::MessageKind::Warning, fault, {});  // a warning, because errors disappear when another
                                                                 // scene opens
  page->shell.setLook(app.settings.theme, float(content_scale * app.settings.scale), float(app.settings.text_size));
  page->shell.frame(width, height, dt_s, [&] { app.frame(dt_s, {float(width), float(height)}); });
  moltact::feel();
  if (const int cursor = ImGui::GetMouseCursor(); cursor != page->cursor) showCursor(page->cursor = cursor);
  static bool full_screen = false;
  if (app.panels.window.full_screen != full_screen) showFullScreen(full_screen = app.panels.window.full_screen);
  return (app.live() || !page->shell.input().empty() ? 1 : 0) | (ImGui::GetIO().WantTextInput ? 2 : 0);
}

EMSCRIPTEN_KEEPALIVE void moltact_pointer(double x, double y) { page->pointers.mouse({x, y}); }
EMSCRIPTEN_KEEPALIVE void moltact_pointer_left() { page->shell.input().pointerLeft(); }
EMSCRIPTEN_KEEPALIVE void moltact_button(int button, int down) { page->shell.input().button(button, down != 0); }
EMSCRIPTEN_KEEPALIVE void moltact_wheel(double x, double y) { page->shell.input().wheel(x, y); }
EMSCRIPTEN_KEEPALIVE void moltact_focus_lost() { page->shell.input().focusLost(); }

// `writes`: the character that the key writes without Shift, Ctrl or Alt; empty if unknown. Returns true if the program
// handles the key, so that the browser must not.
EMSCRIPTEN_KEEPALIVE int moltact_key(const char* code, const char* writes, int down) {
  const ImGuiKey place = moltact::keyOfPage(code);
  if (!moltact::isKey(place)) return 0;
  if (*writes) page->layout[place] = writes;
  const ImGuiKey key = moltact::keyOnLayout(place, [](ImGuiKey at) -> std::string_view {
    const auto known = page->layout.find(at);
    return known == page->layout.end() ? std::string_view() : std::string_view(known->second);
  });
  if (!moltact::isKey(key)) return 0;
  page->shell.input().key(key, down != 0);
  return 1;
}

EMSCRIPTEN_KEEPALIVE void moltact_text(const char* utf8) {
  for (const char32_t c : moltact::charactersOf(utf8)) page->shell.input().character(unsigned(c));
}

EMSCRIPTEN_KEEPALIVE void moltact_clipboard(const char* utf8) { page->clipboard = utf8; }

// Fingers: place in pixels, time in seconds.
EMSCRIPTEN_KEEPALIVE void moltact_finger_down(int id, double x, double y, double now_s) {
  page->pointers.fingerDown(id, {x, y}, now_s);
}
EMSCRIPTEN_KEEPALIVE void moltact_finger_move(int id, double x, double y, double) {
  page->pointers.fingerMove(id, {x, y});
}
EMSCRIPTEN_KEEPALIVE void moltact_finger_up(int id, double) { page->pointers.fingerUp(id); }
EMSCRIPTEN_KEEPALIVE void moltact_fingers(double now_s) { page->pointers.advance(now_s); }

// A pen's pressure, 0 to 1, while it pushes on the view. It sets the force at which the push comes to rest.
EMSCRIPTEN_KEEPALIVE void moltact_pen(double pressure) {
  if (!page->app.scene.controls.pressing()) {
    page->pen_N = moltact::PointerHand::kRest_N;
    return;
  }
  constexpr double kMax_N = 2.5;
  const double wanted_N = std::max(moltact::PointerHand::kMinPress_N, kMax_N * std::clamp(pressure, 0.0, 1.0));
  page->shell.input().wheel(0.0, (wanted_N - page->pen_N) / moltact::PointerHand::kNotch_N);
  page->pen_N = wanted_N;
}

// The texts on the screen and those that scrolling would show, in reading order: JSON of [text, x, y]; x is -1 for
// texts that cannot be pressed.
EMSCRIPTEN_KEEPALIVE const char* moltact_words() {
  std::vector<const moltact::WidgetRecord*> seen;
  for (const auto& [name, record] : moltact::widgets().all())
    if (!record.text.empty() && (record.visible() || record.scrolls)) seen.push_back(&record);
  std::sort(seen.begin(), seen.end(),
            [](const auto* a, const auto* b) { return std::pair(a->low.y, a->low.x) < std::pair(b->low.y, b->low.x); });
  nlohmann::json all = nlohmann::json::array();
  for (const moltact::WidgetRecord* r : seen) {
    const glm::vec2 at = r->key_stop && r->visible() ? r->centre() : glm::vec2(-1.0f);
    all.push_back({r->text, at.x, at.y});
  }
  page->words = all.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return page->words.c_str();
}

// The rectangles of all named widgets, for scripts that test the page: JSON of {name: [low x, low y, high x, high y,
// text, visible]}.
EMSCRIPTEN_KEEPALIVE const char* moltact_widgets() {
  nlohmann::json all = nlohmann::json::object();
  for (const auto& [name, r] : moltact::widgets().all())
    all[name] = {r.low.x, r.low.y, r.high.x, r.high.y, r.text, r.visible()};
  page->words = all.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return page->words.c_str();
}

// Reports a download that failed.
EMSCRIPTEN_KEEPALIVE void moltact_fault(const char* url, const char* why) {
  page->app.messages.error(moltact::trf("{0} cannot be fetched: {1}", url, why));
}

// Opens a file that the user dropped or chose and that page.js has stored there.
EMSCRIPTEN_KEEPALIVE void moltact_open(const char* file) { page->app.drop({file}); }

// The code by which the page of a study has chosen the group.
EMSCRIPTEN_KEEPALIVE void moltact_code(const char* code) { moltact::assignedCode() = code; }

// Opens the pack as the lesson of a learning platform, where `suspended` (suspended.h) left it. If that is empty, the
// lesson begins, whatever this browser has kept.
EMSCRIPTEN_KEEPALIVE void moltact_platform_open(const char* pack, const char* suspended) {
  moltact::openInPlatform(pack, suspended);
}

// The platform names an address to return to.
EMSCRIPTEN_KEEPALIVE void moltact_platform_returns() { moltact::platformReturn() = leavePlatform; }

// The record for the platform (learning_record.h) with the interactions from the index `from` on; empty before the
// student has begun. `max_chars`: limit of the suspended text.
EMSCRIPTEN_KEEPALIVE const char* moltact_platform_record(int max_chars, int from) {
  if (!moltact::platform_lesson) return "";
  moltact::PlatformLesson& lesson = *moltact::platform_lesson;
  lesson.attempt.read(page->app.extensions().recorder.file());
  const moltact::Attempt* attempt = lesson.attempt.attempt();
  if (!attempt) return "";
  lesson.json = moltact::learningRecordJson(moltact::learningRecord(*attempt),
                                            moltact::suspendedText(*attempt, std::size_t(std::max(0, max_chars))),
                                            std::size_t(std::max(0, from)));
  return lesson.json.c_str();
}

// 0: the platform does not answer; 1: it answers again; 2: there is none; 3: it could not be joined.
EMSCRIPTEN_KEEPALIVE void moltact_platform_news(int what) {
  using moltact::MessageKind;
  using moltact::tr;
  moltact::Messages& messages = page->app.messages;
  moltact::MessageId none = 0, &lost = moltact::platform_lesson ? moltact::platform_lesson->lost : none;
  messages.takeBack(lost);
  if (what == 0)
    lost = messages.ask(MessageKind::Warning,
                        tr("The learning platform does not answer. Go on with the lesson: what you do is kept in this "
                           "browser and sent as soon as the platform answers."),
                        {});
  if (what == 1) messages.notice(tr("The learning platform answers again and has everything that waited."));
  if (what == 2)
    messages.ask(MessageKind::Warning,
                 tr("This page was made for a learning platform, and there is none here. What you do is kept in this "
                    "browser only."),
                 {});
  if (what == 3)
    messages.ask(MessageKind::Warning,
                 tr("The learning platform did not answer when this page began, so it is told nothing. Close the page "
                    "and begin the lesson again from the platform."),
                 {});
}

// The page belongs to a student of a live class (app/web/classroom.js), whose name is known.
EMSCRIPTEN_KEEPALIVE void moltact_class_begin(const char* name) {
  moltact::learnerKnownFlag() = true;
  page->app.extensions().recorder.passTo(name);
}

// The class waits at this step of a lesson, from 0; -1: it goes on. `lesson`: its file's name without ending and language.
EMSCRIPTEN_KEEPALIVE void moltact_class_hold(const char* lesson, int step) {
  if (step < 0)
    moltact::classHolds().erase(lesson);
  else
    moltact::classHolds()[lesson] = std::size_t(step);
}

// Where the student's scene is on the canvas, for a picture of it that the class may see: JSON of {lesson, step, at: [low x,
// low y, width, height]}, with the lesson as in moltact_class_hold. Without "at" the scene may not be seen now: it is dark,
// the question is what is touched, or another page lies over it. Empty outside a lesson.
EMSCRIPTEN_KEEPALIVE const char* moltact_class_scene() {
  moltact::Application& app = page->app;
  const moltact::LessonSession* session = app.lesson.session();
  if (!session) return "";
  nlohmann::json out{{"lesson", moltact::lessonName(app.lesson.file()).id}, {"step", session->stepIndex()}};
  const moltact::Extensions& all = app.extensions();
  const moltact::OpenPages& pages = app.panels.pages;
  const bool covered = pages.welcome || pages.open || pages.controls || pages.about || pages.preferences ||
                       pages.device || pages.turns || pages.zoom || pages.look || pages.reading || pages.picture ||
                       ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel);
  const bool unseen = all.reveal_policy.all() || all.task_stager.dark() || all.task_stager.asksWhat();
  const moltact::WidgetRecord* view = moltact::widgets().find("view");
  if (!covered && !unseen && app.lesson.onStage() && view && view->visible())
    out["at"] = {view->low.x, view->low.y, view->high.x - view->low.x, view->high.y - view->low.y};
  page->words = out.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  return page->words.c_str();
}

// The page loses the focus or is hidden.
EMSCRIPTEN_KEEPALIVE void moltact_rest() { page->shell.input().focusLost(); }

// The user has left full screen by the browser's own control.
EMSCRIPTEN_KEEPALIVE void moltact_full_screen(int on) { page->app.panels.window.full_screen = on != 0; }
}
