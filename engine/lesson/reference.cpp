#include "engine/lesson/reference.h"

#include <sstream>

#include "engine/lesson/keys.h"
#include "engine/lesson/minutes.h"
#include "engine/lesson/selection_node.h"
#include "engine/lesson/suggestion.h"
#include "engine/lesson/tasks/registry.h"

namespace moltact {
namespace {

constexpr std::string_view kHead = R"(# Every key of a lesson

`moltact lesson-reference > docs/lesson-reference.md` generates this page from the tables of the lesson reader; a test checks that they agree.
[Write a lesson](write-a-lesson.md) explains how to write lessons, and [what a lesson can hold](lesson-text.md) shows each part by example.

In the tables, *needed* marks a required key; for other keys the column gives the default, or — if the key then has no effect. A line that
starts with `#` inside a block or the front matter is a comment.
)";

std::string number(double value) {
  std::ostringstream out;
  out.precision(9);  // whole numbers up to a million have no exponent
  out << value;
  return out.str();
}

std::string code(std::string_view text) { return '`' + std::string(text) + '`'; }

std::string codeList(const std::vector<std::string_view>& words) {
  std::vector<std::string> quoted;
  for (const std::string_view w : words) quoted.push_back(code(w));
  const std::vector<std::string_view> views(quoted.begin(), quoted.end());
  return joined(views, " or ");
}

/// The same for a key that accepts several words.
std::string someOf(const std::vector<std::string_view>& words) {
  return words.size() == 1 ? codeList(words) : "one or more of " + codeList(words) + ", separated by commas";
}

/// ", 0.1 s to 600 s", ", -2 to 2" or ", at most 20 Å"; empty without limits.
std::string limits(const KeySpec& key) {
  const bool top = key.max < std::numeric_limits<double>::max();
  const std::string unit = key.dimension == Dimension::None ? "" : ' ' + std::string(codeUnit(key.dimension));
  const bool bottom = key.min > 0.0 || (key.min < 0.0 && key.min > std::numeric_limits<double>::lowest());
  if (bottom && top) return ", " + number(key.min) + unit + " to " + number(key.max) + unit;
  if (bottom) return ", at least " + number(key.min) + unit;
  return top ? ", at most " + number(key.max) + unit : "";
}

std::string valueOf(const KeySpec& key) {
  switch (key.type) {
    case ValueType::Text:
      return "a line of text";
    case ValueType::TextList:
      return "texts, separated by commas, or each on a line of its own that starts with `- `";
    case ValueType::Count:
      return "a whole number" + limits(key);
    case ValueType::Number:
      return "a number, with its unit if it has one";
    case ValueType::Quantity:
      return std::string(dimensionName(key.dimension)) + limits(key);
    case ValueType::Range:
      return std::string(dimensionName(key.dimension)) + " from … to …" + limits(key);
    case ValueType::Word:
      return codeList(key.words);
    case ValueType::WordList:
      return someOf(key.words);
    case ValueType::Selection:
      return "a [selection](#selections)";
    case ValueType::Target:
      return codeList(key.words) + ", or a [selection](#selections)";
    case ValueType::Path:
      return codeList(key.words) + (key.words.empty() ? "" : ", or ") +
             "[selections](#selections) with `then` between them";
    case ValueType::View:
      return codeList(key.words) +
             ", or `facing` and a [selection](#selections), or `turned` and two or three angles in degrees; optionally "
             "followed by a comma, `zoom` and a selection";
    case ValueType::Marks:
      return (key.words.empty() ? "" : someOf(key.words) + "; ") +
             std::string("names in double quotes, and `for` with a [selection](#selections); or `none`");
    case ValueType::Places:
      return "[selections](#selections) with ` - ` between them, several separated by commas; or `none`";
    case ValueType::Remarks:
      return "lines `- selection -> text`, each with a [selection](#selections)";
    case ValueType::Counts:
      return "whole numbers" + limits(key) + ", separated by commas";
    case ValueType::Way:
      return "`go to` and a step, or `skip` and one or more steps separated by commas: by their links "
             "(`#its-heading`), or one by its heading";
    case ValueType::Facts: {
      const int min = int(key.min);
      const std::string many = min == 1 ? "a [selection](#selections)"
                                        : std::string(min == 2 ? "two" : "three or four") +
                                              " [selections](#selections) with ` - ` between them";
      return "lines `- … = …`: " + many + ", and " +
             (key.dimension == Dimension::None ? "a whole number" : dimensionName(key.dimension));
    }
    case ValueType::Styles:
      return someOf(key.words) +
             ", each optionally followed by its opacity (`surface 40%`), and by `for` and a [selection](#selections)";
  }
  return {};
}

/// The text of a table's cell, with bars escaped.
std::string cell(std::string_view text) {
  std::string out;
  for (const char c : text) out += c == '|' ? "\\|" : std::string(1, c);
  return out;
}

void table(std::ostream& out, const std::vector<KeySpec>& keys) {
  out << "| key | default | value | meaning |\n| --- | --- | --- | --- |\n";
  for (const KeySpec& k : keys)
    out << "| `" << k.name << "` | "
        << (k.required           ? "*needed*"
            : k.fallback.empty() ? "—"
                                 : cell(code(k.fallback)))
        << " | " << cell(valueOf(k)) << " | " << cell(k.meaning) << " |\n";
  out << '\n';
}

void tasks(std::ostream& out) {
  out << "## Touch tasks\n\nA fenced block `touch` defines one task. Its kind is one of the keys, usually that of the "
         "first line. A block has the keys of its kind and the following common ones:\n\n";
  table(out, keysOf(KeyBlock::Touch));
  out << "The kinds are:\n\n| kind | what the student does |\n| --- | --- |\n";
  for (const TaskKind& kind : taskKinds())
    out << "| [`" << kind.name << "`](#" << kind.name << ") | " << cell(kind.meaning) << " |\n";
  out << '\n';
  for (const TaskKind& kind : taskKinds()) {
    out << "### " << kind.name << "\n\n" << kind.meaning << "\n\n";
    table(out, kind.keys);
    if (!kind.of_body.empty()) out << "With a body in the hand (`in-hand`): " << kind.of_body << "\n\n";
  }
}

void facts(std::ostream& out) {
  out << R"(## Facts

A fenced block `facts` states what the lesson says about its molecule, so that `moltact check` can compute it. Nothing of the block is
ever shown to students. A line names its atoms and the number, with one of three signs:

* `=`: the computed value, rounded to the digits of the stated one, is equal to it; `= 2.0 Å to 2.2 Å` states a range;
* `<` and `>`: the computed value is smaller or larger.

A false fact is an error of `check`, with its line, the stated and the computed value. The window does not compute facts, because
some searches take seconds.

)";
  table(out, keysOf(KeyBlock::Facts));
}

void minutes(std::ostream& out) {
  out << "## Minutes\n\nThe program estimates the duration of a lesson. It assumes that a student reads "
      << number(kWordsAMinute)
      << " words per minute. This includes the text, the sentences of tasks and questions, all choices and the "
         "feedback on the right one, but not hints, teacher's notes and the glossary. A question takes "
      << number(kQuestion_s) << " s more, a free answer " << number(kFreeAnswer_s)
      << " s. A task takes the time of its kind, plus the time given by `for`.\n\n| kind | time |\n| --- | --- |\n";
  for (const TaskKind& kind : taskKinds()) {
    const TaskTime& t = kind.time;
    out << "| `" << kind.name << "` | ";
    if (t.base_s > 0.0) out << number(t.base_s) << " s" << (t.each_s > 0.0 ? " and " : "");
    if (t.each_s > 0.0) out << number(t.each_s) << " s for each " << t.each_what;
    out << " |\n";
  }
  out << "\n`moltact info` and `moltact check` show the minutes of the core and of all steps. `check` warns if the "
         "`minutes` of the front matter differ from the estimate for the core by more than "
      << number(100.0 * kMinutesOff) << " %, and if the core takes more than " << number(kMaxCoreMinutes)
      << " minutes.\n\n";
}

void units(std::ostream& out) {
  out << "## Quantities\n\nA quantity is a number and its unit: `4 Å`, `0.3 N`. Where a table says a length, a force, "
         "a "
         "time or a stiffness, a number without its unit is an error. Other numbers of scenes and tasks, such as "
         "`energy` "
         "(kcal/mol) and `turned` (degrees), are written without a unit. The decimal sign is a point.\n\n| quantity | "
         "units |\n| --- | --- |\n";
  for (const Dimension d : {Dimension::Length, Dimension::Force, Dimension::Time, Dimension::Stiffness}) {
    out << "| " << dimensionName(d) << " |";
    const char* before = " ";
    for (const std::string_view symbol : namedUnits(d)) out << std::exchange(before, " or ") << symbol;
    out << " |\n";
  }
  out << "\nA range has two ends: `0.2 N to 0.6 N`.\n\n";
}

void selections(std::ostream& out) {
  out << "## Selections\n\nA selection specifies atoms, in the language that molecular viewers share. Names are "
         "written as in the molecule's file; the words of the language are in lower case.\n\n| words | atoms |\n| --- "
         "| --- |\n";
  for (const SelectionWord& w : selectionWords()) out << "| `" << w.word << "` | " << cell(w.meaning) << " |\n";
  out << R"(| `within` | atoms near others, including those: `within 5 Å of (ligand HEM)` |
| `bonded` | atoms with a bond to a selected atom: `bonded to (element Fe)` |
| `not` | all others: `not water` |
| `and` | atoms that are both: `chain A and name CA` |
| `or` | atoms that are either: `resname ASP or resname GLU` |

`not` has the highest precedence, then `and`, then `or`; parentheses group. A name that is also a word of the language, or that contains a
space or a parenthesis, requires double quotes: `name "CA 1"`. `moltact info MOLECULE` lists the chains, elements and ligands of a molecule. A
selection without atoms is an error.
)";
}

}  // namespace

std::string lessonReference() {
  std::ostringstream out;
  out << kHead << "\n## Front matter\n\nBetween two lines `---` at the start of the file.\n\n";
  table(out, keysOf(KeyBlock::FrontMatter));
  out << "## Steps\n\nAn optional fenced block `step` below a step's heading.\n\n";
  table(out, keysOf(KeyBlock::Step));
  out << "A required step shows *Finish this step first* instead of *Next* until its tasks are done and its questions "
         "answered, or their tries are used up. Until then links to later steps have no effect; links back and to "
         "asides work.\n\n";
  out << "## Scenes\n\nA fenced block `scene` sets the scene of its step and of those after it. A scene that names a "
         "molecule starts from the defaults. One without a molecule changes only the keys that it contains.\n\n";
  table(out, keysOf(KeyBlock::Scene));
  tasks(out);
  out << "## Answers\n\nA fenced block `answer` below `### Question: …` asks for a number or for words, if a list of "
         "choices would reveal the answer. It has one of the keys `number`, `text` and `free`. If a student enters "
         "text where a number is required, the program asks again and does not count a try. The unit is shown beside "
         "the field.\n\nEach attempt shows the choices of a question in another order; those of a numbered list (`1. [ "
         "] …`) keep their order. `### Prediction: …` asks before the touch. The student may change the choice until "
         "the tasks of the step are done; only then the right answer is shown. Reports do not score predictions.\n\n";
  table(out, keysOf(KeyBlock::Answer));
  out << R"(A wrong choice may have a second arrow with the tag of the misconception that it indicates (`- [ ] Two → Feel again. → pit taken for crease`).
Students do not see tags; the report counts them.

A block `answer` below choices may contain only `attempts`, `goal` and conditions, because the choices define the right answer.

A condition that leads back or into an aside applies once. It shows *Go on* below the feedback, *Next* leads there too, and the question accepts
no answer before that. A condition that leads forward makes *Next* skip the steps in between; `skip` makes it skip the named steps. Skipped steps
do not count for the progress. No conditions can trap a student.

)";
  facts(out);
  minutes(out);
  units(out);
  selections(out);
  return out.str();
}

}  // namespace moltact
