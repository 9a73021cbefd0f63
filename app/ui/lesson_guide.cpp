#include "app/ui/lesson_guide.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/lesson/reader.h"
#include "engine/molecule/catalogue.h"

namespace moltact {

std::optional<std::string> LessonGuide::open(const std::filesystem::path& file) {
  LessonReading reading = readLesson(file);
  if (!reading.lesson) {
    constexpr std::size_t kTold = 4;
    std::string text;
    for (std::size_t k = 0; k < std::min(kTold, reading.errors.size()); ++k) text += (k ? "\n" : "") + reading.errors[k].text();
    if (reading.errors.size() > kTold) text += "\nand " + std::to_string(reading.errors.size() - kTold) + " more";
    return text.empty() ? file.string() + " is not a lesson." : text;
  }
  session_ = std::make_unique<LessonSession>(std::make_shared<const Lesson>(*std::move(reading.lesson)));
  file_ = file;
  scene_changed_ = true;
  return std::nullopt;
}

void LessonGuide::next() {
  if (session_) session_->next();
}

void LessonGuide::back() {
  if (session_) session_->back();
}

bool LessonGuide::follow(const std::string& link) { return session_ && link.starts_with('#') && session_->goTo(link); }

const SceneSpec* LessonGuide::takeNewScene() {
  if (!session_ || (!scene_changed_ && session_->sceneNumber() == scene_seen_)) return nullptr;
  scene_changed_ = false;
  scene_seen_ = session_->sceneNumber();
  return &session_->scene();
}

Expected<std::filesystem::path> LessonGuide::moleculeFile() const {
  if (!session_) return Problem{{}, 0, 0, "no lesson is open", {}};
  const SceneSpec& scene = session_->scene();
  std::error_code error;
  const std::filesystem::path beside = file_.parent_path() / scene.molecule;
  if (std::filesystem::is_regular_file(beside, error)) return beside;
  Expected<std::filesystem::path> known = findMolecule(scene.molecule, MoleculeFolders::ofThisComputer());
  if (known) return known;
  Problem problem = known.problem();
  return Problem{file_.string(), scene.molecule_place.line, scene.molecule_place.column, problem.message, problem.remedy};
}

void LessonGuide::meet(std::shared_ptr<const Molecule> molecule, const std::filesystem::path& file) {
  highlighted_.clear();
  on_stage_ = false;
  if (!session_) return;
  const Expected<std::filesystem::path> wanted = moleculeFile();
  on_stage_ = wanted && *wanted == file;
  if (on_stage_ && session_->scene().highlight.given()) highlighted_ = session_->scene().highlight.select(*molecule);
  session_->setMolecule(on_stage_ ? std::move(molecule) : nullptr);
}

void LessonGuide::feed(const ServoSample& s, std::string_view method, const Contact& exact) {
  if (!on_stage_ || !s.has_tracker) return;
  session_->feed(TouchSample{.time_s = s.time_s, .hip = s.hip, .contact = s.contact, .force = s.force, .probe_A = s.probe_A,
                              .method = method, .exact = exact});
}

ShapeSet LessonGuide::shapes() const {
  ShapeSet shown = defaultShapes();
  shown.set(Shape::Facets);  // seen only with a method that feels triangles
  shown.set(Shape::Hip);  // where the hand is under the surface stands in for the force that a mouse cannot give
  if (!session_ || session_->scene().show.empty()) return shown;
  for (const std::string& name : session_->scene().show)
    for (const ShapeName& shape : shapeNames())
      if (shape.name == name) shown.set(shape.shape);
  return shown;
}

bool LessonGuide::wantsPanel(std::string_view name) const {
  if (!session_) return false;
  const std::vector<std::string>& panels = session_->scene().panels;
  return std::find(panels.begin(), panels.end(), name) != panels.end();
}

void LessonGuide::face(Camera& camera, const Molecule& molecule) const {
  if (!on_stage_) return;
  const SceneSpec& scene = session_->scene();
  if (scene.facing.given()) {
    const std::vector<std::uint32_t> atoms = scene.facing.select(molecule);
    Vec3 middle(0.0);
    for (const std::uint32_t a : atoms) middle += molecule.atoms[a].position.A / double(atoms.size());
    const Vec3 way = middle - camera.target.A;
    // Atoms in the middle of the molecule can be turned nowhere.
    if (!atoms.empty() && glm::length(way) > 0.1)
      camera.lookFrom(std::atan2(way.x, way.z), std::atan2(way.y, std::hypot(way.x, way.z)));
    return;
  }
  constexpr double kQuarter = 0.5 * std::numbers::pi;
  if (scene.view == "back") camera.lookFrom(2 * kQuarter, 0);
  else if (scene.view == "left") camera.lookFrom(-kQuarter, 0);
  else if (scene.view == "right") camera.lookFrom(kQuarter, 0);
  else if (scene.view == "top") camera.lookFrom(0, kQuarter);
  else if (scene.view == "bottom") camera.lookFrom(0, -kQuarter);
}

void LessonGuide::decorate(ViewScene& scene) const {
  if (on_stage_) scene.highlighted = highlighted_;
}

bool looksLikeLesson(const std::filesystem::path& file) { return file.extension() == ".md" || file.extension() == ".MD"; }

}  // namespace moltact
