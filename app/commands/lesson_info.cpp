#include "app/commands/lesson_info.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <vector>

#include "app/commands/command.h"
#include "app/commands/lesson_argument.h"
#include "app/commands/print_json.h"
#include "engine/core/text.h"
#include "engine/lesson/lesson_files.h"
#include "engine/lesson/minutes.h"
#include "engine/lesson/reader.h"
#include "engine/platform/terminal.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

std::string joined(const std::vector<std::string>& words) {
  std::string out;
  for (const std::string& w : words) out += (out.empty() ? "" : ", ") + w;
  return out.empty() ? "none" : out;
}

// The languages of the files beside it that hold the same lesson. "" stands for a file without a language in its name.
std::vector<std::string> languagesOf(const fs::path& file) {
  std::set<std::string> out;
  std::error_code error;
  const fs::path folder = file.has_parent_path() ? file.parent_path() : fs::path(".");
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    if (it->path().extension() == ".md" && lessonName(it->path()).id == lessonName(file).id) {
      const LessonReading other = readLesson(it->path());
      if (!other.lesson) continue;
      const std::string named = lessonName(it->path()).language;
      out.insert(!named.empty() ? named : !other.lesson->language.empty() ? other.lesson->language : "not named");
    }
  return {out.begin(), out.end()};
}

}  // namespace

bool namesLesson(const std::string& name) {
  return hasPackName(name) || lower(fs::path(name).extension().string()) == ".md";
}

void printLessonInfo(const std::string& name, bool json) {
  const Expected<LessonArgument> argument = LessonArgument::open(name);
  if (!argument) throw CommandError{argument.problem().text()};
  const LessonReading reading = readLesson(argument->file());
  if (!reading.lesson) throw CommandError{argument->shown(reading.errors.front()).text()};
  const Lesson& lesson = *reading.lesson;
  std::size_t tasks = 0, questions = 0;
  for (const Step& s : lesson.steps) tasks += s.tasks.size(), questions += s.questions.size();
  const ShownMinutes minutes = shownMinutes(lesson);
  const std::vector<std::string> languages = languagesOf(argument->file());
  if (json) {
    nlohmann::ordered_json document = {
        {"title", lesson.title},  {"author", lesson.author},       {"licence", lesson.licence},
        {"level", lesson.level},  {"minutes", minutes.core},       {"minutes_all", minutes.all},
        {"languages", languages}, {"steps", lesson.steps.size()},  {"tasks", tasks},
        {"questions", questions}, {"molecules", lesson.molecules}, {"asks_for", lesson.ask}};
    if (const TemporaryPack* pack = argument->pack()) {
      document["lesson"] = pack->pack().lesson();
      document["files"] = nlohmann::ordered_json::array();
      for (const PackEntry& e : pack->pack().entries())
        document["files"].push_back({{"name", e.name}, {"bytes", e.bytes}});
    }
    return printDocument(document);
  }
  out() << lesson.title << '\n';
  out() << "author     " << lesson.author << '\n';
  out() << "licence    " << lesson.licence << '\n';
  out() << "level      " << lesson.level << '\n';
  out() << "minutes    " << minutes.core << " for the core, " << minutes.all << " with all steps\n";
  out() << "languages  " << joined(languages) << '\n';
  out() << "steps      " << lesson.steps.size() << " (" << tasks << " tasks, " << questions << " questions)\n";
  out() << "molecules  " << joined(lesson.molecules) << '\n';
  if (!lesson.ask.empty()) out() << "asks for   a " << lesson.ask << '\n';
  if (const TemporaryPack* pack = argument->pack())
    for (const PackEntry& e : pack->pack().entries()) out() << "file       " << e.name << ", " << e.bytes << " bytes\n";
}

}  // namespace moltact
