#include "engine/results/attempt_file.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>

#include "engine/language/catalogue.h"
#include "engine/platform/append_file.h"
#include "engine/platform/folders.h"
#include "engine/platform/read_file.h"
#include "engine/results/attempt_lines.h"

namespace moltact {
namespace fs = std::filesystem;
namespace {

constexpr const char* kTooLarge = N_("attempts are far smaller: check what file it is");

// Whether a line can be parsed. A last line without a line end may be complete or cut off.
bool reads(std::string_view line) { return bool(readEventLine(line)) || bool(readHeaderLine(line)); }

// The bytes after the last line end, and their offset. Searched from the end, because most of the file need not be
// read.
struct Tail {
  std::uintmax_t begins = 0;
  std::string bytes;
};
std::optional<Tail> lastLine(const fs::path& file) {
  std::error_code error;
  const std::uintmax_t size = fs::file_size(file, error);
  std::ifstream in(file, std::ios::binary);
  if (error || !in) return std::nullopt;
  Tail tail{size, {}};
  constexpr std::uintmax_t kBlock = 1 << 16;
  while (tail.begins > 0 && tail.bytes.size() <= kLongestLine) {
    const std::uintmax_t step = std::min(kBlock, tail.begins);
    std::string block(step, '\0');
    in.seekg(static_cast<std::streamoff>(tail.begins - step));
    if (!in.read(block.data(), static_cast<std::streamsize>(step))) return std::nullopt;
    const std::size_t end = block.rfind('\n');
    if (end != std::string::npos) {
      tail.begins -= step - end - 1;
      tail.bytes.insert(0, block, end + 1, std::string::npos);
      return tail;
    }
    tail.begins -= step;
    tail.bytes.insert(0, block);
  }
  return tail;
}

// Whether this program created the file, judged by its first line or the existing part of it.
bool beginsAsAttempt(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string start(256, '\0');
  in.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(in.gcount()));
  if (mayBeginAttempt(start)) return true;
  if (!start.starts_with('{')) return false;
  // Another program may have reordered the keys.
  in.clear();
  in.seekg(0);
  std::string line(kLongestLine + 1, '\0');
  in.read(line.data(), static_cast<std::streamsize>(line.size()));
  line.resize(static_cast<std::size_t>(in.gcount()));
  return bool(readHeaderLine(std::string_view(line).substr(0, line.find('\n'))));
}

// Earlier versions counted times within a line (the beginning of a touch, HIP samples) from the resumption, and the
// line's own time from the beginning of the attempt. The offset follows from both: a touch begins at the time of its
// `touch` line, and a `trace` line has the time of its last sample.
class TimesWithin {
 public:
  void mend(AttemptEvent& event) {
    constexpr double kSame_s = 0.01;
    const auto differ = [](double a, double b) { return std::abs(a - b) > kSame_s; };
    if (std::holds_alternative<Resumed>(event.what)) resumed_s_ = event.t_s;
    if (std::holds_alternative<TouchBegan>(event.what)) began_s_ = event.t_s;
    if (auto* touch = std::get_if<TouchEnded>(&event.what);
        touch && resumed_s_ > 0.0 && !differ(touch->from_s + resumed_s_, began_s_))
      touch->from_s = began_s_;
    if (auto* chunk = std::get_if<HipChunk>(&event.what); chunk && !chunk->samples.empty()) {
      const double off_s = event.t_s - chunk->samples.back().t_s;
      if (differ(off_s, 0.0) && !differ(off_s, resumed_s_))
        for (HipSample& s : chunk->samples) s.t_s += off_s;
    }
  }

 private:
  double resumed_s_ = 0.0, began_s_ = -1.0;
};

}  // namespace

bool endsWithLine(const fs::path& file) {
  std::ifstream in(file, std::ios::binary | std::ios::ate);
  const std::streamoff size = in.tellg();
  if (!in || size <= 0) return true;
  in.seekg(size - 1);
  return in.get() == '\n';
}

bool mendAttempt(const fs::path& file) {
  if (!beginsAsAttempt(file)) return false;
  const std::optional<Tail> seen = lastLine(file);
  if (!seen || (seen->bytes.empty() && seen->begins > 0)) return false;
  Expected<AppendFile> out = AppendFile::open(file, AppendFile::Begin::Continue);
  if (!out) return false;
  // Read again now that the file is locked.
  const std::optional<Tail> tail = lastLine(file);
  if (!tail || (tail->bytes.empty() && tail->begins > 0)) return false;
  if (reads(tail->bytes)) return !out->append("\n");
  if (tail->begins > 0) return !out->cut(tail->begins);
  std::error_code error;
  return fs::remove(file, error);
}

fs::path attemptsFolder() {
  const fs::path data = userDataFolder();
  return data.empty() ? fs::path() : data / "attempts";
}

std::size_t sittingsOf(const Attempt& attempt) {
  return 1 + std::size_t(std::count_if(attempt.events.begin(), attempt.events.end(),
                                       [](const AttemptEvent& e) { return std::holds_alternative<Resumed>(e.what); }));
}

double Attempt::end_s() const {
  double end = 0.0;
  for (const AttemptEvent& e : events) end = std::max(end, e.t_s);
  return end;
}

Expected<Attempt> readAttempt(const fs::path& file, ReadDepth depth) {
  Expected<std::string> bytes = readFile(file, kLargestAttempt, tr(kTooLarge));
  if (!bytes) return bytes.problem();
  const std::string_view all = *bytes;
  Attempt out;
  out.file = file;
  bool begun = false;
  std::size_t number = 0;
  TimesWithin within;
  for (std::size_t at = 0; at < all.size();) {
    const std::size_t end = std::min(all.find('\n', at), all.size());
    std::string_view line = all.substr(at, end - at);
    const bool last = end == all.size();
    at = end + 1;
    ++number;
    if (line.ends_with('\r')) line.remove_suffix(1);  // a file that went through another operating system
    if (begun && line.empty()) continue;
    if (!begun) {
      Expected<AttemptHeader> header = readHeaderLine(line);
      if (!header) return Problem{file.string(), 1, 0, header.problem().message, header.problem().remedy};
      out.header = *std::move(header);
      begun = true;
      continue;
    }
    if (depth == ReadDepth::NoHipSamples && leadingKind(line) == "trace") continue;
    Expected<std::optional<AttemptEvent>> event = readEventLine(line);
    if (!event) {
      if (last)
        out.torn = true;
      else
        out.problems.push_back({file.string(), number, 0, event.problem().message, event.problem().remedy});
      continue;
    }
    if (!*event) continue;
    if (const auto* again = std::get_if<LessonReread>(&(*event)->what)) out.header.lesson = again->lesson;
    if (depth == ReadDepth::NoHipSamples &&
        (std::holds_alternative<ViewChanged>((*event)->what) || std::holds_alternative<HipChunk>((*event)->what)))
      continue;
    within.mend(**event);
    out.events.push_back(**std::move(event));
  }
  if (!begun)
    return Problem{file.string(), 0, 0, tr("it is empty"), tr("attempts are the .jsonl files that Moltact writes")};
  return out;
}

std::string attemptBegan(const fs::path& file) {
  auto open = openFile(file, kLargestAttempt, {});
  std::string line;
  if (!open || !std::getline(open->in, line)) return {};
  if (line.ends_with('\r')) line.pop_back();
  return beginTimeOf(line);
}

Expected<std::vector<fs::path>> attemptFiles(const fs::path& named, bool deep) {
  std::error_code error;
  if (!fs::is_directory(named, error)) {
    if (!fs::exists(named, error))
      return Problem{named.string(), 0, 0, tr("there is no such file or folder"), tr("check the name")};
    return std::vector<fs::path>{named};
  }
  std::vector<fs::path> out;
  // Links to folders are not followed, because they may form a cycle.
  fs::recursive_directory_iterator it(named, fs::directory_options::skip_permission_denied, error);
  if (error) return Problem{named.string(), 0, 0, tr("the folder cannot be read"), tr("check its permissions")};
  for (; it != fs::recursive_directory_iterator(); it.increment(error)) {
    if (error) break;
    std::error_code ignored;
    if (!deep || it.depth() >= kDeepestAttempts) it.disable_recursion_pending();
    if (it->path().extension() == ".jsonl" && it->is_regular_file(ignored)) out.push_back(it->path());
  }
  std::sort(out.begin(), out.end());
  return out;
}

std::vector<fs::path> mendAttempts(const fs::path& folder) {
  std::vector<fs::path> mended;
  std::error_code error;
  if (!fs::is_directory(folder, error)) return mended;
  const Expected<std::vector<fs::path>> files = attemptFiles(folder);
  if (!files) return mended;
  for (const fs::path& file : *files)
    if (mendAttempt(file)) mended.push_back(file);
  return mended;
}

}  // namespace moltact
