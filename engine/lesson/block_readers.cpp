// Reads the front matter and the fenced blocks scene and touch.
#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>

#include "engine/dynamics/simulation_engines.h"
#include "engine/haptics/field/force_choices.h"
#include "engine/haptics/interactions.h"
#include "engine/language/catalogue.h"
#include "engine/language/language_code.h"
#include "engine/lesson/reading.h"
#include "engine/lesson/reading_keys.h"
#include "engine/lesson/scene_link.h"
#include "engine/lesson/scene_movers.h"
#include "engine/lesson/scene_values.h"
#include "engine/lesson/second_state.h"
#include "engine/lesson/suggestion.h"
#include "engine/lesson/tasks/registry.h"
#include "engine/lesson/touch_keys.h"

namespace moltact::reading {
namespace {

KeyValues readBlock(Reading& reading, std::span<const KeyLine> lines, std::span<const KeySpec* const> keys,
                    const char* name, Place place) {
  std::vector<Problem> problems;
  KeyValues values = readKeyValues(lines, keys, name, place, problems);
  reading.add(std::move(problems));
  return values;
}

/// The kinds of task that have a key which this task lacks; empty if none has it.
std::string ownersOf(std::string_view key) {
  std::string owners;
  for (const TaskKind& kind : taskKinds())
    for (const KeySpec& k : kind.keys)
      if (k.name == key && k.name != kind.name) owners += (owners.empty() ? "" : ", ") + trf("'{0}'", kind.name);
  return owners.empty() ? owners : trf("that key belongs to {0}", owners);
}

std::vector<KeyLine> linesOf(Reading& reading, std::span<const BlockLine> lines) {
  std::vector<Problem> problems;
  std::vector<KeyLine> out = splitKeyLines(lines, problems);
  reading.add(std::move(problems));
  return out;
}

// A view with the name of an earlier one replaces it.
void takeViews(Reading& reading, const KeyValues& values, SceneSpec& scene) {
  constexpr std::string_view kStart = "view ";
  std::vector<std::pair<std::string_view, const Value*>> given;
  for (const auto& [key, value] : values)
    if (key.starts_with(kStart)) given.emplace_back(stripped(std::string_view(key).substr(kStart.size())), &value);
  std::sort(given.begin(), given.end(),
            [](const auto& a, const auto& b) { return a.second->place.line < b.second->place.line; });
  std::vector<std::string> here;
  for (const auto& [name, value] : given) {
    const std::string link = slug(name);
    if (link.empty() || std::find(here.begin(), here.end(), link) != here.end())
      reading.error(value->place, trf("the view '{0}' has no name of its own that a link could give", name),
                    tr("name it by words that no other view of the scene has"));
    here.push_back(link);
    const auto at =
        std::find_if(scene.views.begin(), scene.views.end(), [&](const NamedView& v) { return slug(v.name) == link; });
    if (at != scene.views.end())
      *at = {std::string(name), value->view};
    else
      scene.views.push_back({std::string(name), value->view});
  }
}

// "1ake", "1ake, superposed on chain A"; the names of the two states, and the one with which the scene begins.
void takeSecondState(Reading& reading, const KeyValues& values, bool takes_state, const Lesson& lesson,
                     SceneSpec& scene) {
  SecondState& then = scene.then;
  if (values.has("then")) {
    const Value& value = values["then"];
    Expected<SecondState> read = parseSecondState(value.text);
    then = read ? *std::move(read) : SecondState{};
    scene.places.then = value.place;
    if (!read)
      reading.error({value.place.line, value.place.column + read.problem().column - 1}, read.problem().message,
                    read.problem().remedy);
    if (!then.molecule.empty() && !scene.molecule.reading.beside.empty())
      reading.error(value.place, tr("a scene has a second structure or a molecule beside it, not both"),
                    tr("take 'then' or 'beside' out"));
    if (!then.molecule.empty()) mustBeListed(reading, lesson, then.molecule, value.place);
  }
  if (values.has("states")) {
    const Value& value = values["states"];
    then.states = value.words;
    if (then.molecule.empty())
      reading.error(value.place, tr("'states' names two structures, but the scene has one"),
                    tr("add a line 'then: …' with the second one"));
    else if (then.states.size() != 2)
      reading.error(value.place, tr("there are two states to name"), tr("write two names, as in 'open, closed'"));
  }
  if (takes_state && values["state"].place.line) {
    const Value& value = values["state"];
    const std::optional<double> share = stateNamed(scene, value.text);
    if (then.molecule.empty())
      reading.error(value.place, tr("'state' is a place between two structures, but the scene has one"),
                    tr("add a line 'then: …' with the second one"));
    else if (!share)
      reading.error(value.place, trf("'{0}' is no state of this scene", value.text),
                    tr("write one of its 'states', or a share from 0\u00a0% to 100\u00a0%"));
    else
      then.share = *share;
  }
}

// "peptide.xml", "imd://127.0.0.1:8888", "none".
void takeSimulation(Reading& reading, const KeyValues& values, bool takes, SceneSpec& scene) {
  if (takes) {
    scene.simulation = values["simulation"].text == "none" ? std::string() : values["simulation"].text;
    scene.places.simulation = values["simulation"].place;
  }
  if (scene.simulation.empty()) return;
  const Place place = scene.places.simulation;
  if (const auto address = simulationAddress(scene.simulation); address && !*address)
    reading.error(place, address->problem().message, address->problem().remedy);
}

// What the hand pulls, and the heat bath; both need a simulation.
template <class Takes>
void takeSimulationKeys(Reading& reading, const KeyValues& values, const Takes& takes, SceneSpec& scene) {
  if (takes("pull")) {
    const Value& value = values["pull"];
    const std::string_view word = value.words.empty() ? std::string_view() : std::string_view(value.words[0]);
    scene.places.pull = value.place;
    scene.pulled = value.selection;
    scene.pull = value.selection.given() ? PullBy::Selection
                 : word == "atom"        ? PullBy::Atom
                 : word == "residue"     ? PullBy::Residue
                                         : PullBy::None;
  }
  if (takes("temperature")) scene.temperature_K = values["temperature"].number;
  // What a scene continues from an earlier one ends with the simulation.
  if (scene.simulation.empty() && !values["pull"].place.line) scene.pull = PullBy::None, scene.pulled = {};
  const bool pulls = values["pull"].place.line && scene.pull != PullBy::None;
  for (const auto& [key, written] :
       {std::pair{"pull", pulls}, std::pair{"temperature", values["temperature"].place.line > 0}})
    if (written && scene.simulation.empty())
      reading.error(values[key].place, trf("'{0}' needs a simulation", key),
                    tr("add a line 'simulation: …', or leave it out"));
  if (values["temperature"].place.line && simulationAddress(scene.simulation))
    reading.error(values["temperature"].place, tr("a simulation in another program has its own heat bath"),
                  tr("leave 'temperature' out, and set it there"));
}

// A problem of a value, whose column counts within the value.
void valueError(Reading& reading, Place place, const Problem& problem) {
  place.column += problem.column ? problem.column - 1 : 0;
  reading.error(place, problem.message, problem.remedy);
}

// The modes in which an elastic molecule yields.
void takeModes(Reading& reading, const KeyValues& values, bool takes, SceneSpec& scene) {
  const Value& value = values["modes"];
  if (takes) {
    scene.elastic_modes.clear();
    if (value.place.line) scene.places.modes = value.place;
    if (auto modes = parseModes(value.text))
      scene.elastic_modes = *std::move(modes);
    else
      valueError(reading, value.place, modes.problem());
  }
  if (scene.elastic) return;
  if (value.place.line && !scene.elastic_modes.empty())
    reading.error(value.place, tr("'modes' needs an elastic molecule"),
                  tr("write 'elastic: on', or leave 'modes' out"));
  scene.elastic_modes.clear();
}

// A scan takes seconds and shows the atoms at rest.
void takeScan(Reading& reading, const KeyValues& values, bool takes, SceneSpec& scene) {
  if (takes) {
    const auto scan = parseScan(values["scan"].text);
    if (!scan) valueError(reading, values["scan"].place, scan.problem());
    scene.scan_A = scan ? scan->tip_A : 0.0;
    scene.scan_force_pN = scan ? scan->force_pN : 0.0;
    if (values["scan"].place.line) scene.places.scan = values["scan"].place;
  }
  if (!(scene.scan_A > 0.0)) return;
  for (const MoverKey* mover : moversOf(scene))
    reading.error(scene.places.scan, trf("a tip scans atoms at rest, and '{0}' moves them", mover->key),
                  trf("write 'scan: 0 Å', or leave out '{0}'", mover->key));
  if (scene.in_hand.given())
    reading.error(scene.places.scan, tr("a scanned surface is touched with a point, and the hand holds a body"),
                  tr("write 'scan: 0 Å', or leave out 'in-hand'"));
}

// "1-100", "50-", "7".
bool parseFrames(std::string_view text, TrajectorySpec& out) {
  const auto number = [](std::string_view word, std::uint32_t& value) {
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc{} && end == word.data() + word.size() && value > 0;
  };
  const std::size_t dash = text.find('-');
  if (!number(stripped(text.substr(0, dash)), out.first)) return false;
  out.last = dash == std::string_view::npos ? out.first : 0;
  if (dash == std::string_view::npos || stripped(text.substr(dash + 1)).empty()) return true;
  return number(stripped(text.substr(dash + 1)), out.last) && out.last >= out.first;
}

// "md.xtc", "md.xtc, superposed on chain A", "none", with its frames and speed.
template <class Takes>
void takeTrajectory(Reading& reading, const KeyValues& values, const Takes& takes, SceneSpec& scene) {
  TrajectorySpec& trajectory = scene.trajectory;
  if (takes("trajectory")) {
    const Value& value = values["trajectory"];
    scene.places.trajectory = value.place;
    trajectory = {};
    if (auto parsed = parseTrajectory(value.text); parsed) {
      trajectory = *std::move(parsed);
    } else {
      valueError(reading, value.place, parsed.problem());
    }
  }
  for (const char* key : {"frames", "speed"})
    if (takes(key) && values[key].place.line && trajectory.file.empty())
      reading.error(values[key].place, trf("'{0}' needs a trajectory", key),
                    tr("add a line 'trajectory: …', or leave it out"));
  if (takes("frames") && values["frames"].place.line && !parseFrames(values["frames"].text, trajectory))
    reading.error(values["frames"].place, trf("these are no frames: '{0}'", values["frames"].text),
                  tr("write the first and the last, counted from 1: '1-100'"));
  if (takes("speed")) trajectory.frames_per_s = values["speed"].number;
}

// Whatever moves the atoms excludes all else that does, and forces, which act between atoms at rest.
void checkMovers(Reading& reading, const KeyValues& values, const SceneSpec& scene) {
  const auto later = [](const Place& a, const Place& b) { return a.line > b.line ? a : b; };
  const MoverKey* first = nullptr;
  for (const MoverKey* mover : moversOf(scene)) {
    const Place& place = scene.places.*mover->place;
    if (first)
      reading.error(later(scene.places.*first->place, place),
                    trf("'{0}' and '{1}' both move the atoms", first->key, mover->key),
                    trf("{0}, or {1}", tr(first->without), tr(mover->without)));
    else
      first = mover;
    if (forceChoice(scene.touch.forces).any())
      reading.error(later(place, values["forces"].place),
                    trf("forces act between atoms that rest, and '{0}' moves them", mover->key),
                    trf("write 'forces: none', or {0}", tr(mover->without)));
  }
}

// The captions of two molecules that are compared.
void takeCaptions(Reading& reading, const Value& value, SceneSpec& scene) {
  scene.captions = value.words;
  if (scene.molecule.reading.beside.empty())
    reading.error(value.place, tr("'captions' names two molecules, but the scene has one"),
                  tr("add a line 'beside: …' with the second one"));
  else if (scene.captions.size() != 2)
    reading.error(value.place, tr("there are two molecules to name"), tr("write two names, as in 'wool, silk'"));
}

// The names, markers and measurements of a scene; "none" removes those of an earlier scene.
template <class Takes>
void readMarks(const KeyValues& values, const Takes& takes, SceneSpec& scene) {
  if (takes("label")) scene.labels = values["label"].marks;
  if (takes("arrow")) scene.arrows = values["arrow"].marks;
  if (takes("mark")) scene.marks = values["mark"].marks;
  if (takes("hydrogen-bonds")) {
    scene.hydrogen_bonds = values["hydrogen-bonds"].selection;
    scene.places.hydrogen_bonds = values["hydrogen-bonds"].place;
  }
  for (const auto& [key, angles] : {std::pair{"distance", false}, std::pair{"angle", true}}) {
    if (!takes(key)) continue;
    std::erase_if(scene.measures,
                  [of_angles = angles](const PlacesSpec& m) { return (m.atoms.size() > 2) == of_angles; });
    const std::vector<PlacesSpec>& wanted = values[key].measures;
    scene.measures.insert(scene.measures.end(), wanted.begin(), wanted.end());
  }
  if (takes("paint")) scene.paint_touched = values["paint"].words[0] == "touched";
}

}  // namespace

void mustBeListed(Reading& reading, const Lesson& lesson, const std::string& name, Place place) {
  const std::vector<std::string_view> known(lesson.molecules.begin(), lesson.molecules.end());
  if (known.empty() || reading.enough() || std::find(known.begin(), known.end(), name) != known.end()) return;
  // '1hel.pdb' of an author who means the library's.
  const std::string_view stem = std::string_view(name).substr(0, name.find('.'));
  const bool meant = std::find(known.begin(), known.end(), stem) != known.end();
  reading.error(
      place, trf("'{0}' is not among the lesson's molecules", name),
      meant ? trf("write '{0}'", stem) : suggest(name, known, tr("add it to the front matter or take one of")));
}

std::size_t readFrontMatter(Reading& reading, Lesson& lesson) {
  const SourceText& source = reading.source;
  const std::string remedy = tr("begin the file with '---', 'title: …' and the other keys, and '---'");
  if (stripped(source.line(1)) != "---") {
    reading.error({1, 1}, tr("the lesson has no front matter"), remedy);
    return 0;
  }
  std::vector<BlockLine> lines;
  std::size_t end = 2;
  // A step or a block means that the closing line was forgotten; the lesson continues there.
  const auto endsFrame = [](std::string_view line) { return line.starts_with("## ") || line.starts_with("```"); };
  while (end <= source.lineCount() && stripped(source.line(end)) != "---" && !endsFrame(source.line(end))) {
    lines.push_back({std::string(source.line(end)), {end, 1}});
    ++end;
  }
  const bool forgotten = end > source.lineCount() || endsFrame(source.line(end));
  if (forgotten) {
    reading.error({1, 1}, tr("the front matter has no end"), tr("close it with a line '---'"));
    if (end > source.lineCount()) return source.bytes().size();
    // Prose between the front matter and the first step is not a list of keys.
    const auto prose =
        std::find_if(lines.begin(), lines.end(), [](const BlockLine& l) { return stripped(l.text).empty(); });
    lines.erase(prose, lines.end());
    --end;
  }
  const auto keys = pointersTo(keysOf(KeyBlock::FrontMatter));
  const KeyValues values = readBlock(reading, linesOf(reading, lines), keys, blockName(KeyBlock::FrontMatter), {1, 1});
  lesson.title = values["title"].text;
  lesson.level = values["level"].text;
  lesson.author = values["author"].text;
  lesson.licence = values["licence"].text;
  lesson.language = values["language"].text;
  lesson.language_place = values["language"].place;
  if (!lesson.language.empty() && !isLanguageCode(lesson.language))
    reading.error(lesson.language_place, trf("'{0}' is no language's code", lesson.language),
                  tr("write its two letters: en, de"));
  lesson.minutes = static_cast<int>(values["minutes"].number);
  lesson.minutes_place = values["minutes"].place;
  lesson.description = values["description"].text;
  lesson.order = static_cast<int>(values["order"].number);
  if (values.has("card")) lesson.card = static_cast<int>(values["card"].number);
  lesson.card_place = values["card"].place;
  lesson.required = values["required"].text == "yes";
  lesson.goals = values["goals"].words;
  lesson.molecules = values["molecules"].words;
  lesson.molecule_places = values["molecules"].places;
  lesson.locked = values["locked"].words;
  lesson.ask = values["ask"].text;
  lesson.test = values["test"].text == "yes";
  if (const auto condition = conditionNamed(values["condition"].text)) lesson.condition = *condition;
  if (const Value& study = values["study"]; !study.words.empty()) {
    if (study.words.size() < 2 || study.words.size() > 3)
      reading.error(study.place, tr("'study' needs a name, a part and a group"),
                    tr("take the line out; 'moltact study' writes it"));
    else
      lesson.study = {study.words[0], study.words[1], study.words.size() > 2 ? study.words[2] : ""};
  }
  // A goal is a sentence and may contain commas; only "- " lines separate goals.
  if (!values["goals"].text.empty()) lesson.goals = {values["goals"].text};
  return end < source.lineCount() ? source.lineStart(end + 1) : source.bytes().size();
}

SceneSpec readScene(Reading& reading, const MarkdownBlock& block, const SceneSpec* before, const Lesson& lesson) {
  const std::vector<KeyLine> lines = linesOf(reading, block.lines);
  const auto keys = pointersTo(keysOf(KeyBlock::Scene));
  const KeyValues values = readBlock(reading, lines, keys, blockName(KeyBlock::Scene), block.place);
  const bool anew = values.has("molecule") || !before;
  // Only values written by the author have a position; defaults apply only in a scene that starts anew.
  const auto takes = [&](std::string_view key) { return values.has(key) && (anew || values[key].place.line); };

  SceneSpec scene = anew ? SceneSpec{} : *before;
  scene.places.scene = block.place;
  if (anew) scene.locked = lesson.locked;
  if (values.has("molecule")) {
    scene.molecule.name = values["molecule"].text;
    scene.places.molecule = values["molecule"].place;
    mustBeListed(reading, lesson, scene.molecule.name, scene.places.molecule);
  } else if (!before &&
             std::none_of(lines.begin(), lines.end(), [](const KeyLine& l) { return l.key == "molecule"; })) {
    reading.error(block.place, tr("the lesson's first scene needs the key 'molecule'"), tr("add a line 'molecule: …'"));
  }
  for (const ReadingOption& option : readingOptions()) {
    const Value& value = values[option.name];
    if (takes(option.name)) readValue(scene.molecule.reading, option, value);
    if (value.place.line > scene.places.reading.line) scene.places.reading = value.place;
  }
  if (const std::string& beside = scene.molecule.reading.beside; !beside.empty() && values["beside"].place.line)
    mustBeListed(reading, lesson, beside, values["beside"].place);
  if (takes("captions")) takeCaptions(reading, values["captions"], scene);
  for (const TouchProperty& property : touchProperties())
    if (takes(property.key)) setTouchValue(scene.touch, property, touchValueOf(property, values[property.key]));
  if (takes("charges")) scene.places.charges = values["charges"].place;
  if (takes("show")) scene.show = values["show"].words;
  if (takes("style")) scene.styles = values["style"].styles;
  const auto takeAtoms = [&](std::string_view key, Selection& atoms, Place& place) {
    if (!takes(key)) return;
    atoms = values[key].selection;
    place = values[key].place;
  };
  takeAtoms("hide", scene.hide, scene.places.hide);
  takeAtoms("untouchable", scene.untouchable, scene.places.untouchable);
  takeAtoms("remove", scene.remove, scene.places.remove);
  takeAtoms("in-hand", scene.in_hand, scene.places.in_hand);
  if (takes("hand") && !scene.in_hand.given() && findInteractionKind(scene.touch.interaction)->holds_body)
    reading.error(values["hand"].place, trf("the hand holds no body, which '{0}' needs", scene.touch.interaction),
                  tr("take atoms into the hand by 'in-hand: …', or leave 'hand' out"));
  scene.touch = resolveInteraction(scene.touch, scene.in_hand.given());
  if (takes("near")) scene.near_A = values["near"].number;
  if (takes("colour")) scene.colour = values["colour"].words[0];
  readMarks(values, takes, scene);
  if (takes("panels")) {
    scene.panels = values["panels"].words;
    if (scene.panels.size() > 1 && std::find(scene.panels.begin(), scene.panels.end(), "none") != scene.panels.end())
      reading.error(values["panels"].place, tr("'none' stands alone"), tr("take it out, or the other panels"));
  }
  if (takes("locked")) {
    scene.locked = lesson.locked;
    scene.locked.insert(scene.locked.end(), values["locked"].words.begin(), values["locked"].words.end());
  }
  takeAtoms("highlight", scene.highlight, scene.places.highlight);
  takeAtoms("magnify", scene.magnify, scene.places.magnify);
  if (takes("view")) scene.view = values["view"].view;
  takeViews(reading, values, scene);
  if (takes("cut")) scene.cut = values["cut"].words.empty() || values["cut"].words[0] != "none";
  takeAtoms("cut", scene.cut_at, scene.places.cut);
  takeSecondState(reading, values, takes("state"), lesson, scene);
  if (takes("elastic")) {
    scene.elastic = values["elastic"].words[0] == "on";
    scene.places.elastic = values["elastic"].place;
  }
  takeModes(reading, values, takes("modes"), scene);
  takeSimulation(reading, values, takes("simulation"), scene);
  takeSimulationKeys(reading, values, takes, scene);
  takeTrajectory(reading, values, takes, scene);
  checkMovers(reading, values, scene);
  takeScan(reading, values, takes("scan"), scene);
  return scene;
}

TaskSpec readTouch(Reading& reading, const MarkdownBlock& block, const Lesson& lesson) {
  const std::vector<KeyLine> lines = linesOf(reading, block.lines);
  TaskSpec task;
  task.place = block.place;
  const TaskKind* kind = nullptr;
  for (const KeyLine& line : lines) {
    const TaskKind* found = findTaskKind(line.key);
    if (!found) continue;
    if (kind && kind != found) {
      reading.error(line.key_place,
                    trf("a touch block holds one task, but this one has '{0}' and '{1}'", kind->name, found->name),
                    tr("write two touch blocks"));
      return {};
    }
    kind = found;
  }

  std::vector<const KeySpec*> keys;
  const std::vector<KeySpec>& common = keysOf(KeyBlock::Touch);
  if (kind) {
    for (const KeySpec& k : kind->keys) keys.push_back(&k);
    for (const KeySpec& k : common) keys.push_back(&k);
    std::vector<Problem> problems;
    task.values = readKeyValues(lines, keys, blockName(KeyBlock::Touch), block.place, problems, &ownersOf);
    const bool good = problems.empty();
    if (good && kind->check) kind->check({std::string(kind->name), task.values, task.place, {}}, problems);
    // Stored despite errors: the lesson is not usable then, but further checks can report more.
    task.kind = kind->name;
    reading.add(std::move(problems));
    task.goals = readGoals(reading, task.values["goal"], lesson);
    return task;
  }

  // Without a kind, a misspelt kind is the likeliest cause. Each unknown key is reported, with the kinds among the
  // suggestions.
  std::vector<std::string_view> names;
  for (const TaskKind& k : taskKinds()) names.push_back(k.name);
  const std::vector<std::string_view> kinds = names;
  for (const KeySpec& k : common) names.push_back(k.name);
  for (const TaskKind& k : taskKinds())
    for (const KeySpec& key : k.keys)
      if (std::find(names.begin(), names.end(), key.name) == names.end()) names.push_back(key.name);
  bool reported = false;
  for (const KeyLine& line : lines)
    if (std::find(names.begin(), names.end(), line.key) == names.end()) {
      reading.error(line.key_place, trf("{0} has no key '{1}'", trc("block", blockName(KeyBlock::Touch)), line.key),
                    suggest(line.key, reported ? names : kinds, tr("tasks")));
      reported = true;
    }
  if (!reported)
    reading.error(block.place, tr("the touch block names no task"),
                  trf("add a line that starts with {0} and a colon", joined(kinds, tr(" or "))));
  return {};
}

}  // namespace moltact::reading
