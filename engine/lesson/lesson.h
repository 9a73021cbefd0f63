// A lesson as read from its file: plain data. Immutable after reading; shared as std::shared_ptr<const Lesson>. Every
// part stores its place in the file for messages. reader.h describes the format.
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
#include "engine/lesson/step_rules.h"
#include "engine/molecule/molecule_key.h"

namespace moltact {

/// What a study gives to a student of a lesson (docs/study.md).
enum class Condition : std::uint8_t {
  Touch,  ///< the lesson as it is written
  Look,   ///< the same scenes and texts without touch and without touch tasks
  Blind,  ///< the same touch, and no picture of the molecule
};
/// "touch", "look" or "blind".
std::string_view nameOf(Condition condition);
/// The condition of this name; nothing if there is none.
std::optional<Condition> conditionNamed(std::string_view name);

/// The place of a lesson in a study; empty texts if it is in none.
struct StudyPart {
  std::string study;  ///< the study's name
  std::string part;   ///< "pre", "lesson", "lesson 2", "post" or "delayed"
  std::string group;  ///< empty in a page for every group
  friend bool operator==(const StudyPart&, const StudyPart&) = default;
};

/// The position of text relative to the line: "H~2~O", "10^-9^".
enum class Script : std::uint8_t { None, Sub, Super };

/// A piece of text in one style.
struct TextRun {
  std::string text;
  bool bold = false, italic = false, code = false;
  Script script = Script::None;
  std::string link = {};  ///< its target: "#step-id", "#word:crease", a file or a web address; empty: not a link
  Place place = {};
  Place link_place = {};  ///< place of `link` in the file
};

/// A line break by the author is "\n" in the text.
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
    int number = 0;  ///< counted from the list's start; 0 for a bullet, -1 for another paragraph of the previous item
  };
  std::vector<Item> items;
};
/// A hint, closed until the student opens it.
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
  std::string caption = {};       ///< text below it; may be empty
  Place place = {};               ///< place of the "!["
};
/// The first row contains the headings. Each row has as many cells as `sides`.
struct Table {
  enum class Side : std::uint8_t { Left, Middle, Right };
  std::vector<Side> sides;  ///< alignment of each column
  std::vector<std::vector<RichText>> rows;
};
struct CodeText {
  std::string text;
};
/// The place in the text of the task or question with this index (in the step).
struct TaskHere {
  std::size_t index = 0;
};
struct QuestionHere {
  std::size_t index = 0;
};

using Block = std::variant<Paragraph, Subheading, ListBlock, Tip, TeacherNote, Quote, Image, Table, CodeText, TaskHere,
                           QuestionHere>;

/// The places of a scene's parts in the file. They do not count in comparisons: scenes with equal contents are equal.
struct ScenePlaces {
  Place scene, molecule, highlight, magnify, hide, untouchable, remove, in_hand, charges, cut, then, elastic,
      simulation, pull, trajectory, scan, hydrogen_bonds, modes;
  Place reading;  ///< of the last key about reading the molecule; line 0: none

  friend bool operator==(const ScenePlaces&, const ScenePlaces&) { return true; }
};

/// A view that the student can return to.
struct NamedView {
  std::string name;
  ViewSpec view;
  friend bool operator==(const NamedView&, const NamedView&) = default;
};

/// A second structure of the scene's molecule, toward which the student moves its atoms.
struct SecondState {
  std::string molecule;             ///< its name, as that of the first; empty: none
  Selection superposed_on;          ///< the atoms used for the superposition; not given: CA, P and C1'
                                    ///< (superposition.h)
  std::vector<std::string> states;  ///< the names of both; empty: the names of the molecules
  double share = 0.0;               ///< at the start of the scene; 0: first, 1: second structure
  friend bool operator==(const SecondState&, const SecondState&) = default;
};

/// A trajectory whose frames move the scene's atoms.
struct TrajectorySpec {
  std::string file;          ///< beside the lesson or the molecule, or a molecule's name; empty: none
  bool superposed = true;    ///< each frame is superposed on the molecule
  Selection superposed_on;   ///< over CA, P and C1' of these atoms (superposition.h); not given: of all
  std::uint32_t first = 1;   ///< the frames that are shown, counted from 1
  std::uint32_t last = 0;    ///< 0: to the end
  double frames_per_s = 10;  ///< 0: at rest
  friend bool operator==(const TrajectorySpec&, const TrajectorySpec&) = default;
};

/// What a press does in a simulation: it pushes by contact, or holds an atom, its residue, or the atoms of a selection.
enum class PullBy : std::uint8_t { None, Atom, Residue, Selection };

/// The scene of a step. It is complete: keys that a scene block omits have been filled in.
struct SceneSpec {
  NamedMolecule molecule;             ///< its name in the library or in the lesson's folder, and how its file is read
  TouchSetup touch;                   ///< how it is felt
  std::vector<std::string> show;      ///< the visible parts of the picture, by name
  std::vector<StyleSpec> styles;      ///< how the atoms are drawn; empty: proteins as cartoons, all others as spheres
  Selection hide;                     ///< atoms that are not drawn; may select nothing
  Selection untouchable;              ///< atoms that are not felt; may select nothing
  Selection remove;                   ///< atoms that are neither drawn nor felt; may select nothing
  Selection in_hand;                  ///< atoms that the hand holds as a rigid body; may select nothing
  double near_A = 4.0;                ///< in other styles, atoms within this distance of the probe are drawn as spheres
  std::vector<std::string> captions;  ///< captions of the molecule and of the one beside it; empty: their names
  std::string colour = "element";     ///< the colour scheme of the atoms (engine/structure/colouring.h)
  std::vector<MarkSpec> labels;       ///< labels over the picture; the word is "atom", "residue", "chain" or a text
  std::vector<MarkSpec> arrows;       ///< arrows with their labels
  std::vector<MarkSpec> marks;        ///< atoms with their own colours; the word is the colour, the name is for the
                                      ///< legend
  Selection hydrogen_bonds;           ///< atoms whose hydrogen bonds are drawn; may select nothing
  std::vector<PlacesSpec> measures;   ///< two atoms give a length, three an angle, four a torsion
  bool paint_touched = false;         ///< touched atoms stay lightly painted
  std::vector<std::string> panels;    ///< "touch", "methods", "motion" or "none"; empty: the student's choice
  std::vector<std::string> locked;    ///< keys that the student cannot change, including those of the front matter
  Selection highlight;                ///< may select nothing
  ViewSpec view;                      ///< the initial view
  std::vector<NamedView> views;       ///< the views to return to, in the author's order
  bool cut = false;                   ///< show the molecule cut open
  Selection cut_at;                   ///< the cutting plane goes through the centre of these atoms; not given: of all
                                      ///< atoms
  SecondState then;
  TrajectorySpec trajectory;
  bool elastic = false;                    ///< the molecule yields to the hand as an elastic network (engine/dynamics)
  std::vector<std::size_t> elastic_modes;  ///< the only modes in which it yields, from 0, ascending; empty: all motions
  double scan_A = 0.0;         ///< radius of a tip that scans the molecule (engine/haptics/height_field); 0: none
  double scan_force_pN = 0.0;  ///< constant force of the tip; 0: contact without force
  /// File of a serialised system whose simulation moves the atoms, or an address (simulation_engines.h); empty: none.
  std::string simulation;
  PullBy pull = PullBy::None;    ///< what a press holds in the simulation
  Selection pulled;              ///< for PullBy::Selection
  double temperature_K = 300.0;  ///< of the simulation's heat bath
  Selection magnify;             ///< these atoms fill the workspace; if empty, the whole molecule does
  ScenePlaces places;

  /// Whether the lesson prevents the student from changing this key ("force").
  bool locks(std::string_view key) const {
    return std::any_of(locked.begin(), locked.end(), [&](const std::string& l) { return l == key || l == "all"; });
  }
  friend bool operator==(const SceneSpec&, const SceneSpec&) = default;
};

/// A touch task. Its kind (tasks/registry.h) defines the meaning of the values.
struct TaskSpec {
  std::string kind;  ///< "reach"
  KeyValues values;  ///< every key of the kind and the common ones, with defaults filled in
  Place place;
  std::vector<std::size_t> goals;  ///< indices of the lesson's goals that it serves
};

struct Choice {
  RichText text, feedback;
  std::string tag;   ///< the misconception that it indicates, for the report; may be empty
  std::string link;  ///< target of the feedback's first link to a step, "#step-id"; may be empty
  bool right = false;
  Place place;
};

/// The content of an `answer` block.
struct AnswerSpec {
  enum class Kind : std::uint8_t { Number, Text, Free };
  Kind kind = Kind::Free;
  double number = 0.0, tolerance = 0.0;  ///< in `unit`
  std::string unit;                      ///< "Å"; empty for a plain number
  std::vector<std::string> texts;        ///< the accepted answers, as written
  AuthorsText right, wrong;              ///< feedback
  std::string model;                     ///< the author's answer, shown beside a submitted free answer; may be empty
};

struct Question {
  std::string id;                ///< slug of its heading, unique within the step
  RichText title;                ///< the heading: the question itself
  std::vector<RichText> prompt;  ///< paragraphs between the heading and the choices
  std::vector<Choice> choices;   ///< empty if `answer` is present
  std::optional<AnswerSpec> answer;
  bool prediction = false;         ///< "Prediction:": resolved when the step's tasks are done, and never scored
  bool in_order = false;           ///< choices keep the order of the file
  int attempts = 0;                ///< the number of wrong answers after which the right one is shown; 0: never
  std::vector<StepRule> rules;     ///< the effects of its answers on the order of the steps
  std::vector<std::size_t> goals;  ///< indices of the lesson's goals that it serves
  Place place, block_place;        ///< of its heading, and of its answer block (line 0: none)

  /// Whether answers are stored without being right or wrong.
  bool free() const { return answer && answer->kind == AnswerSpec::Kind::Free; }
  std::size_t rightChoices() const {
    std::size_t n = 0;
    for (const Choice& c : choices) n += c.right;
    return n;
  }
};

/// Statements about a molecule, which checkFacts() computes. Never shown.
struct FactsSpec {
  NamedMolecule molecule;
  Selection remove;  ///< atoms that are taken out before anything is computed; may select nothing
  double probe_A = 0.0;
  std::vector<std::pair<std::string_view, FactSpec>> facts;  ///< by their keys, in the order of the file
  Place molecule_place, remove_place;                        ///< of the names, or of the block
};

struct Step {
  std::string id;      ///< slug of its heading, unique within the lesson
  std::string title;   ///< without the "Aside:" of an aside
  bool aside = false;  ///< outside the core: Next skips it, a link or an offer leads to it, and its Next leads back
  bool extra = false;  ///< an aside that is offered below the preceding step and at the lesson's end
  std::vector<Block> blocks;
  std::vector<TaskSpec> tasks;
  std::vector<Question> questions;
  std::vector<FactsSpec> facts;
  SceneSpec scene;                    ///< the scene during this step
  bool states_scene = false;          ///< false: the scene of the previous step continues
  bool required = false;              ///< must be finished before the next step
  std::vector<std::size_t> goals;     ///< goals of its tasks and questions that name none themselves
  std::vector<Condition> conditions;  ///< the only conditions with this step; empty: all
  Place place, block_place;           ///< of its heading, and of its step block (line 0: none)
};

/// A word that the lesson explains.
struct GlossaryWord {
  std::string word;                 ///< the form in the list
  std::vector<std::string> others;  ///< other forms: "creases"
  RichText meaning;
  Place place;
};

struct Lesson {
  std::string file;
  std::string title, level, author, licence;
  std::string description;  ///< one line for the welcome page; may be empty
  int order = 0;            ///< position on the welcome page; 0: not given
  int card = 1;             ///< the step whose scene is the picture on its card, counted from 1 without asides
  Place card_place;         ///< line 0: not given
  bool required = false;    ///< default for all steps: each must be finished before the next
  std::string language;     ///< "de": from the front matter; may be empty
  Place language_place;
  int minutes = 0;  ///< duration of the core as stated by the author; 0: estimated by minutes.h
  Place minutes_place;
  std::vector<std::string> goals, molecules;
  std::vector<Place> molecule_places;  ///< place of each of `molecules`
  std::vector<std::string> locked;     ///< locked keys in every scene
  std::string ask;                     ///< what the student is asked for: "name" or "code"; empty: nothing
  bool test = false;                   ///< answers are kept without a verdict and may be changed; the last one counts
  Condition condition = Condition::Touch;
  StudyPart study;
  std::vector<Block> introduction;     ///< the text before the first step
  std::vector<Step> steps;             ///< at least one
  std::vector<GlossaryWord> glossary;  ///< its own words; after linkWords() also those of its folder's glossary

  /// The index of the step whose scene is shown on the card; no value if there is no such step.
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

/// Whether the introduction or any step has a teacher's note.
bool hasTeacherNotes(const Lesson& lesson);

/// The text of all runs without styles. Scripts use Unicode characters where available ("H₂O"), otherwise the usual
/// notation on one line ("K_d", "10^x").
std::string plainText(const RichText& text);
/// The characters of all runs: "H2O".
std::string bareText(const RichText& text);

}  // namespace moltact
