// A plan, the draw and the packs made of them, read back as a student's program reads them.
#include <doctest/doctest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>

#include "engine/lesson/lesson_files.h"
#include "engine/lesson/reader.h"
#include "engine/pack/pack_file.h"
#include "engine/pack/study_draw.h"
#include "engine/pack/study_pages.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

struct Folder {
  fs::path path = fs::temp_directory_path() / ("moltact-study-" + std::to_string(::getpid()));
  Folder() { fs::create_directories(path); }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path, ignored);
  }
  fs::path write(const std::string& name, const std::string& text) const {
    std::ofstream(path / name, std::ios::binary) << text;
    return path / name;
  }
};

const std::string kHead = "title: T\ngoals: G\nmolecules: argon\nauthor: A\nlicence: CC-BY-4.0\n";
const std::string kLesson =
    "---\n" + kHead +
    "order: 7\n---\n## One\n```scene\nmolecule: argon\nlabel: \"A\" for all\npanels: touch\n```\n"
    "```touch\nreach: all\nsay: Touch it.\n```\n### Question: Q?\n- [x] yes → Right.\n- [ ] no → No.\n"
    "## Told\n```step\ncondition: look\n```\nThe others feel it.\n"
    "## Felt\n```step\ncondition: touch, blind\n```\nYou feel it. [Back](lesson.md).\n";
const std::string kTest =
    "---\n" + kHead +
    "test: yes\n---\n## One\n```scene\nmolecule: argon\n```\n### Question: Q?\n- [x] yes\n- [ ] no → → tag\n";
const std::string kPlan =
    "---\ntitle: Touch or look\nstudy: plan-1\npre: quiz\npost: quiz\ndelayed: quiz\ngroups:\n"
    "- hands -> touch: lesson\n- eyes → look: lesson\n- dark -> blind: lesson\n---\nProse.\n";

std::map<std::string, std::string> filesOf(const StudyPack& pack) {
  const Expected<PackFile> opened = PackFile::ofBytes(pack.name, pack.bytes);
  REQUIRE(opened);
  std::map<std::string, std::string> out;
  for (const PackEntry& entry : opened->entries()) out[entry.name] = *opened->read(entry);
  return out;
}

Lesson lessonIn(const std::map<std::string, std::string>& files, const std::string& name) {
  REQUIRE(files.contains(name));
  LessonReading reading = readLessonText(name, files.at(name));
  REQUIRE(reading.lesson);
  return *std::move(reading.lesson);
}

}  // namespace

TEST_CASE(
    "a plan makes a pack for each group with the tests around the lesson, and the group's condition applied to it") {
  const Folder folder;
  folder.write("lesson.md", kLesson);
  folder.write("quiz.md", kTest);
  const StudyPlanReading reading = readStudyPlan(folder.write("plan.md", kPlan));
  for (const Problem& p : reading.errors) FAIL(p.text());
  const StudyPacks study = packStudy(*reading.plan);
  for (const Problem& p : study.errors) FAIL(p.text());
  REQUIRE(study.packs.size() == 4);
  CHECK(study.packs[3].name == "plan-1-delayed");
  const std::vector<std::string> groups{"hands", "eyes", "dark"};
  for (std::size_t k = 0; k < 3; ++k) {
    CHECK(study.packs[k].name == "plan-1-" + groups[k]);
    const auto files = filesOf(study.packs[k]);
    CHECK(files.size() == 3);
    const Lesson pre = lessonIn(files, "1-pre-quiz.md"), lesson = lessonIn(files, "2-lesson-lesson.md"),
                 post = lessonIn(files, "3-post-quiz.md");
    CHECK(pre.study == StudyPart{"plan-1", "pre", groups[k]});
    CHECK(lesson.study == StudyPart{"plan-1", "lesson", groups[k]});
    CHECK(post.study == StudyPart{"plan-1", "post", groups[k]});
    CHECK(std::vector{pre.order, lesson.order, post.order} == std::vector{1, 2, 3});
    CHECK(lesson.ask == "code");
    CHECK(pre.condition == Condition::Touch);
    CHECK(lesson.condition == reading.plan->groups[k].condition);
    // The link to its own file follows the new name.
    CHECK(files.at("2-lesson-lesson.md").find("](2-lesson-lesson.md)") != std::string::npos);
    CHECK(lesson.steps.size() == 2);
    CHECK(lesson.steps[1].title == (k == 1 ? "Told" : "Felt"));
  }
  const Lesson delayed = lessonIn(filesOf(study.packs[3]), "1-delayed-quiz.md");
  CHECK(delayed.study == StudyPart{"plan-1", "delayed", ""});
}

TEST_CASE("'look' leaves nothing to touch and no task, 'blind' leaves every task and nothing to see") {
  const auto withCondition = [](const std::string& condition) {
    LessonReading reading = readLessonText("a.md", "---\ncondition: " + condition + "\n" + kLesson.substr(4));
    REQUIRE(reading.lesson);
    return *std::move(reading.lesson);
  };
  const Lesson touch = withCondition("touch"), look = withCondition("look"), blind = withCondition("blind");
  const Step &t = touch.steps[0], &l = look.steps[0], &b = blind.steps[0];
  CHECK(t.tasks.size() == 1);
  CHECK(l.tasks.empty());
  CHECK(std::none_of(l.blocks.begin(), l.blocks.end(),
                     [](const Block& block) { return std::holds_alternative<TaskHere>(block); }));
  CHECK(l.questions.size() == 1);
  CHECK(l.scene.untouchable.text() == "all");
  CHECK_FALSE(l.scene.touch.force_on);
  CHECK(l.scene.labels == t.scene.labels);
  CHECK(l.scene.panels == std::vector<std::string>{"none"});
  for (const char* key : {"force", "panels", "show"}) CHECK(l.scene.locks(key));
  CHECK(b.tasks.size() == 1);
  CHECK(b.scene.hide.text() == "all");
  CHECK(b.scene.labels.empty());
  CHECK(b.scene.show == std::vector<std::string>{"force"});
  CHECK(b.scene.locks("show"));
  CHECK(b.scene.touch == t.scene.touch);
  CHECK_FALSE(b.scene.untouchable.given());
}

TEST_CASE("each fault of a plan is reported with its line and a remedy") {
  const Folder folder;
  folder.write("lesson.md", kLesson);
  folder.write("quiz.md", kTest);
  const auto faults = [&](const std::string& from, const std::string& to) {
    std::string text = kPlan;
    text.replace(text.find(from), from.size(), to);
    const StudyPlanReading reading = readStudyPlan(folder.write("plan.md", text));
    CHECK_FALSE(reading.plan);
    std::string out;
    for (const Problem& p : reading.errors) {
      CHECK_FALSE(p.remedy.empty());
      out += std::to_string(p.line) + ": " + p.message + "\n";
    }
    return out;
  };
  CHECK(faults("---\ntitle", "title") == "1: the plan has no front matter\n");
  CHECK(faults("study: plan-1", "study: plan 1") == "3: 'plan 1' is no name for a study\n");
  CHECK(faults("pre: quiz", "pre: quizz") == "4: there is no lesson 'quizz' beside the plan or in the program\n");
  CHECK(faults("pre: quiz", "pre: lesson") == "4: 'lesson' is no test: its answers get a verdict\n");
  CHECK(faults("- hands -> touch", "- hands touch") ==
        "8: this line names no group with its condition and its lessons\n");
  CHECK(faults("-> touch", "-> tuch") == "8: 'tuch' is no condition of a study\n");
  CHECK(faults("- eyes", "- hands") == "9: two groups are called 'hands'\n");
  CHECK(faults("delayed: quiz", "later: quiz") == "6: plan has no key 'later'\n");
  CHECK(faults("delayed: quiz", "seed: 3") == "6: 'seed' goes with 'assign: draw'\n");
  CHECK(faults("delayed: quiz", "assign: draw\nstudents: 10\nseed: 1\nblock: 4") ==
        "9: a block of 4 students cannot hold 3 groups equally often\n");
  CHECK(faults("delayed: quiz", "assign: draw\nseed: 1") == "6: a draw needs 'students'\n");
}

TEST_CASE("a step that only one condition has is missed by a link in the others, at the line of the lesson") {
  const Folder folder;
  folder.write("lesson.md", kLesson + "[There](#told)\n");
  folder.write("quiz.md", kTest);
  std::string text = kPlan;
  const StudyPlanReading reading = readStudyPlan(folder.write("plan.md", text));
  // The lesson itself has the fault: without a condition the step 'Told' does not exist.
  const StudyPacks study = packStudy(*reading.plan);
  CHECK(study.packs.empty());
  REQUIRE_FALSE(study.errors.empty());
  CHECK(study.errors[0].file == (folder.path / "lesson.md").string());
  CHECK(study.errors[0].line == 32);
}

TEST_CASE("a draw of 200 students in three groups is balanced after every block and the same for the same seed") {
  const auto draw = permutedBlocks(200, 3, 6, 2026);
  CHECK(draw == permutedBlocks(200, 3, 6, 2026));
  CHECK(draw != permutedBlocks(200, 3, 6, 2027));
  std::array<int, 3> count{};
  for (std::size_t k = 0; k < draw.size(); ++k) {
    ++count[draw[k]];
    if ((k + 1) % 6 == 0) CHECK((count[0] == count[1] && count[1] == count[2]));
  }
  // Over many seeds each group is first equally often: 1000 of 3000, with a standard deviation of 26.
  std::array<int, 3> first{};
  for (std::uint64_t seed = 0; seed < 3000; ++seed) ++first[permutedBlocks(6, 3, 6, seed)[0]];
  for (const int n : first) CHECK(std::abs(n - 1000) < 4 * 26);
}

TEST_CASE("no code of 2000 becomes another by one wrong letter") {
  const std::vector<std::string> codes = studyCodes(kMaxStudyStudents, 7);
  const std::set<std::string> all(codes.begin(), codes.end());
  CHECK(all.size() == codes.size());
  for (const std::string& code : codes)
    for (std::size_t k = 0; k < code.size(); ++k)
      for (const char c : std::string("23456789ABCDEFGHJKLMNPQRSTUVWXYZ")) {
        std::string typed = code;
        typed[k] = c;
        if (typed != code) CHECK_FALSE(all.contains(typed));
      }
}

TEST_CASE("the page of a draw holds every group's pack and the group of each code, as the table does") {
  const Folder folder;
  folder.write("lesson.md", kLesson);
  folder.write("quiz.md", kTest);
  std::string text = kPlan;
  text.replace(text.find("delayed: quiz"), 13, "delayed: quiz\nassign: draw\nstudents: 9\nseed: 5\nblock: 3");
  const StudyPlanReading reading = readStudyPlan(folder.write("plan.md", text));
  for (const Problem& p : reading.errors) FAIL(p.text());
  const StudyPacks study = packStudy(*reading.plan);
  const std::vector<DrawnStudent> students = drawStudents(*reading.plan);
  const auto page =
      pageWithDraw("<p><!--a lesson comes here--></p>", "moltact.html", *reading.plan, study.packs, students);
  REQUIRE(page);
  for (const char* group : {"hands", "eyes", "dark"})
    CHECK(page->find("id=\"pack-bytes-" + std::string(group) + "\" data-name=\"plan-1-" + group + ".moltact\"") !=
          std::string::npos);
  CHECK(page->find("pack-bytes-delayed") == std::string::npos);
  const std::string table = drawTable(*reading.plan, students);
  CHECK(std::count(table.begin(), table.end(), '\n') == 10);
  for (const DrawnStudent& s : students) {
    const std::string& group = reading.plan->groups[s.group].name;
    CHECK(page->find('"' + s.code + "\":\"" + group + '"') != std::string::npos);
    CHECK(table.find("," + s.code + "," + group + ",") != std::string::npos);
  }
  CHECK_FALSE(pageWithDraw("<p></p>", "moltact.html", *reading.plan, study.packs, students));
}

TEST_CASE("the plan that comes with the program makes its packs without a warning") {
  const StudyPlanReading reading = readStudyPlan(MOLTACT_SOURCE_DIR "/assets/studies/touch-or-look.md");
  for (const Problem& p : reading.errors) FAIL(p.text());
  const StudyPacks study = packStudy(*reading.plan);
  for (const Problem& p : study.errors) FAIL(p.text());
  for (const Problem& p : study.warnings) CHECK_MESSAGE(false, p.text());
  CHECK(study.packs.size() == 4);
}

}  // namespace moltact
