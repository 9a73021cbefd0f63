// A live class from beginning to end: reads the lessons and the page, goes on with a class that was stopped, serves it, and
// leaves attempts and a report behind. Blocks; any thread but the haptic one. docs/live-class.md
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/problem.h"

namespace moltact {

class ClassRequests;

struct LiveClassOptions {
  std::vector<std::string>
      lessons;  ///< files (.md, .moltact) or names of the program's lessons; empty: those of the class that goes on,
                ///< else all of the program
  std::filesystem::path page;    ///< the browser edition
  std::filesystem::path folder;  ///< of the class; if a class was begun there, it goes on
  bool share = false;            ///< other computers may connect; a class that goes on keeps it
  int port = -1;                 ///< -1: the class's own, else kUsualPort or any free one; 0: any free one
  static constexpr int kUsualPort = 8230;
};

/// What the teacher is told.
struct LiveClassNews {
  enum class Kind {
    Note,     ///< `text`
    Started,  ///< all below
    Stopped,  ///< `ended`, `report`
  };
  Kind kind = Kind::Note;
  std::string text;
  std::string address, teacher;        ///< of the students; of the teacher
  std::string qr;                      ///< the address as a QR code for a terminal
  std::vector<std::string> others;     ///< further addresses of the students: of this computer's other networks
  bool shared = false, alone = false;  ///< whether other computers may connect; whether it is in no network
  bool resumed = false, ended = false;
  std::size_t students = 0;
  /// For who shows and steers the class besides its pages, with the beginning of its clock. It may be kept.
  std::shared_ptr<ClassRequests> requests;
  std::chrono::steady_clock::time_point clock_began;
  std::filesystem::path report;  ///< empty if nobody has begun a lesson
};

/// Whether somebody joined the class of this folder and nobody has ended it. Reads its journal.
bool classIsOpen(const std::filesystem::path& folder);

/// Serves the class until `stop` returns true. A Problem if it cannot begin, or not write what it was given.
std::optional<Problem> runLiveClass(const LiveClassOptions& options,
                                    const std::function<void(const LiveClassNews&)>& news,
                                    const std::function<bool()>& stop);

}  // namespace moltact
