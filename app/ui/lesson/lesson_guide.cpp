#include "app/ui/lesson/lesson_guide.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "app/ui/lesson/scene_marks.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/lesson_molecules.h"
#include "engine/lesson/lesson_region.h"
#include "engine/lesson/reader.h"
#include "engine/render/molecule_model.h"

namespace moltact {

AtomsLook looksOf(const SceneSpec& scene, const Molecule& molecule) {
  const auto listOf = [&](const Selection& atoms) -> AtomList {
    return atoms.given() ? std::make_shared<const std::vector<std::uint32_t>>(atoms.select(molecule)) : nullptr;
  };
  AtomsLook looks;
  for (const StyleSpec& s : scene.styles) looks.styles.push_back({s.style, listOf(s.atoms), float(s.opacity)});
  looks.hidden = listOf(scene.hide);
  looks.spheres_near_A = scene.near_A;
  looks.colouring = schemeColouring(molecule, scene.colour);
  looks.marks = marksOf(scene, molecule);
  return looks;
}

ColourBy colourBy(const SceneSpec& scene) { return scene.colour == "chain" ? ColourBy::Chain : ColourBy::Element; }

bool LessonGuide::open(const std::filesystem::path& file) {
  LessonReading reading = readLesson(file);
  if (!reading.lesson) return false;
  session_ = std::make_unique<LessonSession>(std::make_shared<const Lesson>(*std::move(reading.lesson)));
  file_ = file;
  scene_changed_ = true;
  ++openings_;
  return true;
}

void LessonGuide::replace(Lesson lesson) {
  if (!session_) return;
  const SceneSpec scene = session_->scene();
  const std::string step = session_->step().id;
  const bool seen = !scene_changed_ && session_->sceneNumber() == scene_seen_;
  const bool kept_drafts = drafts_opening_ == openings_;
  session_->replaceLesson(std::make_shared<const Lesson>(std::move(lesson)));
  ++openings_;
  if (kept_drafts && session_->step().id == step) drafts_opening_ = openings_;
  if (seen && scene == session_->scene()) scene_seen_ = session_->sceneNumber();
}

void LessonGuide::next() {
  if (session_) session_->next();
}

void LessonGuide::back() {
  if (session_) session_->back();
}

bool LessonGuide::follow(const std::string& link) { return session_ && link.starts_with('#') && session_->goTo(link); }

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

void LessonGuide::meet(std::shared_ptr<const Molecule> molecule, const MoleculeKey& key) {
  highlighted_.clear();
  region_.reset();
  looks_ = {.styles = {},
            .hidden = nullptr,
            .spheres_near_A = SceneSpec().near_A,
            .cut = std::nullopt,
            .marks = nullptr,
            .colouring = nullptr};
  annotations_ = nullptr;
  on_stage_ = false;
  if (!session_) return;
  const Expected<MoleculeKey> wanted = this->molecule();
  on_stage_ = wanted && *wanted == key;
  if (on_stage_ && session_->scene().highlight.given()) highlighted_ = session_->scene().highlight.select(*molecule);
  if (on_stage_) looks_ = looksOf(session_->scene(), *molecule);
  if (on_stage_) annotations_ = annotationsOf(session_->scene(), *molecule);
  if (on_stage_) region_ = magnifiedRegion(session_->scene(), *molecule);
  session_->setMolecule(on_stage_ ? std::move(molecule) : nullptr);
}

void LessonGuide::feed(const ServoSample& s, std::string_view method, const Contact& exact) {
  if (!on_stage_ || !s.has_interaction) return;
  session_->feed(touchSampleOf(s, method, exact));
}

ViewPartSet LessonGuide::shownParts() const {
  ViewPartSet shown = defaultViewParts();
  shown.set(ViewPart::Facets);  // seen only with a method that feels triangles
  shown.set(ViewPart::Hip);     // where the hand is under the surface stands in for the force that a mouse cannot give
  if (!session_ || session_->scene().show.empty()) return shown;
  for (const std::string& name : session_->scene().show)
    for (const ViewPartInfo& part : viewParts())
      if (part.name == name) shown.set(part.part);
  return shown;
}

void LessonGuide::face(Camera& camera, const Molecule& molecule) const {
  faceScene(camera, molecule, on_stage_ ? session_->scene() : SceneSpec());
}

void faceScene(Camera& camera, const Molecule& molecule, const SceneSpec& scene) {
  if (scene.facing.given()) {
    const std::vector<std::uint32_t> atoms = scene.facing.select(molecule);
    Vec3 middle(0.0);
    for (const std::uint32_t a : atoms) middle += molecule.atoms[a].position.A / double(atoms.size());
    if (!atoms.empty()) camera.face({middle});
    return;
  }
  constexpr double kQuarter = 0.5 * std::numbers::pi;
  if (scene.view == "side")
    camera.lookSideOn(molecule);
  else if (scene.view == "back")
    camera.lookFrom(2 * kQuarter, 0);
  else if (scene.view == "left")
    camera.lookFrom(-kQuarter, 0);
  else if (scene.view == "right")
    camera.lookFrom(kQuarter, 0);
  else if (scene.view == "top")
    camera.lookFrom(0, kQuarter);
  else if (scene.view == "bottom")
    camera.lookFrom(0, -kQuarter);
}

void LessonGuide::decorate(ViewScene& scene) const {
  if (!on_stage_) return;
  scene.highlighted = highlighted_;
  if (annotations_) scene.annotations.push_back(annotations_);
}

}  // namespace moltact
