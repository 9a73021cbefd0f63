#include "engine/results/progress.h"

#include <algorithm>
#include <fstream>
#include <map>

#include "engine/lesson/lesson_files.h"
#include "engine/results/attempt_lines.h"
#include "engine/results/lesson_language.h"

namespace moltact {
namespace fs = std::filesystem;
namespace {

struct Ends {
  AttemptHeader header;
  ProgressMade last;
  bool known = false;  // progress was found
};

// Searches complete lines backward from the last for the progress.
bool lastProgress(std::string_view bytes, ProgressMade& into) {
  for (std::size_t end = bytes.size(); end > 0;) {
    const std::size_t before = end > 1 ? bytes.rfind('\n', end - 2) : std::string_view::npos;
    const std::size_t begin = before == std::string_view::npos ? 0 : before + 1;
    const std::string_view line = bytes.substr(begin, end - begin);
    end = begin;
    const std::string_view kind = leadingKind(line);
    if (kind != "progress" && !kind.empty()) continue;
    const Expected<std::optional<AttemptEvent>> event = readEventLine(line.substr(0, line.find('\n')));
    if (!event || !*event) continue;
    const auto* made = std::get_if<ProgressMade>(&(*event)->what);
    if (!made) continue;
    into = *made;
    return true;
  }
  return false;
}

std::optional<Ends> readEnds(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string first;
  if (!in || !std::getline(in, first) || first.size() > kLongestLine) return std::nullopt;
  Expected<AttemptHeader> header = readHeaderLine(first);
  if (!header) return std::nullopt;
  Ends ends{*std::move(header), {}, false};
  in.clear();
  in.seekg(0, std::ios::end);
  const std::streamoff size = in.tellg();
  // The recorder writes progress often enough that the first block contains it; otherwise earlier blocks are searched.
  for (std::streamoff look = 32 << 10;; look *= 8) {
    const std::streamoff from = std::max<std::streamoff>(0, size - look);
    std::string bytes(static_cast<std::size_t>(size - from), '\0');
    in.seekg(from);
    if (!in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) return ends;
    ends.known = lastProgress(bytes, ends.last);
    if (ends.known || from == 0) return ends;
  }
}

std::string titleOf(const LessonOutline& lesson, const std::string& step) {
  for (const StepOutline& s : lesson.steps)
    if (s.id == step) return s.title;
  return {};
}

}  // namespace

bool LessonProgress::isOf(const fs::path& lesson_file, const std::string& its_title) const {
  const std::string name_of_file = lesson_file.filename().string();
  bool same_file = false;
  for (const auto& [name, its] : names) {
    if (name != name_of_file) continue;
    if (its == its_title) return true;
    same_file = true;
  }
  return !same_file && lessonName(file).id == lessonName(lesson).id;
}

std::vector<LessonProgress> readProgress(const fs::path& folder, const std::optional<std::string>& student) {
  std::error_code error;
  if (folder.empty() || !fs::is_directory(folder, error)) return {};
  const Expected<std::vector<fs::path>> files = attemptFiles(folder);
  if (!files) return {};
  std::vector<std::pair<LessonOutline, LessonProgress>> by_lesson;  // with the outline of one of its attempts
  for (const fs::path& file : *files) {
    const std::optional<Ends> ends = readEnds(file);
    if (!ends || (student && ends->header.student != *student)) continue;
    const fs::file_time_type touched = fs::last_write_time(file, error);
    if (error) continue;
    const AttemptHeader& h = ends->header;
    auto at = std::find_if(by_lesson.begin(), by_lesson.end(), [&](const auto& one) {
      const std::pair name(h.lesson.file, h.lesson.title);
      const auto& names = one.second.names;
      return std::find(names.begin(), names.end(), name) != names.end() || sameLesson(one.first, h.lesson);
    });
    if (at == by_lesson.end()) at = by_lesson.insert(at, {h.lesson, {}});
    LessonProgress& p = at->second;
    if (const std::pair name(h.lesson.file, h.lesson.title);
        std::find(p.names.begin(), p.names.end(), name) == p.names.end())
      p.names.push_back(name);
    const bool newest = p.attempts == 0 || touched >= p.touched;
    const std::size_t of = ends->known ? ends->last.of : std::max<std::size_t>(1, h.lesson.parts());
    const bool finished = ends->known && of > 0 && ends->last.done >= of;
    ++p.attempts;
    p.finished = p.finished || finished;
    if (!newest) continue;
    p.lesson = h.lesson.file;
    p.title = h.lesson.title;
    p.student = h.student;
    p.file = file;
    p.began = h.began;
    p.touched = touched;
    p.step = ends->last.step;
    p.step_title = titleOf(h.lesson, p.step);
    p.done = ends->last.done;
    p.of = of;
  }
  std::vector<LessonProgress> out;
  for (auto& [outline, progress] : by_lesson) out.push_back(std::move(progress));
  std::sort(out.begin(), out.end(),
            [](const LessonProgress& a, const LessonProgress& b) { return a.touched > b.touched; });
  return out;
}

SessionMemory memoryOf(const Attempt& attempt) {
  struct Done {
    std::map<std::size_t, bool> tasks;  // whether solved
    std::map<std::string, QuestionStatus> questions;
  };
  std::map<std::string, Done> steps;
  std::map<std::string, std::size_t> met;  // the order in which the steps were first entered
  SessionMemory out;
  for (const AttemptEvent& event : attempt.events) {
    if (const auto* e = std::get_if<StepEntered>(&event.what)) {
      // Entering another step leaves the current one; resuming an attempt in the same step does not.
      if (out.step != e->step)
        for (auto& [id, q] : steps[out.step].questions) q.left_since_answer = true;
      out.step = e->step;
      steps[e->step];
      met.try_emplace(e->step, met.size());
    } else if (const auto* begun = std::get_if<TaskBegun>(&event.what)) {
      steps[begun->step].tasks.erase(begun->task);  // begun again, so it is no longer done
    } else if (const auto* done = std::get_if<TaskDone>(&event.what)) {
      steps[done->step].tasks[done->task] = done->solved;
    } else if (const auto* answer = std::get_if<Answered>(&event.what)) {
      QuestionStatus& q = steps[answer->step].questions[answer->question];
      q.left_since_answer = false;
      q.attempts = answer->attempt;
      q.chosen = answer->chosen;
      q.written = answer->written;
      q.last_right = answer->right;
      q.answered_right = q.answered_right || answer->right;
    }
  }
  for (auto& [step, done] : steps) {
    if (step.empty()) continue;
    SessionMemory::StepMemory& s =
        out.steps.emplace_back(SessionMemory::StepMemory{step, {}, {}, {done.questions.begin(), done.questions.end()}});
    for (const auto& [task, solved] : done.tasks) (solved ? s.tasks_done : s.tasks_shown).push_back(task);
  }
  const auto place = [&](const SessionMemory::StepMemory& s) {
    const auto found = met.find(s.step);
    return found == met.end() ? met.size() : found->second;
  };
  std::stable_sort(out.steps.begin(), out.steps.end(),
                   [&](const auto& a, const auto& b) { return place(a) < place(b); });
  return out;
}

}  // namespace moltact
