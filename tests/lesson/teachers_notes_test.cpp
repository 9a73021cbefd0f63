// The notes for a teacher who did not write the lesson: in every lesson, in each language, they have each of seven
// parts, recognised by their first words.
#include <algorithm>
#include <filesystem>

#include "engine/lesson/lesson_files.h"
#include "tests/lesson/shipped_lesson.h"

using namespace moltact;
using namespace moltact::test;

namespace {

std::string notesOf(const Lesson& lesson) {
  std::string out;
  const auto add = [&](const std::vector<Block>& blocks) {
    for (const Block& b : blocks)
      if (const auto* note = std::get_if<TeacherNote>(&b))
        for (const RichText& paragraph : note->paragraphs) out += plainText(paragraph) + '\n';
  };
  add(lesson.introduction);
  for (const Step& step : lesson.steps) add(step.blocks);
  std::replace(out.begin(), out.end(), '\n', ' ');
  return out;
}

using Part = std::vector<std::string>;  // ways to begin it

// Prior knowledge, misconceptions, expected answers, prompts, one device, none, what the model leaves out.
const std::vector<Part> kEnglish{{"Prior knowledge:"}, {"isconceptions to expect:", "Common misconceptions:"},
                                 {"Expected answer"},  {"For discussion:", "Prompts for discussion:"},
                                 {"With one device"},  {"With none", "Without one", "Without a device"},
                                 {"leaves out"}};
const std::vector<Part> kGerman{{"Vorwissen:"},
                                {"Was Lernende oft meinen:", "Fehlvorstellungen:"},
                                {"Erwartete Antwort"},
                                {"Zum Gespräch:", "Anstöße:"},
                                {"Mit einem Gerät"},
                                {"Ohne Gerät"},
                                {"Was das Modell auslässt", "Was das Modell weglässt", "Das Modell lässt"}};
const std::vector<Part> kFrench{
    {"Connaissances préalables"},  // without the colon, before which stands a no-break space
    {"Idées fausses fréquentes"}, {"Réponse attendue"}, {"Pour la discussion"},
    {"Avec un seul appareil"},    {"Sans appareil"},    {"Ce que le modèle omet"}};

const std::vector<Part>& partsOf(const std::string& name) {
  return name.ends_with(".de") ? kGerman : name.ends_with(".fr") ? kFrench : kEnglish;
}

}  // namespace

TEST_CASE("the teacher's notes of every shipped lesson have all seven parts") {
  int lessons = 0;
  for (const auto& entry : std::filesystem::directory_iterator(MOLTACT_SOURCE_DIR "/lessons")) {
    if (!looksLikeLesson(entry.path())) continue;
    const std::string name = entry.path().stem().string();
    CAPTURE(name);
    const std::string notes = notesOf(shippedLesson(name));
    for (const Part& part : partsOf(name))
      CHECK_MESSAGE(std::any_of(part.begin(), part.end(),
                                [&](const std::string& words) { return notes.find(words) != std::string::npos; }),
                    part.front());
    ++lessons;
  }
  CHECK(lessons >= 28);
}
