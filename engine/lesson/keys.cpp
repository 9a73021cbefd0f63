#include "engine/lesson/keys.h"

#include <iterator>
#include <utility>

#include "engine/language/catalogue.h"
#include "engine/lesson/facts.h"
#include "engine/lesson/reading_keys.h"
#include "engine/lesson/touch_keys.h"
#include "engine/molecule/view_part.h"
#include "engine/structure/colouring.h"

namespace moltact {
namespace {

/// What a student may be kept from changing: keys of a scene, by their names.
std::vector<std::string_view> lockable() {
  std::vector<std::string_view> out{"panels"};
  for (const KeySpec& k : touchSceneKeys()) out.push_back(k.name);
  out.insert(out.end(), {"show", "magnify", "all"});
  return out;
}

std::vector<std::string_view> viewPartNames() {
  std::vector<std::string_view> out;
  for (const ViewPartInfo& part : viewParts()) out.push_back(part.name);
  return out;
}

std::vector<std::string_view> styleNames() {
  std::vector<std::string_view> out;
  for (const DrawStyleInfo& style : drawStyles()) out.push_back(style.name);
  return out;
}

std::vector<std::string_view> viewWords() { return {"side", "front", "back", "left", "right", "top", "bottom"}; }

std::vector<std::string_view> colouringNames() {
  std::vector<std::string_view> out;
  for (const ColouringScheme& scheme : colouringSchemes()) out.push_back(scheme.name);
  return out;
}

std::vector<std::string_view> ownColourNames() {
  std::vector<std::string_view> out;
  for (const NamedColour& colour : namedColours()) out.push_back(colour.name);
  return out;
}

std::vector<KeySpec> frontMatterKeys() {
  return {
      {.name = "title",
       .type = ValueType::Text,
       .meaning = "The lesson's name, as its card shows it.",
       .required = true},
      {.name = "minutes",
       .type = ValueType::Count,
       .meaning = "How many minutes the core takes a student. Left out, they are worked out from the lesson, by the "
                  "[table below](#minutes).",
       .least = 1,
       .most = 600},
      {.name = "level",
       .type = ValueType::Word,
       .meaning = "Whom the lesson is for.",
       .fallback = "beginner",
       .words = {N_("beginner"), N_("intermediate"), N_("advanced")}},
      {.name = "language",
       .type = ValueType::Text,
       .meaning = "The language that the lesson is written in, by its two letters: en, de. It chooses between files of "
                  "one lesson: first-touch.md and first-touch.de.md."},
      {.name = "goals",
       .type = ValueType::TextList,
       .meaning = "What a student can do or tell afterwards, one line each.",
       .required = true},
      {.name = "molecules",
       .type = ValueType::TextList,
       .meaning = "The molecules that the scenes use, by their names in the library.",
       .required = true},
      {.name = "author", .type = ValueType::Text, .meaning = "Who wrote the lesson.", .required = true},
      {.name = "licence",
       .type = ValueType::Text,
       .meaning = "The terms under which others may use it, for example CC-BY-4.0.",
       .required = true},
      {.name = "locked",
       .type = ValueType::WordList,
       .meaning = "What the student cannot change in menus and panels in the whole lesson, for studies: keys of the "
                  "scenes, or all of them.",
       .words = lockable()},
      {.name = "description",
       .type = ValueType::Text,
       .meaning = "One line on what the lesson is about, shown on its card."},
      {.name = "order",
       .type = ValueType::Count,
       .meaning = "The lesson's place among those on the shelf: 1 stands first. The card at the end of a lesson offers "
                  "the one that follows. Lessons without it stand behind those with it.",
       .least = 1,
       .most = 1000},
      {.name = "card",
       .type = ValueType::Count,
       .meaning =
           "The step whose scene the picture of the lesson's card shows, counted from 1 without asides; without it "
           "the first.",
       .least = 1,
       .most = 1000},
      {.name = "required",
       .type = ValueType::Word,
       .meaning = "Whether every step must be finished before the student goes on; a step may say otherwise in a block "
                  "`step`.",
       .fallback = "no",
       .words = {"yes", "no"}},
      {.name = "ask",
       .type = ValueType::Word,
       .meaning = "What the student is asked for when the lesson is opened, and may leave out: a name, or a code that "
                  "you have given. It is kept with what is done, and the report lists by it.",
       .words = {"name", "code"}},
  };
}

const KeySpec& goalKey() {
  static const KeySpec key{
      .name = "goal",
      .type = ValueType::Counts,
      .meaning =
          "Which of the lesson's goals it serves, by its number in the front matter, counted from 1; several "
          "parted by commas. The report tells by goals what was done and answered rightly.",
      .least = 1,
      .most = 100};
  return key;
}

std::vector<KeySpec> stepKeys() {
  return {{.name = "required",
           .type = ValueType::Word,
           .meaning = "Whether its tasks must be done and its questions answered before the student goes on; left out, "
                      "as the front matter says.",
           .words = {"yes", "no"}},
          {.name = "extra",
           .type = ValueType::Word,
           .meaning = "Whether the step lies beside the core, as an aside does. `Next` passes over it, and it counts "
                      "neither for the progress nor for goals. The step before it offers it, and so does the lesson's "
                      "end. The block stands above the step's scene.",
           .fallback = "no",
           .words = {"yes", "no"}},
          goalKey()};
}

std::vector<KeySpec> sceneKeys() {
  std::vector<KeySpec> out{
      {.name = "molecule",
       .type = ValueType::Text,
       .meaning = "The molecule on the stage. A scene that names one starts anew; a scene that does not changes only "
                  "what it says."}};
  for (const ReadingOption& option : readingOptions()) out.push_back(readingKey(option));
  for (KeySpec& key : touchSceneKeys()) out.push_back(std::move(key));
  const KeySpec others[]{
      {.name = "show",
       .type = ValueType::WordList,
       .meaning = "The parts of the picture that are drawn.",
       .fallback = "atoms, probe, force, target",
       .words = viewPartNames()},
      {.name = "style",
       .type = ValueType::Styles,
       .meaning =
           "How the atoms are drawn. Spheres are what is felt; a surface is drawn for the scene's probe. Several "
           "are drawn together, as in 'surface 40% for protein, spheres for ligand'. Left out, a protein of 20 "
           "residues "
           "or more is a cartoon, whose spheres appear near the probe, with what is bound, highlighted or marked as "
           "spheres; all else is spheres.",
       .words = styleNames()},
      {.name = "hide",
       .type = ValueType::Target,
       .meaning = "Atoms that are not drawn. They are felt as before. 'none' ends what an earlier scene hid.",
       .words = {"none"}},
      {.name = "untouchable",
       .type = ValueType::Target,
       .meaning = "Atoms that are not felt: the probe passes through them. They are drawn as before; with 'style' they "
                  "can be made faint. 'none' ends what an earlier scene said.",
       .words = {"none"}},
      {.name = "remove",
       .type = ValueType::Target,
       .meaning = "Atoms that are taken out of the molecule: neither drawn nor felt, and the view does not count them. "
                  "'none' brings back what an earlier scene took out.",
       .words = {"none"}},
      {.name = "in-hand",
       .type = ValueType::Target,
       .meaning = "Atoms that the hand holds as one rigid body, in the place of the probe: a ligand, brought to its "
                  "pocket. They are taken out of the molecule. Only touch tasks that judge a body can stand in such a "
                  "step; the "
                  "reference of each kind says so. 'none' puts them back.",
       .words = {"none"}},
      {.name = "near",
       .type = ValueType::Quantity,
       .meaning = "Where another style hides the spheres: atoms as near to the probe are drawn as spheres too.",
       .fallback = "4 Å",
       .dimension = Dimension::Length,
       .most = 20.0},
      {.name = "colour",
       .type = ValueType::Word,
       .meaning = "What the atoms' colours tell. In 'chain' all that is neither protein nor nucleic acid has its "
                  "elements' colours.",
       .fallback = "element",
       .words = colouringNames()},
      {.name = "panels",
       .type = ValueType::WordList,
       .meaning = "Panels beside the molecule: 'touch' shows the force, 'methods' compares the haptic methods (with "
                  "touch), 'none' leaves "
                  "the molecule and the text alone. Left out, those stay that the student has opened.",
       .words = {"touch", "methods", "none"}},
      {.name = "label",
       .type = ValueType::Marks,
       .meaning = "Names over the picture: of each atom, residue or chain selected, or one of your own in double "
                  "quotes, as in 'residue for ligand, \"the cleft\" for residue 35 52'. 'none' ends earlier ones.",
       .words = {"atom", "residue", "chain"}},
      {.name = "arrow",
       .type = ValueType::Marks,
       .meaning = "Arrows that point at atoms, each with its name, as in '\"iron\" for element Fe'. 'none' ends "
                  "earlier ones."},
      {.name = "mark",
       .type = ValueType::Marks,
       .meaning = "Atoms in colours of their own, with names for the legend, as in 'teal \"acid\" for residue 35, "
                  "magenta \"base\" for residue 52'. 'none' ends earlier ones.",
       .words = ownColourNames()},
      {.name = "distance",
       .type = ValueType::Places,
       .meaning = "Lengths that are shown, between the middles of two selections, as in 'atom 3 - atom 9'. 'none' "
                  "ends earlier ones.",
       .least = 2,
       .most = 2},
      {.name = "angle",
       .type = ValueType::Places,
       .meaning = "Angles that are shown: of three selections at the middle one, of four the torsion round the two in "
                  "the middle. 'none' ends earlier ones.",
       .least = 3,
       .most = 4},
      {.name = "hydrogen-bonds",
       .type = ValueType::Target,
       .meaning = "Hydrogen bonds that have an end in the selection, as dashed lines between their heavy atoms; 'all' "
                  "shows every one, 'none' ends earlier ones.",
       .words = {"none"}},
      {.name = "paint",
       .type = ValueType::Word,
       .meaning = "Whether atoms stay lightly painted once they have been touched.",
       .fallback = "none",
       .words = {"touched", "none"}},
      {.name = "highlight",
       .type = ValueType::Selection,
       .meaning = "Atoms that are drawn in the colour of targets. Of atoms in the hand, the place that they were taken "
                  "from: as a ghost, with a line that counts how many are back in place."},
      {.name = "view",
       .type = ValueType::View,
       .meaning = "From where the molecule is seen at first; 'side' is the front, but a long molecule whose end would "
                  "look at the student lies "
                  "across; 'facing' turns these atoms to the front, or shows the molecule along its thinnest axis "
                  "where they are nearly all that there is; 'turned' turns the molecule by angles to the right, "
                  "above and round the line of sight; 'zoom' comes close to atoms.",
       .fallback = "side",
       .words = viewWords()},
      {.name = "view NAME",
       .type = ValueType::View,
       .meaning =
           "A view to come back to, with a name of yours: 'view the cleft: facing residue 35, zoom residue 35 52'. "
           "It stands in the menu, and a link goes to it: [look](#view:the-cleft).",
       .words = viewWords(),
       .named = true},
      {.name = "cut",
       .type = ValueType::Target,
       .meaning = "Cuts the molecule open by a plane that faces the student in the scene's view: 'middle' through the "
                  "molecule's middle, or through the middle of these atoms. What is cut away is felt as before. 'none' "
                  "closes what an earlier scene opened.",
       .words = {"none", "middle"}},
      {.name = "captions",
       .type = ValueType::TextList,
       .meaning = "What stands below the two molecules of a scene with 'beside': 'wool, silk'. Left out, their names."},
      {.name = "then",
       .type = ValueType::Text,
       .meaning =
           "A second structure of the same molecule, by its name: the student moves between the two with a slider, "
           "and the atoms move while they are touched. Atoms are the same by chain, residue and name. '1ake, "
           "superposed on chain A' lays it on the first by these atoms only. 'none' ends it."},
      {.name = "states",
       .type = ValueType::TextList,
       .meaning = "What the two structures are called on the slider: 'open, closed'. Left out, by their names."},
      {.name = "state",
       .type = ValueType::Text,
       .meaning =
           "Where between the two structures the scene begins: one of 'states', or a share as '40%'. Links go there "
           "too: [closed](#state:closed).",
       .fallback = "0%"},
      {.name = "magnify",
       .type = ValueType::Target,
       .meaning = "Atoms that are to fill the room of the hand: they are felt larger, and the view comes close to "
                  "them; with 'view' they can "
                  "be turned to the front. 'none' ends what an earlier scene magnified.",
       .words = {"none"}},
      {.name = "locked",
       .type = ValueType::WordList,
       .meaning = "What the student cannot change here, besides what the front matter locks.",
       .words = lockable()},
  };
  out.insert(out.end(), std::begin(others), std::end(others));
  return out;
}

std::vector<KeySpec> touchKeys() {
  return {
      {.name = "say",
       .type = ValueType::Text,
       .meaning = "What the student is asked to do, in one sentence.",
       .required = true},
      {.name = "called",
       .type = ValueType::Text,
       .meaning =
           "What the target is called in the middle of a sentence, for example 'the oxygen atom'; without it the "
           "program makes a name from the selection."},
      {.name = "praise",
       .type = ValueType::Text,
       .meaning = "What is said when the task is done.",
       .fallback = N_("Done.")},
      goalKey(),
  };
}

std::vector<KeySpec> answerKeys() {
  return {
      {.name = "number",
       .type = ValueType::Number,
       .meaning = "The right number; with its unit if it is a physical quantity."},
      {.name = "tolerance",
       .type = ValueType::Number,
       .meaning = "How far from the right number still counts as right, in the same unit."},
      {.name = "text",
       .type = ValueType::TextList,
       .meaning = "Words that count as right, in capitals or small letters."},
      {.name = "free",
       .type = ValueType::Word,
       .meaning = "A free answer that is kept for the teacher and not judged.",
       .words = {"yes"}},
      {.name = "model",
       .type = ValueType::Text,
       .meaning =
           "Goes with `free`: an answer of the author's, which the student sees beside the own one once that is kept."},
      {.name = "right",
       .type = ValueType::Text,
       .meaning = "What is said to a right answer.",
       .fallback = N_("Right.")},
      {.name = "wrong",
       .type = ValueType::Text,
       .meaning = "What is said to a wrong answer.",
       .fallback = N_("Not yet. Try again.")},
      {.name = "attempts",
       .type = ValueType::Count,
       .meaning = "How many tries there are: after the last wrong one the right answer is shown, and the student goes "
                  "on. Left out, as many as need be.",
       .least = 1,
       .most = 20},
      {.name = "after N wrong",
       .type = ValueType::Way,
       .meaning = "Where so many wrong answers lead: 'after 2 wrong: go to #aside-what-a-crease-is'.",
       .named = true},
      {.name = "if right",
       .type = ValueType::Way,
       .meaning = "Where a right answer leads, at whichever try: 'if right: skip #once-more'."},
      {.name = "if right at first",
       .type = ValueType::Way,
       .meaning = "Where an answer that is right at the first try leads."},
      goalKey(),
  };
}

}  // namespace

const char* blockName(KeyBlock block) {
  switch (block) {
    case KeyBlock::FrontMatter:
      return NC_("block", "front matter");
    case KeyBlock::Step:
      return NC_("block", "step");
    case KeyBlock::Scene:
      return NC_("block", "scene");
    case KeyBlock::Touch:
      return NC_("block", "touch");
    case KeyBlock::Answer:
      return NC_("block", "answer");
    case KeyBlock::Facts:
      break;
  }
  return NC_("block", "facts");
}

const std::vector<KeySpec>& keysOf(KeyBlock block) {
  static const std::vector<KeySpec> tables[] = {frontMatterKeys(), stepKeys(),   sceneKeys(),
                                                touchKeys(),       answerKeys(), factKeys()};
  return tables[static_cast<int>(block)];
}

std::string AuthorsText::text() const { return own_ ? written_ : tr(written_.c_str()); }

Place selectionPlace(const Value& value) {
  const std::size_t at = value.text.rfind(value.selection.text());
  Place place = value.place;
  if (at != std::string::npos) place.column += characterCount(std::string_view(value.text).substr(0, at));
  return place;
}

const Value& KeyValues::operator[](std::string_view key) const {
  static const Value none;
  const auto found = values_.find(key);
  return found == values_.end() ? none : found->second;
}

}  // namespace moltact
