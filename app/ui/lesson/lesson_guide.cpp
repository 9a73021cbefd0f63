#include "app/ui/lesson/lesson_guide.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <set>

#include "app/ui/lesson/scene_marks.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/glossary.h"
#include "engine/lesson/lesson_files.h"
#include "engine/lesson/lesson_molecules.h"
#include "engine/lesson/lesson_region.h"
#include "engine/lesson/reader.h"
#include "engine/lesson/scene_atoms.h"
#include "engine/render/cartoon.h"
#include "engine/render/molecule_model.h"

namespace moltact {
namespace {

PointA middleOf(const std::vector<std::uint32_t>& atoms, const Molecule& molecule) {
  PointA middle;
  for (const std::uint32_t a : atoms) middle.A += molecule.spheres[a].centre_A / double(atoms.size());
  return middle;
}

PointA middleOf(const Molecule& molecule) {
  PointA middle;
  for (const Sphere& a : molecule.spheres) middle.A += a.centre_A / double(molecule.atoms.size());
  return middle;
}

// A lesson's protein is drawn as a cartoon unless the scene says otherwise: it shows the fold, and the spheres that are
// felt appear near the probe. Ligands and highlighted or marked atoms are drawn as spheres.
std::vector<StyledAtoms> usualStyles(const SceneSpec& scene, const Molecule& molecule) {
  constexpr std::ptrdiff_t kProtein_residues = 20;
  const auto isAminoAcid = [](const Residue& r) { return r.kind == ResidueKind::AminoAcid; };
  if (scene.molecule.name.empty() ||
      std::count_if(molecule.residues.begin(), molecule.residues.end(), isAminoAcid) < kProtein_residues)
    return {};
  std::vector<bool> sphere(molecule.atoms.size());
  std::vector<std::uint32_t> ribbons, spheres;
  const auto take = [&](const Selection& atoms) {
    if (atoms.given())
      for (const std::uint32_t a : atoms.select(molecule)) sphere[a] = true;
  };
  take(scene.highlight);
  for (const MarkSpec& mark : scene.marks) take(mark.atoms);
  for (std::uint32_t a = 0; a < molecule.atoms.size(); ++a) {
    const std::uint32_t residue = molecule.atoms[a].residue;
    const ResidueKind kind = residue == kNoResidue ? ResidueKind::Other : molecule.residues[residue].kind;
    const bool polymer = kind == ResidueKind::AminoAcid || kind == ResidueKind::Nucleotide;
    if (polymer) ribbons.push_back(a);
    if (!polymer || sphere[a]) spheres.push_back(a);
  }
  const auto listOf = [](std::vector<std::uint32_t> atoms) {
    return std::make_shared<const std::vector<std::uint32_t>>(std::move(atoms));
  };
  std::vector<StyledAtoms> styles{{.style = DrawStyle::Cartoon, .atoms = listOf(std::move(ribbons))}};
  if (!spheres.empty()) styles.push_back({.style = DrawStyle::Spheres, .atoms = listOf(std::move(spheres))});
  return styles;
}

// The language of a lesson: from its front matter or its file name; English if a file without a language has
// translations beside it. Empty if unknown.
std::string languageOf(const Lesson& lesson, const std::filesystem::path& file) {
  if (!lesson.language.empty()) return lesson.language;
  const LessonName name = lessonName(file);
  if (!name.language.empty()) return name.language;
  std::error_code error;
  for (const auto& beside : std::filesystem::directory_iterator(file.parent_path(), error))
    if (const LessonName other = lessonName(beside.path());
        beside.path().extension() == ".md" && other.id == name.id && !other.language.empty())
      return "en";
  return {};
}

// The program's sentences must not contain words of an author in another language: targets get the program's names.
void keepSentencesWhole(Lesson& lesson, const std::filesystem::path& file) {
  const std::string its = languageOf(lesson, file);
  if (its.empty() || its == language()) return;
  for (Step& step : lesson.steps)
    for (TaskSpec& task : step.tasks) {
      KeyValues kept;
      for (const auto& [key, value] : task.values)
        if (key != "called" && key != "arrival") kept.set(key, value);
      task.values = std::move(kept);
    }
}

// A cartoon shows no single atoms. Highlighted atoms and marks of a few residues are drawn as the spheres that are
// felt, so that a ring or a colour surrounds something.
void showMarkedInRibbons(const SceneSpec& scene, const Molecule& molecule, std::vector<StyledAtoms>& styles) {
  constexpr std::size_t kFew_residues = 8;
  std::vector<bool> in_ribbon(molecule.atoms.size()), itself(molecule.atoms.size());
  std::size_t ribbon_residues = 0;
  for (const StyledAtoms& s : styles) {
    const bool ribbons = s.style == DrawStyle::Cartoon;
    const auto take = [&](std::uint32_t a) {
      const std::uint32_t r = molecule.atoms[a].residue;
      (ribbons && r != kNoResidue && inCartoon(molecule.residues[r]) ? in_ribbon : itself)[a] = true;
    };
    if (s.atoms)
      for (const std::uint32_t a : *s.atoms) take(a);
    else
      for (std::uint32_t a = 0; a < molecule.atoms.size(); ++a) take(a);
  }
  for (const Residue& r : molecule.residues) ribbon_residues += r.atom_count > 0 && in_ribbon[r.first_atom];
  if (ribbon_residues == 0) return;
  std::set<std::uint32_t> shown;
  const auto show = [&](const Selection& selection, std::size_t most_residues) {
    if (!selection.given()) return;
    std::set<std::uint32_t> atoms, residues;
    for (const std::uint32_t a : selection.select(molecule))
      if (in_ribbon[a] && !itself[a]) atoms.insert(a), residues.insert(molecule.atoms[a].residue);
    if (residues.size() <= most_residues) shown.insert(atoms.begin(), atoms.end());
  };
  show(scene.highlight, ribbon_residues / 3);  // for more residues the coloured ribbon itself suffices
  for (const MarkSpec& mark : scene.marks) show(mark.atoms, kFew_residues);
  if (shown.empty()) return;
  styles.push_back({.style = DrawStyle::Spheres,
                    .atoms = std::make_shared<const std::vector<std::uint32_t>>(shown.begin(), shown.end())});
}

}  // namespace

AtomsLook looksOf(const SceneSpec& scene, const Molecule& molecule, bool later) {
  const auto listOf = [&](const Selection& atoms) -> AtomList {
    return atoms.given() ? std::make_shared<const std::vector<std::uint32_t>>(atoms.select(molecule)) : nullptr;
  };
  AtomsLook looks;
  for (const StyleSpec& s : scene.styles) looks.styles.push_back({s.style, listOf(s.atoms), float(s.opacity)});
  if (scene.styles.empty()) looks.styles = usualStyles(scene, molecule);
  showMarkedInRibbons(scene, molecule, looks.styles);
  if (std::vector<std::uint32_t> hidden = hiddenAtoms(scene, molecule); !hidden.empty())
    looks.hidden = std::make_shared<const std::vector<std::uint32_t>>(std::move(hidden));
  looks.spheres_near_A = scene.near_A;
  looks.colouring = schemeColouring(
      molecule, scene.colour,
      {.dielectric = scene.touch.dielectric, .held = untouchableAtoms(scene, molecule), .later = later});
  looks.marks = marksOf(scene, molecule);
  return looks;
}

ColourBy colourBy(const SceneSpec& scene) { return scene.colour == "chain" ? ColourBy::Chain : ColourBy::Element; }

bool LessonGuide::open(const std::filesystem::path& file) {
  LessonReading reading = readLesson(file);
  if (!reading.lesson) return false;
  linkWords(*reading.lesson, glossaryBeside(file, reading.lesson->language));
  keepSentencesWhole(*reading.lesson, file);
  session_ = std::make_unique<LessonSession>(std::make_shared<const Lesson>(*std::move(reading.lesson)));
  file_ = file;
  scene_changed_ = true;
  closing_ = false;
  ++openings_;
  return true;
}

void LessonGuide::replace(Lesson lesson) {
  if (!session_) return;
  const SceneSpec scene = session_->scene();
  const std::string step = session_->step().id;
  const bool seen = !scene_changed_ && session_->sceneNumber() == scene_seen_;
  const bool kept_drafts = drafts_opening_ == openings_;
  linkWords(lesson, glossaryBeside(file_, lesson.language));
  keepSentencesWhole(lesson, file_);
  session_->replaceLesson(std::make_shared<const Lesson>(std::move(lesson)));
  ++openings_;
  if (kept_drafts && session_->step().id == step) drafts_opening_ = openings_;
  if (seen && scene == session_->scene()) scene_seen_ = session_->sceneNumber();
}

void LessonGuide::next() {
  if (atLastStep())
    closing_ = true;
  else if (session_)
    session_->next();
}

void LessonGuide::back() {
  if (closing())
    closing_ = false;
  else if (session_)
    session_->back();
}

bool LessonGuide::follow(const std::string& link) {
  if (!session_ || !link.starts_with('#')) return false;
  if (!session_->mayGoTo(link)) return true;
  if (!session_->goTo(link)) return false;
  closing_ = false;
  return true;
}

AnswerDrafts& LessonGuide::drafts() {
  const std::size_t step = session_ ? session_->stepIndex() : 0;
  if (drafts_opening_ != openings_ || drafts_step_ != step) drafts_ = {};
  drafts_opening_ = openings_;
  drafts_step_ = step;
  return drafts_;
}

const SceneSpec* LessonGuide::takeNewScene() {
  if (!session_ || (!scene_changed_ && session_->sceneNumber() == scene_seen_)) return nullptr;
  scene_changed_ = false;
  scene_seen_ = session_->sceneNumber();
  return &session_->scene();
}

Expected<MoleculeKey> LessonGuide::molecule() const {
  if (!session_) return Problem{{}, 0, 0, tr("no lesson is open"), {}};
  return moleculeOf(session_->scene(), file_);
}

Expected<MoleculeKey> moleculeOf(const SceneSpec& scene, const std::filesystem::path& lesson) {
  Expected<MoleculeKey> known = lessonMolecule(lesson, scene.molecule);
  if (known) return known;
  Problem problem = known.problem();
  const Place place = scene.places.molecule;
  return Problem{lesson.string(), place.line, place.column, problem.message, problem.remedy};
}

void LessonGuide::setMolecule(std::shared_ptr<const Molecule> molecule, const MoleculeKey& key) {
  highlighted_.clear();
  untouchable_.clear();
  held_.clear();
  region_.reset();
  zoomed_.reset();
  looks_ = {};
  looks_.spheres_near_A = SceneSpec().near_A;
  annotations_ = nullptr;
  on_stage_ = false;
  if (!session_) return;
  const Expected<MoleculeKey> wanted = this->molecule();
  on_stage_ = wanted && *wanted == key;
  if (on_stage_ && session_->scene().highlight.given()) highlighted_ = session_->scene().highlight.select(*molecule);
  if (on_stage_) looks_ = looksOf(session_->scene(), *molecule, true);
  if (on_stage_) untouchable_ = untouchableAtoms(session_->scene(), *molecule);
  if (on_stage_) held_ = heldAtoms(session_->scene(), *molecule);
  if (on_stage_) annotations_ = annotationsOf(session_->scene(), *molecule);
  annotated_ = molecule;
  if (on_stage_) region_ = magnifiedRegion(session_->scene(), *molecule);
  if (on_stage_)
    zoomed_ = zoomedRegion(session_->scene().view, session_->scene(), *molecule, session_->scene().touch.probe_A);
  session_->setMolecule(on_stage_ ? std::move(molecule) : nullptr);
}

void LessonGuide::beginFrom(std::shared_ptr<const Molecule> molecule) {
  if (on_stage_) session_->setMolecule(std::move(molecule));
}

void LessonGuide::feed(const ServoSample& s, std::string_view method, const Contact& exact, bool hovering) {
  if (!on_stage_ || !s.has_interaction) return;
  TouchSample sample = touchSampleOf(s, method, exact);
  sample.hovering = hovering;
  session_->feed(sample);
}

ViewPartSet LessonGuide::shownParts() const {
  ViewPartSet shown;
  if (session_ && !session_->scene().show.empty()) {
    for (const std::string& name : session_->scene().show)
      for (const ViewPartInfo& part : viewParts())
        if (part.name == name) shown.set(part.part);
    return shown;
  }
  shown = defaultViewParts();
  shown.set(ViewPart::Facets);  // visible only with a method that uses triangles
  shown.set(ViewPart::Hip);     // the HIP's depth below the surface replaces the force, which a mouse cannot give
  return shown;
}

void LessonGuide::face(Camera& camera, const Molecule& molecule) const {
  const SceneSpec scene = on_stage_ ? session_->scene() : SceneSpec();
  faceView(camera, molecule, scene.view, scene);
}

void LessonGuide::cutFor(const Camera& camera, const Molecule& molecule) {
  looks_.cut = on_stage_ ? cutOf(session_->scene(), molecule, camera) : std::nullopt;
}

std::optional<CutPlane> cutOf(const SceneSpec& scene, const Molecule& molecule, const Camera& camera) {
  if (!scene.cut) return std::nullopt;
  std::vector<std::uint32_t> atoms;
  if (scene.cut_at.given()) atoms = presentAtoms(scene.cut_at, scene, molecule);
  const PointA through = atoms.empty() ? middleOf(molecule) : middleOf(atoms, molecule);
  return CutPlane{camera.back(), glm::dot(camera.back(), through.A)};
}

void faceView(Camera& camera, const Molecule& molecule, const ViewSpec& view, const SceneSpec& scene) {
  if (view.facing.given()) {
    const std::vector<std::uint32_t> atoms = presentAtoms(view.facing, scene, molecule);
    if (nearlyAllPresent(atoms, scene, molecule)) {
      std::vector<Vec3> places_A;
      for (const std::uint32_t a : atoms) places_A.push_back(molecule.spheres[a].centre_A);
      camera.lookAlongThinnest(places_A);
    } else if (!atoms.empty()) {
      camera.face(middleOf(atoms, molecule));
    }
    return;
  }
  if (view.turned_deg) {
    const auto [right, above, round] = *view.turned_deg;
    constexpr double kRadian = std::numbers::pi / 180.0;
    camera.lookFrom(right * kRadian, above * kRadian);
    camera.roll(round * kRadian);
    return;
  }
  constexpr double kQuarter = 0.5 * std::numbers::pi;
  // Two molecules side by side are viewed so that both are visible.
  if (view.side == "side" && molecule.beside_from > 0)
    camera.lookFrom(0, 0);
  else if (view.side == "side")
    camera.lookSideOn(molecule);
  else if (view.side == "back")
    camera.lookFrom(2 * kQuarter, 0);
  else if (view.side == "left")
    camera.lookFrom(-kQuarter, 0);
  else if (view.side == "right")
    camera.lookFrom(kQuarter, 0);
  else if (view.side == "top")
    camera.lookFrom(0, kQuarter);
  else if (view.side == "bottom")
    camera.lookFrom(0, -kQuarter);
}

std::string viewText(const Camera& camera) {
  const Vec3 back = camera.back();
  const double right = std::atan2(back.x, back.z), above = std::asin(std::clamp(back.y, -1.0, 1.0));
  Camera upright;
  upright.lookFrom(right, above);
  const glm::dquat rest = glm::conjugate(upright.orientation) * camera.orientation;
  std::string out = "turned";
  for (const double angle : {right, above, -2.0 * std::atan2(rest.z, rest.w)}) {
    const double degrees = std::remainder(std::round(angle * 1800.0 / std::numbers::pi) / 10.0, 360.0);
    char text[32];
    std::snprintf(text, sizeof text, " %g", degrees == 0.0 ? 0.0 : degrees);
    out += text;
  }
  return out;
}

void LessonGuide::decorate(ViewScene& scene) const {
  if (!on_stage_) return;
  scene.highlighted = highlighted_;
  // The answer of a task whose tries are used up.
  if (const std::vector<std::uint32_t> shown = session_->shownAtoms(); !shown.empty()) scene.highlighted = shown;
  // Hidden atoms are not marked. The place of held atoms, which are hidden there, is marked.
  if (looks_.hidden)
    std::erase_if(scene.highlighted, [&](std::uint32_t a) {
      return std::binary_search(looks_.hidden->begin(), looks_.hidden->end(), a) &&
             !std::binary_search(held_.begin(), held_.end(), a);
    });
  // The annotations follow atoms that have moved.
  if (annotations_ && scene.molecule && scene.molecule != annotated_) {
    annotations_ = annotationsOf(session_->scene(), *scene.molecule);
    annotated_ = scene.molecule;
  }
  if (annotations_) scene.annotations.push_back(annotations_);
}

}  // namespace moltact
