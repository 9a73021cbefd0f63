// A lesson as it was read from its file: plain data. Immutable after reading; shared as std::shared_ptr<const Lesson>.
// Every part knows its place in the file, for messages. The format is described in reader.h.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "engine/haptics/touch_setup.h"
#include "engine/lesson/keys.h"
#include "engine/lesson/selection.h"
#include "engine/lesson/source_text.h"
#include "engine/lesson/way_rules.h"
#include "engine/molecule/molecule_key.h"

namespace moltact {

/// Where a stretch of text stands beside the line: "H~2~O", "10^-9^".
enum class Script : std::uint8_t { None, Sub, Super };

/// A stretch of text in one style.
struct TextRun {
  std::string text;
  bool bold = false, italic = false, code = false;
  Script script = Script::None;
  std::string link = {};  ///< where it leads: "#step-id", "#word:crease", a file or a web address; empty: it is no link
  Place place = {};
  Place link_place = {};  ///< where `link` is written
};

/// A line break that the author asked for is a "\n" in the text.
using RichText = std::vector<TextRun>;

struct Paragraph {
  RichText text;
};
struct Subheading {
  RichText text;
};
struct ListBlock {
  struct Item {
    RichText text;
    int depth = 0;   ///< 0 for the outermost list
    int number = 0;  ///< counted from the list's start; 0 for a bullet, -1 for a further paragraph of the item above
  };
  std::vector<Item> items;
};
/// Help that stays closed until the student opens it.
struct Tip {
  std::vector<RichText> paragraphs;
};
/// Shown to the teacher only.
struct TeacherNote {
  std::vector<RichText> paragraphs;
};
struct Quote {
  std::vector<RichText> paragraphs;
};
struct Image {
  std::string path, description;  ///< as written; relative to the lesson's folder
  std::string caption = {};       ///< stands below it; may be empty
  Place place = {};               ///< of the "!["
};
/// Its first row holds the headings; each row has as many cells as `sides`.
struct Table {
  enum class Side : std::uint8_t { Left, Middle, Right };
  std::vector<Side> sides;  ///< of the columns, to which their texts keep
  std::vector<std::vector<RichText>> rows;
};
struct CodeText {
  std::string text;
};
/// Where the task or question with this index (in the step) stands among the text.
struct TaskHere {
  std::size_t index = 0;
};
struct QuestionHere {
  std::size_t index = 0;
};

using Block = std::variant<Paragraph, Subheading, ListBlock, Tip, TeacherNote, Quote, Image, Table, CodeText, TaskHere,
                           QuestionHere>;

/// Where the parts of a scene are written. Two scenes that say the same are the same, wherever they say it.
struct ScenePlaces {
  Place scene, molecule, highlight, magnify, hide, untouchable, remove, in_hand, charges, cut, then, hydrogen_bonds;
  Place reading;  ///< of what was said last about how the molecule is read; line 0 where nothing was

  friend bool operator==(const ScenePlaces&, const ScenePlaces&) { return true; }
};

/// A view to come back to.
struct NamedView {
  std::string name;
  ViewSpec view;
  friend bool operator==(const NamedView&, const NamedView&) = default;
};

/// A second structure of the scene's molecule, to which the student moves its atoms.
struct SecondState {
  std::string molecule;             ///< its name, as the scene's own; empty: there is none
  Selection superposed_on;          ///< by which atoms it is laid on the first; not given: all that lead
  std::vector<std::string> states;  ///< what the two are called; empty: by the molecules' names
  double share = 0.0;               ///< where the scene begins: 0 the first, 1 the second
  friend bool operator==(const SecondState&, const SecondState&) = default;
};

/// The scene on the stage. It is complete: values that a scene block left out have been filled in.
struct SceneSpec {
  NamedMolecule molecule;             ///< its name in the library or beside the lesson, and how its file is read
  TouchSetup touch;                   ///< what it is felt with
  std::vector<std::string> show;      ///< names of the picture's parts
  std::vector<StyleSpec> styles;      ///< how the atoms are drawn; empty: a protein as a cartoon, else all as spheres
  Selection hide;                     ///< atoms that are not drawn; may select nothing
  Selection untouchable;              ///< atoms that are not felt; may select nothing
  Selection remove;                   ///< atoms that are neither drawn nor felt; may select nothing
  Selection in_hand;                  ///< atoms that the hand holds as a rigid body; may select nothing
  double near_A = 4.0;                ///< beside other styles: so near to the probe atoms are spheres
  std::vector<std::string> captions;  ///< below a molecule and the one beside it; empty: their names
  std::string colour = "element";     ///< what the atoms' colours tell: a scheme of engine/structure/colouring.h
  std::vector<MarkSpec> labels;       ///< names over the picture; word "atom", "residue", "chain", or a name of its own
  std::vector<MarkSpec> arrows;       ///< with their names
  std::vector<MarkSpec> marks;        ///< atoms in own colours; the word is the colour, the name for the legend
  Selection hydrogen_bonds;           ///< of which the hydrogen bonds are drawn; may select nothing
  std::vector<PlacesSpec> measures;   ///< two places: a length; three: an angle; four: a torsion
  bool paint_touched = false;         ///< atoms stay lightly painted once they have been touched
  std::vector<std::string> panels;    ///< "touch", "methods", or "none"; empty: as the student has them
  std::vector<std::string> locked;    ///< keys that the student cannot change, those of the front matter too
  Selection highlight;                ///< may select nothing
  ViewSpec view;                      ///< from where it is seen at first
  std::vector<NamedView> views;       ///< those to come back to, in the author's order
  bool cut = false;                   ///< the molecule is cut open
  Selection cut_at;                   ///< the plane goes through the middle of these atoms; not given: of all
  SecondState then;
  Selection magnify;  ///< atoms that fill the room of the hand; may select nothing: the whole molecule lies in it
  ScenePlaces places;

  /// Whether the student is kept from changing what a key says ("force").
  bool locks(std::string_view key) const {
    return std::any_of(locked.begin(), locked.end(), [&](const std::string& l) { return l == key || l == "all"; });
  }
  friend bool operator==(const SceneSpec&, const SceneSpec&) = default;
};

/// Something to do by touch. Its kind knows what the values mean (tasks/registry.h).
struct TaskSpec {
  std::string kind;  ///< "reach"
  KeyValues values;  ///< every key of the kind and the common ones, fallbacks filled in
  Place place;
  std::vector<std::size_t> goals;  ///< that it serves, as indices into those of the lesson
};

struct Choice {
  RichText text, feedback;
  std::string tag;   ///< the misconception that it shows, for the report; may be empty
  std::string link;  ///< "#step-id" that the feedback's first link to a step leads to; may be empty
  bool right = false;
  Place place;
};

/// The content of an `answer` block.
struct AnswerSpec {
  enum class Kind : std::uint8_t { Number, Text, Free };
  Kind kind = Kind::Free;
  double number = 0.0, tolerance = 0.0;  ///< in `unit`
  std::string unit;                      ///< "Å"; empty for a plain number
  std::vector<std::string> texts;        ///< what counts as right, as written
  AuthorsText right, wrong;              ///< feedback
  std::string model;                     ///< shown beside a free answer that is kept; may be empty
};

struct Question {
  std::string id;                ///< slug of its heading, unique in the step
  RichText title;                ///< what is asked
  std::vector<RichText> prompt;  ///< paragraphs between the heading and the choices
  std::vector<Choice> choices;   ///< empty where `answer` is given
  std::optional<AnswerSpec> answer;
  bool prediction = false;  ///< "Prediction:": what is right is told when the step's tasks are done, and never scored
  bool in_order = false;    ///< its choices stay as they are written
  int attempts = 0;         ///< after so many wrong answers the right one is shown; 0: as many as need be
  std::vector<WayRule> rules;      ///< what its answers do to the way
  std::vector<std::size_t> goals;  ///< that it serves, as indices into those of the lesson
  Place place, block_place;        ///< of its heading, and of its answer block (line 0: none)

  /// What is given is kept and neither right nor wrong.
  bool free() const { return answer && answer->kind == AnswerSpec::Kind::Free; }
  std::size_t rightChoices() const {
    std::size_t n = 0;
    for (const Choice& c : choices) n += c.right;
    return n;
  }
};

struct Step {
  std::string id;      ///< slug of its heading, unique in the lesson
  std::string title;   ///< without the "Aside:" of a side path
  bool aside = false;  ///< a side path: Next passes over it, a link or an offer leads to it, and its Next leads back
  bool extra = false;  ///< an aside that is offered below the step before it and at the lesson's end
  std::vector<Block> blocks;
  std::vector<TaskSpec> tasks;
  std::vector<Question> questions;
  SceneSpec scene;                 ///< what is on the stage in this step
  bool states_scene = false;       ///< false: the scene of the step before it goes on
  bool required = false;           ///< it must be finished before the student goes on
  std::vector<std::size_t> goals;  ///< that its tasks and questions serve where they do not say it themselves
  Place place, block_place;        ///< of its heading, and of its step block (line 0: none)
};

/// A word that the lesson explains.
struct GlossaryWord {
  std::string word;                 ///< as it is listed
  std::vector<std::string> others;  ///< how it is written too: "creases"
  RichText meaning;
  Place place;
};

struct Lesson {
  std::string file;
  std::string title, level, author, licence;
  std::string description;  ///< one line for the shelf; may be empty
  int order = 0;            ///< the place on the shelf; 0: none
  int card = 1;             ///< the step whose scene its card shows, counted from 1 without asides
  Place card_place;         ///< line 0 where the author did not say it
  bool required = false;    ///< every step must be finished before the next, where it does not say otherwise
  std::string language;     ///< "de": of the front matter; may be empty
  Place language_place;
  int minutes = 0;  ///< that its core takes, as the author states it; 0: as minutes.h works it out
  Place minutes_place;
  std::vector<std::string> goals, molecules;
  std::vector<Place> molecule_places;  ///< of each of `molecules`
  std::vector<std::string> locked;     ///< in every scene
  std::string ask;                     ///< "name" or "code" that the student is asked for; empty: neither
  std::vector<Block> introduction;     ///< what stands before the first step
  std::vector<Step> steps;             ///< at least one
  std::vector<GlossaryWord> glossary;  ///< its own words; with those of the file beside it once linkWords() was called

  /// The index of the step whose scene its card shows; no value where there is no such step.
  std::optional<std::size_t> cardStep() const {
    int number = 0;
    for (std::size_t i = 0; i < steps.size(); ++i)
      if (!steps[i].aside && ++number == card) return i;
    return {};
  }

  /// The extra steps that a step of the core offers: those between it and the next step of the core.
  std::vector<std::size_t> extrasOf(std::size_t step) const {
    std::vector<std::size_t> out;
    for (std::size_t i = step + 1; i < steps.size() && steps[i].aside; ++i)
      if (steps[i].extra) out.push_back(i);
    return out;
  }

  /// The index of a step by its id, or no value.
  std::optional<std::size_t> find(std::string_view id) const {
    for (std::size_t i = 0; i < steps.size(); ++i)
      if (steps[i].id == id) return i;
    return {};
  }
};

/// Whether its introduction or a step has one.
bool hasTeacherNotes(const Lesson& lesson);

/// The text of all runs without its styles. Scripts are written with the signs that Unicode has for them ("H₂O"); where
/// it has none, as people write them on a line ("K_d", "10^x").
std::string plainText(const RichText& text);
/// The letters of all runs alone: "H2O".
std::string bareText(const RichText& text);

}  // namespace moltact
