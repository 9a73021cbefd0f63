#include "engine/results/learning_link.h"

#include <algorithm>
#include <fstream>
#include <system_error>
#include <utility>

#include "engine/language/catalogue.h"
#include "engine/platform/write_file.h"
#include "engine/results/attempt_lines.h"
#include "engine/results/lesson_language.h"
#include "engine/results/suspended.h"

namespace moltact {
namespace fs = std::filesystem;
namespace {

constexpr double kSameTime_s = 0.01;

// "first-touch-restored-2026-11-21T10-58-14Z-2.jsonl": the first name that is free.
fs::path freeName(const fs::path& folder, const AttemptHeader& header) {
  std::string name = fs::path(header.lesson.file).stem().string() + "-restored-";
  for (const char c : header.began)
    if ((c >= '0' && c <= '9') || c == 'T' || c == 'Z') name += c;
  for (int number = 1;; ++number) {
    fs::path file = folder / (name + (number > 1 ? "-" + std::to_string(number) : std::string()) + ".jsonl");
    std::error_code error;
    if (!fs::exists(file, error)) return file;
  }
}

// Lines that hold no result: the path of the hand and the view.
bool skippable(std::string_view line) {
  const std::string_view kind = leadingKind(line);
  return kind == "trace" || kind == "view" || kind == "moved" || kind == "stage";
}

}  // namespace

Expected<fs::path> attemptToResume(const fs::path& folder, std::string_view suspended, const LessonOutline& lesson) {
  const Expected<Attempt> wanted = fromSuspended(suspended, lesson);
  if (!wanted) return wanted.problem();
  const double wanted_s = wanted->end_s();
  std::error_code error;
  if (fs::is_directory(folder, error)) {
    const Expected<std::vector<fs::path>> files = attemptFiles(folder);
    fs::path best;
    double best_s = wanted_s - kSameTime_s;
    for (const fs::path& file : files ? *files : std::vector<fs::path>()) {
      if (attemptBegan(file) != wanted->header.began) continue;
      const Expected<Attempt> kept = readAttempt(file, ReadDepth::NoHipSamples);
      if (!kept || !sameLesson(kept->header.lesson, lesson) || kept->end_s() < best_s) continue;
      best = file;
      best_s = kept->end_s();
    }
    if (!best.empty()) return best;
  }
  std::string bytes = lineOf(wanted->header);
  for (const AttemptEvent& event : wanted->events) bytes += lineOf(event);
  fs::create_directories(folder, error);
  fs::path file = freeName(folder, wanted->header);
  if (auto problem = writeWhole(file, bytes)) return *problem;
  return file;
}

bool GrowingAttempt::read(const fs::path& file) {
  if (file.empty()) return false;
  std::ifstream in(file, std::ios::binary);
  if (!in) return false;
  if (file != file_) {
    std::string first;
    if (!std::getline(in, first) || in.eof() || first.size() > kLongestLine) return false;
    Expected<AttemptHeader> header = readHeaderLine(first);
    if (!header || !sameLesson(header->lesson, lesson_)) return false;
    file_ = file;
    raw_ = Attempt{file, *std::move(header), {}, {}, false};
    read_bytes_ = first.size() + 1;
    attempt_.reset();
  }
  in.seekg(0, std::ios::end);
  const std::streamoff size = in.tellg();
  const bool first_look = !attempt_;
  if (size <= std::streamoff(read_bytes_) && !first_look) return false;
  std::string bytes(std::size_t(std::max<std::streamoff>(0, size - std::streamoff(read_bytes_))), '\0');
  in.seekg(std::streamoff(read_bytes_));
  if (!bytes.empty() && !in.read(bytes.data(), std::streamsize(bytes.size()))) return false;
  std::size_t begin = 0, lines = 0;
  for (std::size_t end = bytes.find('\n'); end != std::string::npos; end = bytes.find('\n', begin)) {
    const std::string_view line = std::string_view(bytes).substr(begin, end - begin);
    begin = end + 1;
    ++lines;
    if (line.size() > kLongestLine || skippable(line)) continue;
    Expected<std::optional<AttemptEvent>> event = readEventLine(line);
    if (event && *event) raw_->events.push_back(**std::move(event));
  }
  read_bytes_ += begin;
  if (lines == 0 && !first_look) return false;
  attempt_ = inTermsOf(lesson_, *raw_);
  attempt_->header.lesson = lesson_;
  return true;
}

}  // namespace moltact
