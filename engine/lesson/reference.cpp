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

This page is made by `moltact lesson-reference > docs/lesson-reference.md` from the tables with which lessons are read; a
test fails where it differs from them. How to write a lesson is told in [Write a lesson](write-a-lesson.md).

In the tables, *needed* stands where a key must be given; otherwise that column says what is taken where it is left
out, and — that it then plays no part. A line that starts with `#` inside a block or the front matter is a note to yourself.
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
  return words.size() == 1 ? codeList(words) : "one or more of " + codeList(words) + ", parted by commas";
}

/// ", 0.1 s to 600 s" or ", at most 20 Å"; empty without limits.
std::string limits(const KeySpec& key) {
  const bool top = key.most < std::numeric_limits<double>::max();
  const std::string unit = key.dimension == Dimension::None ? "" : ' ' + std::string(codeUnit(key.dimension));
  if (key.least > 0.0 && top) return ", " + number(key.least) + unit + " to " + number(key.most) + unit;
  if (key.least > 0.0) return ", at least " + number(key.least) + unit;
  return top ? ", at most " + number(key.most) + unit : "";
}

std::string valueOf(const KeySpec& key) {
  switch (key.type) {
    case ValueType::Text:
      return "a line of text";
    case ValueType::TextList:
      return "texts, each on a line of its own that starts with `- `, or parted by commas";
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
             ", or `facing` and a [selection](#selections), or `turned` and two or three angles in degrees; behind a "
             "comma "
             "`zoom` and a selection, which fills the view";
    case ValueType::Marks:
      return (key.words.empty() ? "" : someOf(key.words) + ", ") +
             std::string("names in double quotes, and `for` with a [selection](#selections); or `none`");
    case ValueType::Places:
      return "[selections](#selections) with ` - ` between them, several parted by commas; or `none`";
    case ValueType::Remarks:
      return "lines `- selection -> what is said`, each with a [selection](#selections)";
    case ValueType::Counts:
      return "whole numbers" + limits(key) + ", parted by commas";
    case ValueType::Way:
      return "`go to` and a step, or `skip` and one or more steps parted by commas: by their links (`#its-heading`) or "
             "one by its heading";
    case ValueType::Facts: {
      const int least = int(key.least);
      const std::string many = least == 1 ? "a [selection](#selections)"
                                          : std::string(least == 2 ? "two" : "three or four") +
                                                " [selections](#selections) with ` - ` between them";
      return "lines `- … = …`: " + many + ", and " +
             (key.dimension == Dimension::None ? "a whole number" : dimensionName(key.dimension));
    }
    case ValueType::Styles:
      return someOf(key.words) +
             ", each with its opacity (`surface 40%`) and, behind `for`, a [selection](#selections) if it is not for "
             "all";
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
  out << "| key | left out | value | what it is |\n| --- | --- | --- | --- |\n";
  for (const KeySpec& k : keys)
    out << "| `" << k.name << "` | "
        << (k.required           ? "*needed*"
            : k.fallback.empty() ? "—"
                                 : cell(code(k.fallback)))
        << " | " << cell(valueOf(k)) << " | " << cell(k.meaning) << " |\n";
  out << '\n';
}

void tasks(std::ostream& out) {
  out << "## Touch tasks\n\nA fenced block `touch` holds one task. Its kind is the key with which the block's first "
         "line usually starts; a block has the "
         "keys of its kind and these, which every kind has:\n\n";
  table(out, keysOf(KeyBlock::Touch));
  out << "These are the kinds:\n\n| kind | what the student does |\n| --- | --- |\n";
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
  out << "## Minutes\n\nThe program works out how long a lesson takes. A student reads " << number(kWordsAMinute)
      << " words a minute: the text, what tasks and questions say, all choices and the feedback to the right one; not "
         "hints, teacher's notes and the glossary. A question takes "
      << number(kQuestion_s) << " s more, a free answer " << number(kFreeAnswer_s)
      << " s. A task takes the time of its kind, and the time for which `for` asks the hand to stay.\n\n"
         "| kind | time |\n| --- | --- |\n";
  for (const TaskTime& t : taskTimes()) {
    out << "| `" << t.kind << "` | ";
    if (t.base_s > 0.0) out << number(t.base_s) << " s" << (t.each_s > 0.0 ? " and " : "");
    if (t.each_s > 0.0) out << number(t.each_s) << " s for each " << t.each_what;
    out << " |\n";
  }
  out << "\n`moltact info` and `moltact check` show the minutes of the core and of all steps. `check` warns where the "
         "front matter states minutes that differ from those of the core by more than "
      << number(100.0 * kMinutesOff) << " %, and where the core takes more than " << number(kMaxCoreMinutes)
      << " minutes.\n\n";
}

void units(std::ostream& out) {
  out << "## Quantities\n\nA quantity is a number and its unit: `4 Å`, `0.3 N`. A number without its unit is an error. "
         "The decimal sign is a "
         "point.\n\n| quantity | units |\n| --- | --- |\n";
  for (const Dimension d : {Dimension::Length, Dimension::Force, Dimension::Time, Dimension::Stiffness}) {
    out << "| " << dimensionName(d) << " |";
    const char* before = " ";
    for (const std::string_view symbol : namedUnits(d)) out << std::exchange(before, " or ") << symbol;
    out << " |\n";
  }
  out << "\nA range has both ends: `0.2 N to 0.6 N`.\n\n";
}

void selections(std::ostream& out) {
  out << "## Selections\n\nA selection names atoms, in the words that molecular viewers share. Names are written as in "
         "the molecule's file; the words of "
         "the language in small letters.\n\n| words | atoms |\n| --- | --- |\n";
  for (const SelectionWord& w : selectionWords()) out << "| `" << w.word << "` | " << cell(w.meaning) << " |\n";
  out << R"(| `within` | atoms near others, those included: `within 5 Å of (ligand HEM)` |
| `bonded` | atoms with a bond to a selected atom: `bonded to (element Fe)` |
| `not` | all others: `not water` |
| `and` | atoms that are both: `chain A and name CA` |
| `or` | atoms that are either: `resname ASP or resname GLU` |

`not` binds first, then `and`, then `or`; round brackets group. A name that is also a word of the language, or has a space or
bracket in it, stands in double quotes: `name "CA 1"`. `moltact info MOLECULE` tells which chains, elements and ligands a
molecule has. A selection of no atoms is an error.
)";
}

}  // namespace

std::string lessonReference() {
  std::ostringstream out;
  out << kHead << "\n## Front matter\n\nBetween two lines `---` at the start of the file.\n\n";
  table(out, keysOf(KeyBlock::FrontMatter));
  out << "## Steps\n\nA fenced block `step` below a step's heading; most steps need none.\n\n";
  table(out, keysOf(KeyBlock::Step));
  out << "A step that is required shows *Finish this step first* in the place of *Next* until its tasks are done and "
         "its questions answered (or their tries used up); links to later steps do not lead there before, links back "
         "and to asides do.\n\n";
  out << "## Scenes\n\nA fenced block `scene` says what is on the stage in its step and those after it. A scene that "
         "names a molecule starts anew; one that "
         "does not keeps all that it does not say.\n\n";
  table(out, keysOf(KeyBlock::Scene));
  tasks(out);
  out << "## Answers\n\nA fenced block `answer` below `### Question: …` asks for a number or for words, where a list "
         "of choices would give the answer away. It "
         "has one of `number`, `text` and `free`. A student who writes what is no number is asked again, which does "
         "not "
         "count as a try; the unit stands beside the field.\n\nThe choices of a question stand in another order for "
         "each attempt; those of "
         "a numbered list (`1. [ ] …`) stay as they are written. `### Prediction: …` asks before the touch: what is "
         "chosen can be "
         "changed until the tasks of the step are done, only then is it told what is right, and a report does not "
         "score "
         "it.\n\n";
  table(out, keysOf(KeyBlock::Answer));
  out << R"(Behind a second arrow of a wrong choice (`- [ ] Two → Feel again. → pit taken for crease`) stands the tag of the misconception that it
shows, which students do not see and the report counts.

Below choices a block `answer` may hold `attempts`, `goal` and the conditions alone; what is right stands in the choices then.

A condition leads back, or into an aside, once: it shows *Go on* under what is said to the answer, and *Next* leads there too; the
question takes no answer before that. Leading forward, it lets *Next* pass over what stands between, and `skip` over the steps that it
names; what is passed over does not count for the progress. No condition can hold a student for ever.

)";
  facts(out);
  minutes(out);
  units(out);
  selections(out);
  return out.str();
}

}  // namespace moltact
