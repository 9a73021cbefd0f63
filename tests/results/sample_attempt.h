// Helpers of this folder's tests: an attempt with every kind of event, and temporary folders.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "engine/results/attempt.h"
#include "engine/results/attempt_lines.h"

namespace moltact {

class ScratchFolder {
 public:
  ScratchFolder() {
    static int count = 0;
    // In memory where the system has such a folder, because thousands of small files are created here.
    std::error_code error;
    const std::filesystem::path memory = "/dev/shm";
    path = (std::filesystem::is_directory(memory, error) ? memory : std::filesystem::temp_directory_path()) /
           ("moltact-results-" + std::to_string(::getpid()) + "-" + std::to_string(++count));
    std::filesystem::create_directories(path);
  }
  ~ScratchFolder() {
    std::error_code error;
    std::filesystem::remove_all(path, error);
  }
  std::filesystem::path path;
};

inline void writeFile(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
}

inline std::string bytesOf(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline AttemptHeader sampleHeader() {
  AttemptHeader h;
  h.program = "0.1.0";
  h.began = "2026-11-21T10:58:14Z";
  h.student = "A. \"Quote\", Ünlü\n=1+1";
  h.device = "Mouse";
  h.lesson = {"first-touch.md",
              "First touch",
              "0123456789abcdef",
              {{"one", "One", {{"reach", "Touch it."}}, {{"which", "Which?", {"this", "that", "both"}, {1}}}},
               {"two", "Two", {}, {{"how-much", "How much?", {}, {}}}}}};
  h.lesson.goals = {"Feel it", "Say it"};
  h.lesson.steps[0].tasks[0].goals = {0, 1};
  h.lesson.steps[0].questions[0].goals = {1};
  h.lesson.steps[0].questions[0].tags = {"takes this for that", "", ""};
  return h;
}

inline std::vector<AttemptEvent> sampleEvents() {
  HipChunk chunk;
  for (int k = 0; k < 6; ++k) {
    HipSample s;
    s.t_s = 3.0 + 0.017 * k;
    s.hip.A = {1.25 * k, -3.5, 0.001 * k};
    s.scp = s.hip;
    if (k >= 2) {
      s.feature = k < 4 ? Feature::Sphere : k == 4 ? Feature::Circle : Feature::Point;
      s.scp.A.z += 0.5;
      s.displacement_A = {0.0, 0.3, 0.4};
      s.force.N = {0.1, 0.0, 0.25 * k};
      s.atoms = {7, k >= 4 ? 9 : -1, k == 5 ? 12 : -1};
    }
    chunk.samples.push_back(s);
  }
  StageChanged stage{"1UBQ", "1ubq.pdb", 602};
  stage.workspace.A_per_mm = 0.25;
  stage.workspace.centre_A = {30.5, 29.25, 14.125};
  return {
      {0.0, InputChanged{InputKind::Mouse, "Mouse", false}},
      {0.0, stage},
      {0.0, StepEntered{"one"}},
      {0.0, TaskBegun{"one", 0}},
      {0.5, ViewChanged{{1, 0, 0, 0}, {30.5, 29.25, 14.125}, 60.5}},
      {2.0, HintOpened{"one"}},
      {3.0, TouchBegan{{7}}},
      {3.085, chunk},
      {3.09, TouchSoFar{3.0, 1, 1.0, 0.5, 3.125, InputKind::Keyboard}},
      {3.1, TouchEnded{3.0, {7, 9, 12}, 2, 1.25, 0.75, 6.25, InputKind::Keyboard}},
      {3.1, CurveKept{"one", 0, false, "depth", 0.8, 3.3, {0.0, 1.5, 3.0}}},
      {3.2, CurveKept{"one", 0, true, "depth", 0.8, 3.3, {0.0, 1.25, 2.5}}},
      {3.2, TaskDone{"one", 0, 3.2, InputKind::Device, {{"peak force", 1.25, "N"}}}},
      {4.0, Answered{"one", "which", 1, {0}, "", false, InputKind::Mouse}},
      {5.0, Answered{"one", "which", 2, {1}, "", true, InputKind::Mouse}},
      {5.0, ProgressMade{"one", 2, 3}},
      {6.0, LessonReread{sampleHeader().lesson}},
      {6.5, OrderChanged{"one", "which", "after 2 wrong", false, {"aside-why"}}},
      {7.0, Predicted{"Bo", "one", "What will you feel?", "a bump"}},
      {8.0, StepEntered{"two"}},
      {8.5, AtomsMoved{"states", "1ake.pdb", "chain A", 0.375}},
      {9.0, Answered{"two", "how-much", 1, {}, "2.5 Å", true, InputKind::Keyboard}},
      {9.0, ProgressMade{"two", 3, 3}},
      {9.5, SessionClosed{"2026-11-21T10:59:00Z"}},
      {9.5, Resumed{"2026-11-21T11:05:00Z", "0.1.0", "Omni", true}},
      {9.5, Heartbeat{}},
  };
}

inline std::string sampleFile() {
  std::string out = lineOf(sampleHeader());
  for (const AttemptEvent& e : sampleEvents()) out += lineOf(e);
  return out;
}

}  // namespace moltact
