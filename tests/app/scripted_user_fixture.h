// Helpers for this folder's tests: the application on EGL without a display, controlled as by a user.
#pragma once

#include <doctest/doctest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "app/ui/shell/scripted_user.h"

namespace moltact {

/// A scripted user with ubiquitin, or another file, loaded. Fails the test if off-screen OpenGL is missing.
inline std::unique_ptr<ScriptedUser> startWith(const std::string& what = "1ubq", ScriptedUser::Options options = {}) {
  Expected<std::unique_ptr<ScriptedUser>> made = ScriptedUser::create(std::move(options));
  if (!made) FAIL(made.problem().text());
  std::unique_ptr<ScriptedUser> driver = std::move(*made);
  driver->app().settings.reduced_motion = true;  // a gliding camera would move the place under the hand
  if (!what.empty()) driver->app().open(what);
  driver->app().finishLoading();
  driver->frames(20);
  return driver;
}

/// A screen of 1024x768 at 200 %: the smallest supported room.
inline ScriptedUser::Options smallScreen() {
  ScriptedUser::Options options;
  options.width = 1024;
  options.height = 768;
  options.content_scale = 2.0;
  return options;
}

/// A lesson of one step with argon, followed by `body`; `goals` are its list items, one per line.
inline std::string argonLesson(const std::string& title, const std::string& goals, const std::string& body) {
  return "---\ntitle: " + title + "\nminutes: 1\ngoals:\n" + goals +
         "molecules:\n  - argon\nauthor: The Moltact authors\nlicence: CC-BY-4.0\n---\n\n"
         "## One step\n\n```scene\nmolecule: argon\n```\n\n" +
         body;
}

/// Opens the program's lesson for newcomers.
inline void openFirst(ScriptedUser& driver) {
  driver.app().open(std::string(MOLTACT_SOURCE_DIR) + "/lessons/first-touch.md");
}

/// A temporary folder, deleted at the end.
struct Scratch {
  std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("moltact-app-test-" + std::to_string(::getpid()));
  Scratch() { std::filesystem::create_directories(folder); }
  ~Scratch() { std::filesystem::remove_all(folder); }
  std::filesystem::path file(const std::string& name, const std::string& text) const {
    std::ofstream(folder / name) << text;
    return folder / name;
  }
};

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Scrolls the lesson's text by keys until the whole widget is in view, and waits for 0.6 s.
inline void lookAt(ScriptedUser& driver, const std::string& widget) {
  for (int k = 0; k < 40; ++k) {
    const WidgetRecord* r = widgets().find(widget);
    if (!r || (r->low.y >= r->clip_low.y - 1.0f && r->high.y <= r->clip_high.y + 1.0f)) break;
    driver.tap(r->low.y < r->clip_low.y ? "Ctrl+PageUp" : "Ctrl+PageDown");
    driver.frames(2);
  }
  driver.frames(36);
}

/// The same for a question and each of its choices.
inline void readQuestion(ScriptedUser& driver, std::size_t question) {
  const std::string name = "question/" + std::to_string(question);
  lookAt(driver, name);
  for (std::size_t k = 0; widgets().find(name + "/" + std::to_string(k)); ++k)
    lookAt(driver, name + "/" + std::to_string(k));
}

/// The share of pixels that differ between two pictures of the same size.
inline double difference(const Picture& a, const Picture& b) {
  std::size_t differ = 0;
  const std::size_t pixels = a.rgb.size() / 3;
  for (std::size_t k = 0; k < pixels; ++k)
    differ +=
        a.rgb[3 * k] != b.rgb[3 * k] || a.rgb[3 * k + 1] != b.rgb[3 * k + 1] || a.rgb[3 * k + 2] != b.rgb[3 * k + 2];
  return double(differ) / double(pixels);
}

}  // namespace moltact
