#include "engine/lesson/keys.h"

#include <iterator>
#include <utility>

#include "engine/language/catalogue.h"
#include "engine/lesson/facts.h"
#include "engine/lesson/reading_keys.h"
#include "engine/lesson/scene_movers.h"
#include "engine/lesson/touch_keys.h"
#include "engine/molecule/view_part.h"
#include "engine/structure/colouring.h"

namespace moltact {
namespace {

/// The keys of a scene that can be locked against changes by the student.
std::vector<std::string_view> lockable() {
  std::vector<std::string_view> out{"panels"};
  for (const KeySpec& k : touchSceneKeys()) out.push_back(k.name);
  out.insert(out.end(), {"show", "magnify"});
  for (const MoverKey& mover : moverKeys())
    if (mover.lockable) out.push_back(mover.key);
  out.push_back("all");
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
      {.name = "title", .type = ValueType::Text, .meaning = "The lesson's title, shown on its card.", .required = true},
      {.name = "minutes",
       .type = ValueType::Count,
       .meaning =
           "The duration of the core in minutes. By default the program estimates it by the [table below](#minutes).",
       .min = 1,
       .max = 600},
      {.name = "level",
       .type = ValueType::Word,
       .meaning = "The level of the lesson.",
       .fallback = "beginner",
       .words = {N_("beginner"), N_("intermediate"), N_("advanced")}},
      {.name = "language",
       .type = ValueType::Text,
       .meaning = "The language of the lesson as a code of two letters: en, de. The program uses it to choose between "
                  "the files of one lesson: first-touch.md and first-touch.de.md."},
      {.name = "goals",
       .type = ValueType::TextList,
       .meaning = "What a student can do or explain afterwards, one line each.",
       .required = true},
      {.name = "molecules",
       .type = ValueType::TextList,
       .meaning = "The molecules of the scenes, by their names in the library.",
       .required = true},
      {.name = "author", .type = ValueType::Text, .meaning = "The author of the lesson.", .required = true},
      {.name = "licence",
       .type = ValueType::Text,
       .meaning = "The terms under which others may use the lesson, for example CC-BY-4.0.",
       .required = true},
      {.name = "locked",
       .type = ValueType::WordList,
       .meaning = "What the student cannot change in menus and panels during the whole lesson, for studies: keys of "
                  "the scenes, or all of them.",
       .words = lockable()},
      {.name = "description",
       .type = ValueType::Text,
       .meaning = "One line about the subject of the lesson, shown on its card."},
      {.name = "order",
       .type = ValueType::Count,
       .meaning = "The lesson's position on the welcome page, from 1; lessons without one come last. The card at the "
                  "end of a lesson offers the next one.",
       .min = 1,
       .max = 1000},
      {.name = "card",
       .type = ValueType::Count,
       .meaning = "The number of the step whose scene is drawn on the lesson's card, counted from 1 without asides; by "
                  "default the first.",
       .min = 1,
       .max = 1000},
      {.name = "required",
       .type = ValueType::Word,
       .meaning =
           "Whether every step must be finished before the student continues; the block `step` of a step overrides it.",
       .fallback = "no",
       .words = {"yes", "no"}},
      {.name = "ask",
       .type = ValueType::Word,
       .meaning = "What the program asks for when the lesson is opened, unless the student skips it: a name, or a code "
                  "that you have given. Attempts store it, and the report lists students by it.",
       .words = {"name", "code"}},
      {.name = "test",
       .type = ValueType::Word,
       .meaning = "Whether the lesson is a test: answers get no verdict and no feedback, may be changed, and the last "
                  "one counts.",
       .fallback = "no",
       .words = {"yes", "no"}},
      {.name = "condition",
       .type = ValueType::Word,
       .meaning = "For studies: `look` leaves out touch and the touch tasks, `blind` the picture of the molecule. "
                  "`moltact study` writes it into the pages of the groups.",
       .fallback = "touch",
       .words = {"touch", "look", "blind"}},
      {.name = "study",
       .type = ValueType::TextList,
       .meaning = "The study's name, the part and the group to which the lesson belongs. `moltact study` writes it, "
                  "and attempts store it."},
  };
}

const KeySpec& goalKey() {
  static const KeySpec key{.name = "goal",
                           .type = ValueType::Counts,
                           .meaning =
                               "The numbers of the goals that it serves, counted from 1 in the front matter. The "
                               "report lists by goal what was done and answered correctly.",
                           .min = 1,
                           .max = 100};
  return key;
}

std::vector<KeySpec> stepKeys() {
  return {{.name = "required",
           .type = ValueType::Word,
           .meaning = "Whether its tasks must be done and its questions answered before the student continues; by "
                      "default as in the front matter.",
           .words = {"yes", "no"}},
          {.name = "extra",
           .type = ValueType::Word,
           .meaning = "Whether the step is outside the core, like an aside: `Next` skips it, and it does not count for "
                      "progress or goals. The block must precede the step's scene; the previous step and the end of "
                      "the lesson offer the step.",
           .fallback = "no",
           .words = {"yes", "no"}},
          {.name = "condition",
           .type = ValueType::WordList,
           .meaning = "For studies: the conditions of the front matter that have this step; by default all. A step "
                      "for `look` tells, for example, what the others feel.",
           .words = {"touch", "look", "blind"}},
          goalKey()};
}

std::vector<KeySpec> sceneKeys() {
  std::vector<KeySpec> out{{.name = "molecule",
                            .type = ValueType::Text,
                            .meaning = "The molecule of the scene. A scene that names one starts from the defaults; a "
                                       "scene without one changes only the keys that it contains."}};
  for (const ReadingOption& option : readingOptions()) out.push_back(readingKey(option));
  for (KeySpec& key : touchSceneKeys()) out.push_back(std::move(key));
  const KeySpec others[]{
      {.name = "show",
       .type = ValueType::WordList,
       .meaning = "The visible parts of the picture, and no others. With a mouse, 'hip' shows its depth.",
       .fallback = "atoms, probe, force, target, hip, facets",
       .words = viewPartNames()},
      {.name = "style",
       .type = ValueType::Styles,
       .meaning =
           "The drawing: spheres show what is felt, a surface is that of the scene's probe, and several combine as in "
           "'surface 40% for protein, spheres for ligand'. By default, proteins of 20 or more residues are cartoons "
           "with spheres near the probe and for highlighted or marked atoms; everything else is spheres.",
       .words = styleNames()},
      {.name = "hide",
       .type = ValueType::Target,
       .meaning = "Atoms that are not drawn but still felt. 'none' shows those hidden by an earlier scene.",
       .words = {"none"}},
      {.name = "untouchable",
       .type = ValueType::Target,
       .meaning = "Atoms that are drawn but not felt: the probe passes through them, and 'style' can make them "
                  "translucent. 'none' ends the setting of an earlier scene.",
       .words = {"none"}},
      {.name = "remove",
       .type = ValueType::Target,
       .meaning = "Atoms that are removed from the molecule: neither drawn nor felt, and ignored by the view. 'none' "
                  "restores those removed by an earlier scene.",
       .words = {"none"}},
      {.name = "in-hand",
       .type = ValueType::Target,
       .meaning = "Atoms that the hand holds as one rigid body instead of the probe, such as a ligand; they are "
                  "removed from the molecule until 'none'. Such a step may only have touch tasks that judge a body; "
                  "the section of each kind says which.",
       .words = {"none"}},
      {.name = "near",
       .type = ValueType::Quantity,
       .meaning =
           "With a style that hides the spheres: atoms within this distance of the probe are also drawn as spheres.",
       .fallback = "4 Å",
       .dimension = Dimension::Length,
       .max = 20.0},
      {.name = "colour",
       .type = ValueType::Word,
       .meaning = "What the colours of the atoms show. With 'chain', everything except proteins and nucleic acids has "
                  "the colours of its elements.",
       .fallback = "element",
       .words = colouringNames()},
      {.name = "panels",
       .type = ValueType::WordList,
       .meaning =
           "Panels beside the molecule: 'touch' shows the force, 'methods' compares the haptic methods (with "
           "touch), 'motion' the modes of an elastic molecule, 'none' leaves only molecule and text. By default the "
           "panels opened by the student remain.",
       .words = {"touch", "methods", "motion", "none"}},
      {.name = "label",
       .type = ValueType::Marks,
       .meaning = "Names in the picture: of each selected atom, residue or chain, or your own in double quotes, as in "
                  "'residue for ligand, \"the cleft\" for residue 35 52'. 'none' removes earlier ones.",
       .words = {"atom", "residue", "chain"}},
      {.name = "arrow",
       .type = ValueType::Marks,
       .meaning = "Arrows to atoms, each with a name, as in '\"iron\" for element Fe'. 'none' removes earlier ones."},
      {.name = "mark",
       .type = ValueType::Marks,
       .meaning = "Atoms in their own colours, with names for the legend, as in 'teal \"acid\" for residue 35, magenta "
                  "\"base\" for residue 52'. 'none' removes earlier ones.",
       .words = ownColourNames()},
      {.name = "distance",
       .type = ValueType::Places,
       .meaning = "Displayed distances between the centres of two selections, as in 'atom 3 - atom 9'. 'none' removes "
                  "earlier ones.",
       .min = 2,
       .max = 2},
      {.name = "angle",
       .type = ValueType::Places,
       .meaning = "Displayed angles: of three selections, at the middle one; of four, the torsion about the two middle "
                  "ones. 'none' removes earlier ones.",
       .min = 3,
       .max = 4},
      {.name = "hydrogen-bonds",
       .type = ValueType::Target,
       .meaning = "Hydrogen bonds with an end in the selection, drawn as dashed lines between their heavy atoms; 'all' "
                  "shows every one, 'none' removes earlier ones.",
       .words = {"none"}},
      {.name = "paint",
       .type = ValueType::Word,
       .meaning = "Whether touched atoms remain tinted.",
       .fallback = "none",
       .words = {"touched", "none"}},
      {.name = "highlight",
       .type = ValueType::Selection,
       .meaning = "Atoms drawn in the colour of targets. For atoms in the hand, their original position is drawn as a "
                  "ghost, with a line that counts how many are back in place."},
      {.name = "view",
       .type = ValueType::View,
       .meaning =
           "The initial view: 'side' is the front, with a long molecule across the view; 'facing' rotates atoms to the "
           "front; 'turned' rotates by angles; 'zoom' zooms to atoms. The angles are to the right, upwards and around "
           "the line of sight; if 'facing' selects nearly all atoms, the view is along the molecule's thinnest axis.",
       .fallback = "side",
       .words = viewWords()},
      {.name = "view NAME",
       .type = ValueType::View,
       .meaning = "A named view: 'view the cleft: facing residue 35, zoom residue 35 52'. The menu lists it, and links "
                  "can show it: [look](#view:the-cleft).",
       .words = viewWords(),
       .named = true},
      {.name = "cut",
       .type = ValueType::Target,
       .meaning = "Cuts the molecule open by a plane that faces the student, through its centre ('middle') or the "
                  "centre of these atoms; the removed part is still felt. 'none' closes the cut of an earlier scene.",
       .words = {"none", "middle"}},
      {.name = "captions",
       .type = ValueType::TextList,
       .meaning =
           "The captions below the two molecules of a scene with 'beside': 'wool, silk'. By default their names."},
      {.name = "then",
       .type = ValueType::Text,
       .meaning = "A second structure of the same molecule, by its name, whose atoms are matched by chain, residue and "
                  "name; a slider moves the atoms between both, also under the hand. The structures are superposed "
                  "over CA, P and C1', or with '1ake, superposed on chain A' over those of the selected atoms (all of "
                  "these if fewer than three); 'none' ends it."},
      {.name = "states",
       .type = ValueType::TextList,
       .meaning = "The names of the two structures on the slider: 'open, closed'. By default those of the molecules."},
      {.name = "state",
       .type = ValueType::Text,
       .meaning = "The initial position between the two structures: one of 'states', or a percentage such as '40%'. "
                  "Links can set it too: [closed](#state:closed).",
       .fallback = "0%"},
      {.name = "elastic",
       .type = ValueType::Word,
       .meaning = "'on' makes the molecule yield to the hand as an elastic network: springs between residues within "
                  "15 Å. The panel 'motion' shows its modes.",
       .fallback = "off",
       .words = {"on", "off"}},
      {.name = "modes",
       .type = ValueType::Text,
       .meaning =
           "The only motions in which an elastic molecule yields, by their numbers from the softest: '1, 3' of at "
           "most 20. With 'all' it yields in every way.",
       .fallback = "all"},
      {.name = "scan",
       .type = ValueType::Text,
       .meaning =
           "A tip of this radius, at most 20 Å, scans the molecule like an atomic force microscope; '10 Å, 100 pN' "
           "keeps "
           "the force constant, '0 Å' ends the scan. The scanned surface, a height picture in the view, can then be "
           "touched instead of the atoms, but not for tasks.",
       .fallback = "0 Å"},
      {.name = "simulation",
       .type = ValueType::Text,
       .meaning =
           "A serialised OpenMM system of the molecule's atoms, 'peptide.xml' beside the lesson or the molecule "
           "('moltact simulate prepare' makes it): it moves the atoms, and the hand pushes them. Or "
           "'imd://127.0.0.1:8888', a simulation in another program that speaks IMD (GROMACS, LAMMPS, NAMD); one on "
           "another computer is connected when the student presses a button; 'none' ends it."},
      {.name = "pull",
       .type = ValueType::Target,
       .meaning =
           "What the hand pulls in a simulation, by a spring: 'atom' the atom that a press touches first, "
           "'residue' its whole residue, a selection all of these atoms at their centre of mass. With 'none' the "
           "hand pushes what it touches.",
       .fallback = "none",
       .words = {"none", "atom", "residue"}},
      {.name = "temperature",
       .type = ValueType::Quantity,
       .meaning = "The temperature of the simulation's heat bath, in kelvin.",
       .fallback = "300",
       .dimension = Dimension::None,
       .min = 1.0,
       .max = 600.0},
      {.name = "trajectory",
       .type = ValueType::Text,
       .meaning = "A file with frames of the molecule's atoms (DCD, XTC, TRR, AMBER's NetCDF; models of GRO, PDB, "
                  "mmCIF) beside the lesson or the molecule, or a molecule's name; the atoms move from frame to frame, "
                  "also under the hand. Each frame is superposed over CA, P and C1', or with 'md.xtc, superposed on "
                  "chain A' over those of the selected atoms (all of these if fewer than three); 'md.xtc, not "
                  "superposed' leaves it in place; 'none' ends it."},
      {.name = "frames",
       .type = ValueType::Text,
       .meaning = "The frames of the trajectory that are shown, counted from 1: '1-100', or '50-' to the end.",
       .fallback = "1-"},
      {.name = "speed",
       .type = ValueType::Quantity,
       .meaning = "The frames of the trajectory that are shown in a second; with 0 it stands still at first.",
       .fallback = "10",
       .dimension = Dimension::None,
       .max = 100.0},
      {.name = "magnify",
       .type = ValueType::Target,
       .meaning = "Atoms that fill the workspace of the hand: they are felt larger, and the view zooms to them; 'view' "
                  "can rotate them to the front. 'none' ends the magnification of an earlier scene.",
       .words = {"none"}},
      {.name = "locked",
       .type = ValueType::WordList,
       .meaning = "What the student cannot change in this scene, in addition to the front matter.",
       .words = lockable()},
  };
  out.insert(out.end(), std::begin(others), std::end(others));
  return out;
}

std::vector<KeySpec> touchKeys() {
  return {
      {.name = "say",
       .type = ValueType::Text,
       .meaning = "The instruction for the student, in one sentence.",
       .required = true},
      {.name = "called",
       .type = ValueType::Text,
       .meaning = "The name of the target inside a sentence, for example 'the oxygen atom'; by default the program "
                  "makes one from the selection."},
      {.name = "praise",
       .type = ValueType::Text,
       .meaning = "The text shown when the task is done.",
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
       .meaning = "The largest deviation from the right number that counts as right, in the same unit."},
      {.name = "text", .type = ValueType::TextList, .meaning = "Words that count as right, in upper or lower case."},
      {.name = "free",
       .type = ValueType::Word,
       .meaning = "A free answer that is stored for the teacher and not judged.",
       .words = {"yes"}},
      {.name = "model",
       .type = ValueType::Text,
       .meaning =
           "For `free`: the author's answer, which is shown beside the student's after that has been submitted."},
      {.name = "right",
       .type = ValueType::Text,
       .meaning = "The feedback on a right answer.",
       .fallback = N_("Right.")},
      {.name = "wrong",
       .type = ValueType::Text,
       .meaning = "The feedback on a wrong answer.",
       .fallback = N_("Not yet. Try again.")},
      {.name = "attempts",
       .type = ValueType::Count,
       .meaning = "The number of tries; by default unlimited. After the last wrong one the right answer is shown, and "
                  "the student continues.",
       .min = 1,
       .max = 20},
      {.name = "after N wrong",
       .type = ValueType::Way,
       .meaning = "The effect of this many wrong answers: 'after 2 wrong: go to #aside-what-a-crease-is'.",
       .named = true},
      {.name = "if right",
       .type = ValueType::Way,
       .meaning = "The effect of a right answer at any try: 'if right: skip #once-more'."},
      {.name = "if right at first",
       .type = ValueType::Way,
       .meaning = "The effect of an answer that is right at the first try."},
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
