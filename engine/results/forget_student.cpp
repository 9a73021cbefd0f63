#include "engine/results/forget_student.h"

#include <algorithm>
#include <set>
#include <string_view>
#include <system_error>
#include <variant>

#include "engine/core/markup.h"
#include "engine/core/text.h"
#include "engine/language/catalogue.h"
#include "engine/platform/append_file.h"
#include "engine/platform/read_file.h"
#include "engine/platform/write_file.h"
#include "engine/results/anonymous_text.h"
#include "engine/results/attempt_file.h"
#include "engine/results/attempt_lines.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kLargestText = std::size_t{1} << 28;  // of a report or another text (unit: byte)

std::string endingOf(const fs::path& file) { return lower(file.extension().string()); }

// Every file of these endings, down to kDeepestAttempts levels.
std::vector<fs::path> filesIn(const fs::path& named, std::vector<Problem>& passed_over) {
  constexpr std::string_view kEndings[] = {".jsonl", ".recording", ".html", ".csv", ".json", ".txt", ".md"};
  std::error_code error;
  if (!fs::is_directory(named, error)) {
    if (fs::exists(named, error)) return {named};
    passed_over.push_back({named.string(), 0, 0, tr("there is no such file or folder"), tr("check the name")});
    return {};
  }
  std::vector<fs::path> out;
  fs::recursive_directory_iterator it(named, fs::directory_options::skip_permission_denied, error);
  for (const fs::recursive_directory_iterator end; !error && it != end; it.increment(error)) {
    std::error_code of_file;
    if (it.depth() >= kDeepestAttempts) it.disable_recursion_pending();
    if (it->is_regular_file(of_file) &&
        std::find(std::begin(kEndings), std::end(kEndings), endingOf(it->path())) != std::end(kEndings))
      out.push_back(it->path());
  }
  if (error)
    passed_over.push_back({named.string(), 0, 0, tr("the folder cannot be read"), tr("check its permissions")});
  std::sort(out.begin(), out.end());
  return out;
}

bool isPredictionOf(const std::string& student, std::string_view line) {
  if (leadingKind(line) != "prediction" && line.find("\"prediction\"") == std::string_view::npos) return false;
  const Expected<std::optional<AttemptEvent>> event = readEventLine(line);
  if (!event || !*event) return false;
  const auto* made = std::get_if<Predicted>(&(*event)->what);
  return made && made->student == student;
}

std::size_t predictionsOf(const std::string& student, const Attempt& attempt) {
  return std::size_t(std::count_if(attempt.events.begin(), attempt.events.end(), [&](const AttemptEvent& e) {
    const auto* made = std::get_if<Predicted>(&e.what);
    return made && made->student == student;
  }));
}

// A page or table that `moltact report` writes (class_page.cpp, class_csv.cpp), in English or the language in use.
bool isReport(const fs::path& file, std::string_view text) {
  if (endingOf(file) == ".html") return text.find("<meta name=\"generator\" content=\"Moltact\">") < 1000;
  constexpr std::string_view kMark = "\xEF\xBB\xBF";
  if (endingOf(file) != ".csv" || !text.starts_with(kMark)) return false;
  const std::string_view head = text.substr(kMark.size(), text.find("\r\n") - kMark.size());
  const std::string here = trc("column", "student") + std::string(",");
  return head.starts_with("student,") || head.starts_with(here);
}

// The text between the tags of a page, without its style: a word of CSS is nobody's name.
std::string textOfPage(std::string_view page) {
  std::string out;
  for (std::size_t at = 0; at < page.size();) {
    if (page[at] != '<') {
      out += page[at++];
      continue;
    }
    const bool style = page.substr(at).starts_with("<style");
    const std::size_t end = page.find(style ? "</style>" : ">", at);
    if (end == std::string_view::npos) break;
    at = end + (style ? std::string_view("</style>").size() : 1);
    out += ' ';
  }
  return out;
}

std::string folded(std::string_view name) {
  std::string out;
  for (const char c : lower(std::string(name)))
    if (c != ' ' && c != '\t') out += c;
  return out;
}

class Search {
 public:
  explicit Search(const std::string& student) { out_.student = student; }

  void look(const fs::path& file) {
    std::error_code error;
    const fs::path whole = fs::weakly_canonical(file, error);
    if (!met_.insert(error ? file : whole).second) return;
    if (endingOf(file) == ".recording") {
      if (mentions(file.stem().string(), out_.student)) out_.recordings.push_back(file);
      return;
    }
    if (endingOf(file) == ".jsonl" && !attemptBegan(file).empty()) return attempt(file);
    text(file);
  }

  StudentTraces finish() {
    std::sort(out_.alike.begin(), out_.alike.end());
    out_.alike.erase(std::unique(out_.alike.begin(), out_.alike.end()), out_.alike.end());
    return std::move(out_);
  }

 private:
  void attempt(const fs::path& file) {
    const Expected<Attempt> read = readAttempt(file, ReadDepth::NoHipSamples);
    if (!read) return out_.passed_over.push_back(read.problem());
    const std::string& student = read->header.student;
    if (student == out_.student) return out_.attempts.push_back(file);
    out_.nameless += student.empty();
    if (folded(student) == folded(out_.student)) out_.alike.push_back(student);
    if (const std::size_t lines = predictionsOf(out_.student, *read)) out_.predictions.push_back({file, lines});
    // Another student may have written the name.
    for (const AttemptEvent& e : read->events)
      if (const auto* answer = std::get_if<Answered>(&e.what); answer && mentions(answer->written, out_.student))
        return out_.others.push_back(file);
  }

  void text(const fs::path& file) {
    const Expected<std::string> read = readFile(file, kLargestText, tr("search this file yourself"));
    if (!read) return out_.passed_over.push_back(read.problem());
    const bool page = endingOf(file) == ".html";
    if (!(page ? mentions(textOfPage(*read), escaped(out_.student)) : mentions(*read, out_.student))) return;
    (isReport(file, *read) ? out_.reports : out_.others).push_back(file);
  }

  StudentTraces out_;
  std::set<fs::path> met_;
};

std::optional<Problem> deleteFile(const fs::path& file) {
  std::error_code error;
  if (!fs::remove(file, error) || error)
    return Problem{file.string(), 0, 0, trf("it cannot be deleted: {0}", error.message()),
                   tr("check its permissions and those of its folder")};
  return std::nullopt;
}

// An attempt that a running program writes would come back.
std::optional<Problem> removeAttempt(const fs::path& file) {
  const Expected<AppendFile> own = AppendFile::open(file, AppendFile::Begin::Continue);
  if (!own) return own.problem();
  return deleteFile(file);
}

std::optional<Problem> removePredictions(const std::string& student, const fs::path& file) {
  std::string kept;
  {
    const Expected<AppendFile> own = AppendFile::open(file, AppendFile::Begin::Continue);
    if (!own) return own.problem();
    const Expected<std::string> read = readFile(file, kLargestAttempt, {});
    if (!read) return read.problem();
    std::string_view rest = *read;
    while (!rest.empty()) {
      const std::size_t end = rest.find('\n');
      const std::string_view line = rest.substr(0, end);
      const std::size_t bytes = end == std::string_view::npos ? rest.size() : end + 1;
      if (!isPredictionOf(student, line)) kept += rest.substr(0, bytes);
      rest.remove_prefix(bytes);
    }
  }
  return writeWhole(file, kept, IfThere::Renew);
}

}  // namespace

StudentTraces tracesOf(const std::string& student, std::span<const fs::path> files_and_folders) {
  Search search(student);
  std::vector<Problem> passed_over;
  for (const fs::path& named : files_and_folders)
    for (const fs::path& file : filesIn(named, passed_over)) search.look(file);
  StudentTraces out = search.finish();
  out.passed_over.insert(out.passed_over.begin(), passed_over.begin(), passed_over.end());
  return out;
}

std::vector<Problem> forgetStudent(const StudentTraces& traces) {
  std::vector<Problem> out;
  const auto note = [&](std::optional<Problem> problem) {
    if (problem) out.push_back(*std::move(problem));
  };
  for (const fs::path& file : traces.attempts) note(removeAttempt(file));
  for (const auto& [file, lines] : traces.predictions) note(removePredictions(traces.student, file));
  for (const fs::path& file : traces.recordings) note(deleteFile(file));
  for (const fs::path& file : traces.reports) note(deleteFile(file));
  return out;
}

}  // namespace moltact
