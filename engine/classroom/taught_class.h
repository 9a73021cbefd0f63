// A live class that the window's program serves on a thread of its own, for a page of the window: what the teacher's page in
// a browser shows, as plain numbers, and the same acts. Window's thread; each call takes the class's lock for a moment.
// docs/live-class.md
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/classroom/class_view.h"
#include "engine/classroom/live_class.h"
#include "engine/classroom/qr_code.h"
#include "engine/core/problem.h"

namespace moltact {

/// Whether this edition can serve a class.
bool canServeClass() noexcept;

/// A folder for a new class among the user's data, named by the time; empty if the computer names no folder for data.
std::filesystem::path newClassFolder();

/// Opens an address of this computer in the user's browser, by xdg-open. False if that is not there.
bool openInBrowser(const std::string& address);

class TaughtClass {
 public:
  enum class State { Beginning, Served, Over };

  /// What stays the same while the class is served.
  struct Facts {
    std::string address, teacher;     ///< of the students; of the teacher's page in a browser
    std::vector<std::string> others;  ///< further addresses of the students
    QrCode qr;                        ///< of `address`; empty if only this computer reaches it
    bool shared = false, alone = false;
  };

  /// Begins to serve. The thread is that of inBackground().
  explicit TaughtClass(LiveClassOptions options);
  /// Stops and waits until attempts and report are written.
  ~TaughtClass();
  TaughtClass(const TaughtClass&) = delete;
  TaughtClass& operator=(const TaughtClass&) = delete;

  State state() const;
  /// While it is served and after.
  Facts facts() const;
  /// Why it is over, if it could not be served.
  std::optional<Problem> problem() const;
  /// The last report; empty if there is none.
  std::filesystem::path report() const;
  /// Only while it is served.
  std::optional<ClassView> view() const;

  void hold(const std::string& lesson, std::size_t step);
  void open(const std::string& lesson);
  void askForScene(std::size_t student);
  void endScene();
  /// Nobody can join any more; late work arrives until stop().
  void end();
  /// The attempts and the report of what has come so far. Blocks for a moment; a Problem if they cannot be written.
  Expected<std::filesystem::path> writeReport();
  /// Stops serving; does not wait.
  void stop();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace moltact
