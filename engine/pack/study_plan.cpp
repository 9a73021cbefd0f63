#include "engine/pack/study_plan.h"

#include <algorithm>
#include <set>
#include <system_error>
#include <utility>

#include "engine/core/text.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/key_lines.h"
#include "engine/lesson/lesson_files.h"
#include "engine/lesson/reader.h"
#include "engine/lesson/suggestion.h"
#include "engine/pack/study_draw.h"
#include "engine/platform/folders.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxGroups = 8;
constexpr std::string_view kArrows[]{"->", "→"};

bool isPlainName(std::string_view name) {
  return !name.empty() && name.size() <= 40 && std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
  });
}

class PlanReader {
 public:
  PlanReader(const fs::path& file, const SourceText& source) : file_(file), source_(source) {}

  StudyPlanReading run() {
    const KeyValues values = front();
    StudyPlan plan;
    plan.file = file_.string();
    plan.title = values["title"].text;
    plan.study = values["study"].text;
    if (values.has("study") && !isPlainName(plan.study))
      error(values["study"].place, trf("'{0}' is no name for a study", plan.study),
            tr("write at most 40 letters, digits and hyphens, as in 'grooves-2026'"));
    plan.pre = test(values["pre"]);
    plan.post = test(values["post"]);
    plan.delayed = test(values["delayed"]);
    if (values.has("ask") && values["ask"].place.line) plan.ask = values["ask"].text;
    const Value& groups = values["groups"];
    if (groups.words.size() > kMaxGroups)
      error(groups.place, trf("a study of more than {0} groups", kMaxGroups), tr("plan several studies"));
    for (std::size_t k = 0; k < std::min(groups.words.size(), kMaxGroups); ++k)
      if (auto group = groupOf(groups.words[k], groups.places[k])) plan.groups.push_back(*std::move(group));
    draw(values, plan);
    StudyPlanReading out;
    std::stable_sort(errors_.begin(), errors_.end(),
                     [](const Problem& a, const Problem& b) { return a.line < b.line; });
    out.errors = std::move(errors_);
    if (out.errors.empty()) out.plan = std::move(plan);
    return out;
  }

 private:
  void error(Place place, std::string message, std::string remedy) {
    errors_.push_back({file_.string(), place.line, place.column, std::move(message), std::move(remedy)});
  }

  KeyValues front() {
    if (stripped(source_.line(1)) != "---") {
      error({1, 1}, tr("the plan has no front matter"),
            tr("begin the file with '---', 'title: …' and the other keys, and '---'"));
      return {};
    }
    std::vector<BlockLine> lines;
    std::size_t end = 2;
    for (; end <= source_.lineCount() && stripped(source_.line(end)) != "---"; ++end)
      lines.push_back({std::string(source_.line(end)), {end, 1}});
    if (end > source_.lineCount()) {
      error({1, 1}, tr("the front matter has no end"), tr("close it with a line '---'"));
      return {};
    }
    std::vector<Problem> problems;
    const KeyValues values = readKeyValues(splitKeyLines(lines, problems), pointersTo(studyPlanKeys()),
                                           NC_("block", "plan"), {1, 1}, problems);
    for (Problem& p : problems) {
      p.file = file_.string();
      errors_.push_back(std::move(p));
    }
    return values;
  }

  std::optional<PlannedLesson> lessonNamed(std::string_view written, Place place) {
    const std::string name(stripped(written));
    if (name.empty()) {
      error(place, tr("a lesson without a name"), tr("write the name of its file, as in 'first-touch'"));
      return std::nullopt;
    }
    const fs::path named =
        lower(fs::path(name).extension().string()) == ".md" ? fs::path(name) : fs::path(name + ".md");
    const fs::path beside = file_.has_parent_path() ? file_.parent_path() : fs::path(".");
    for (const fs::path& folder : {beside, homeFolder() / "assets" / "studies", lessonsFolder()}) {
      std::error_code ignored;
      if (fs::is_regular_file(folder / named, ignored)) return PlannedLesson{folder / named, place};
    }
    std::set<std::string> names;
    for (const fs::path& folder : {homeFolder() / "assets" / "studies", lessonsFolder()}) {
      std::error_code failed;
      for (fs::directory_iterator it(folder, failed), none; !failed && it != none; it.increment(failed))
        if (it->path().extension() == ".md" && looksLikeLesson(it->path())) names.insert(lessonName(it->path()).id);
    }
    const std::vector<std::string_view> known(names.begin(), names.end());
    error(place, trf("there is no lesson '{0}' beside the plan or in the program", name),
          suggest(name, known, tr("lessons")));
    return std::nullopt;
  }

  std::optional<PlannedLesson> test(const Value& value) {
    if (value.text.empty()) return std::nullopt;
    std::optional<PlannedLesson> out = lessonNamed(value.text, value.place);
    if (!out) return out;
    const LessonReading reading = readLesson(out->file);
    if (reading.lesson && !reading.lesson->test)
      error(value.place, trf("'{0}' is no test: its answers get a verdict", value.text),
            tr("write 'test: yes' into the front matter of the lesson"));
    return out;
  }

  // "hands -> touch: first-touch, coils-and-sheets"
  std::optional<PlannedGroup> groupOf(std::string_view line, Place place) {
    const std::string form = tr("write '- NAME -> touch: LESSON', with touch, look or blind");
    std::size_t arrow = std::string_view::npos, bytes = 0;
    for (const std::string_view sign : kArrows)
      if (const std::size_t at = line.find(sign); at < arrow) arrow = at, bytes = sign.size();
    const std::size_t colon = arrow == std::string_view::npos ? arrow : line.find(':', arrow);
    if (colon == std::string_view::npos) {
      error(place, tr("this line names no group with its condition and its lessons"), form);
      return std::nullopt;
    }
    PlannedGroup out;
    out.name = stripped(line.substr(0, arrow));
    if (!isPlainName(out.name))
      error(place, trf("'{0}' is no name for a group", out.name),
            tr("write at most 40 letters, digits and hyphens, as in 'hands'"));
    if (!group_names_.insert(out.name).second)
      error(place, trf("two groups are called '{0}'", out.name), tr("rename one of them"));
    const std::string_view condition = stripped(line.substr(arrow + bytes, colon - arrow - bytes));
    const auto known = conditionNamed(condition);
    if (known)
      out.condition = *known;
    else
      error(place, trf("'{0}' is no condition of a study", condition), form);
    std::string_view rest = line.substr(colon + 1);
    for (;;) {
      const std::size_t comma = rest.find(',');
      if (auto lesson = lessonNamed(rest.substr(0, comma), place)) out.lessons.push_back(*std::move(lesson));
      if (comma == std::string_view::npos) break;
      rest.remove_prefix(comma + 1);
    }
    return out;
  }

  void draw(const KeyValues& values, StudyPlan& plan) {
    plan.draws = values["assign"].text == "draw";
    plan.students = std::size_t(values["students"].number);
    plan.seed = std::uint64_t(values["seed"].number);
    plan.block = std::size_t(values["block"].number);
    for (const char* key : {"students", "seed", "block"}) {
      if (plan.draws || !values[key].place.line) continue;
      error(values[key].place, trf("'{0}' goes with 'assign: draw'", key), tr("take it out, or add 'assign: draw'"));
    }
    if (!plan.draws || plan.groups.empty()) return;
    const Place place = values["assign"].place;
    for (const char* key : {"students", "seed"})
      if (!values[key].place.line)
        error(place, trf("a draw needs '{0}'", key),
              std::string_view(key) == "seed" ? tr("add 'seed: 2026', or any other whole number, and keep it")
                                              : tr("add 'students: 60', the number of codes to be drawn"));
    if (plan.ask != "code")
      error(values["ask"].place, tr("a draw assigns by codes, and the plan asks for names"), tr("write 'ask: code'"));
    if (!values["block"].place.line) plan.block = 2 * plan.groups.size();
    if (plan.block % plan.groups.size() != 0)
      error(values["block"].place,
            trf("a block of {0} students cannot hold {1} groups equally often", plan.block, plan.groups.size()),
            trf("write {0} or another multiple of {1}", 2 * plan.groups.size(), plan.groups.size()));
  }

  const fs::path file_;
  const SourceText& source_;
  std::vector<Problem> errors_;
  std::set<std::string> group_names_;
};

}  // namespace

const std::vector<KeySpec>& studyPlanKeys() {
  static const std::vector<KeySpec> keys{
      {.name = "title", .type = ValueType::Text, .meaning = "The study's title.", .required = true},
      {.name = "study",
       .type = ValueType::Text,
       .meaning = "Its name in the results: letters, digits and hyphens.",
       .required = true},
      {.name = "pre", .type = ValueType::Text, .meaning = "The test before the lessons."},
      {.name = "groups",
       .type = ValueType::TextList,
       .meaning = "The groups, each on a line '- NAME -> CONDITION: LESSON, LESSON'.",
       .required = true},
      {.name = "post", .type = ValueType::Text, .meaning = "The test after the lessons."},
      {.name = "delayed", .type = ValueType::Text, .meaning = "A test weeks later, in a page of its own."},
      {.name = "ask",
       .type = ValueType::Word,
       .meaning = "What each part asks for.",
       .fallback = "code",
       .words = {"code", "name"}},
      {.name = "assign",
       .type = ValueType::Word,
       .meaning = "Whether each group has its page, or one page assigns by the student's code.",
       .fallback = "pages",
       .words = {"pages", "draw"}},
      {.name = "students",
       .type = ValueType::Count,
       .meaning = "Of a draw: the number of codes.",
       .min = 1,
       .max = double(kMaxStudyStudents)},
      {.name = "block",
       .type = ValueType::Count,
       .meaning = "Of a draw: the students in a block, a multiple of the number of groups.",
       .min = 2,
       .max = 100},
      {.name = "seed", .type = ValueType::Count, .meaning = "Of a draw: its seed.", .min = 0, .max = 1e9},
  };
  return keys;
}

StudyPlanReading readStudyPlan(const fs::path& file) {
  StudyPlanReading out;
  Expected<std::string> bytes = readLessonFile(file);
  if (!bytes) {
    out.errors.push_back(bytes.problem());
    return out;
  }
  const SourceText source(file.string(), *std::move(bytes));
  if (const std::size_t bad = firstBadByte(source.bytes()); bad != std::string_view::npos) {
    const Place place = source.at(bad);
    out.errors.push_back({file.string(), place.line, place.column, tr("this is not UTF-8 text"),
                          tr("save the file in the encoding UTF-8")});
    return out;
  }
  return PlanReader(file, source).run();
}

}  // namespace moltact
