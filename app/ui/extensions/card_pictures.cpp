#include "app/ui/extensions/card_pictures.h"

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <string_view>
#include <system_error>
#include <utility>

#include "app/ui/application/application_options.h"
#include "app/ui/files/settings.h"
#include "app/ui/lesson/lesson_guide.h"
#include "app/ui/widgets/picture_texture.h"
#include "app/ui/widgets/theme.h"
#include "engine/haptics/methods.h"
#include "engine/haptics/sphere_grid.h"
#include "engine/haptics/sweep.h"
#include "engine/lesson/lesson_region.h"
#include "engine/lesson/scene_atoms.h"
#include "engine/molecule/reader.h"
#include "engine/platform/background.h"
#include "engine/platform/read_file.h"
#include "engine/render/gl.h"
#include "engine/render/renderer.h"
#include "engine/structure/interaction_input.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

// Increase this version when pictures of the same subject change.
constexpr std::string_view kDrawnAs = "5";
constexpr std::size_t kMaxKept = 400;
constexpr std::size_t kLargestFile = std::size_t{1} << 30;  // unit: byte

std::uint64_t fnv1a(std::string_view bytes, std::uint64_t hash = 14695981039346656037ull) {
  for (const char c : bytes) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ull;
  return hash;
}

std::string sceneKey(const CardSubject& subject) {
  const SceneSpec& s = subject.scene;
  // A lesson's protein has another default style than a single molecule.
  std::string styles = s.molecule.name.empty() ? "alone," : "in a lesson,";
  for (const StyleSpec& style : s.styles)
    styles += std::string(nameOf(style.style)) + ' ' + std::to_string(style.opacity) + ' ' + style.atoms.text() + ',';
  for (const MarkSpec& mark : s.marks) styles += mark.word + ' ' + mark.atoms.text() + ',';
  return styles + s.hide.text() + '|' + s.untouchable.text() + '|' + s.remove.text() + '|' + s.in_hand.text() + '|' +
         readingText(subject.molecule.reading) + s.view.text + '|' + (s.cut ? 'c' + s.cut_at.text() : std::string()) +
         '|' + s.highlight.text() + '|' + s.touch.method + '|' + std::to_string(s.touch.probe_A) + '|' + s.colour +
         '|' + std::to_string(s.near_A);
}

// The first contact of a probe that approaches along a ray from the viewer's upper right.
PointA restingPlace(const SphereGrid& spheres, const Camera& camera, double probe_A) {
  constexpr double kClose_A = 0.02;
  const Vec3 outward = glm::normalize(0.6 * camera.right() + 0.5 * camera.up() + 0.6 * camera.back());
  double out_A = glm::length(spheres.high_A() - spheres.low_A()) + 2.0 * probe_A;
  PointA place{camera.target.A + outward * out_A};
  for (int step = 0; step < 200; ++step) {
    const double gap_A = clearance(spheres, probe_A, place.A);
    if (gap_A < kClose_A || out_A < 0.0) break;
    out_A -= gap_A;
    place.A = camera.target.A + outward * out_A;
  }
  return place;
}

// The scene with a lesson's view and marks, and the probe at the surface.
ViewScene sceneOf(Molecule read, const SceneSpec& spec) {
  ViewScene scene;
  const SphereGrid spheres(read.spheres, untouchableAtoms(spec, read));
  const std::vector<std::uint32_t> removed = atomsOfEither(
      spec.remove.given() ? spec.remove.select(read) : std::vector<std::uint32_t>(), heldAtoms(spec, read));
  scene.molecule = std::make_shared<const Molecule>(std::move(read));
  scene.shown = {ViewPart::Atoms, ViewPart::Target, ViewPart::Probe, ViewPart::Facets};
  scene.probe_A = spec.touch.probe_A;
  scene.colour_by = colourBy(spec);
  scene.look = looksOf(spec, *scene.molecule);
  scene.facets = feltFacets(spec.touch.method);
  if (spec.highlight.given()) scene.highlighted = spec.highlight.select(*scene.molecule);
  const double aspect = double(CardPictures::kWidth_px) / CardPictures::kHeight_px;
  const auto fit = [&] { scene.camera.fit(*scene.molecule, aspect, 0.08, 2.2 * spec.touch.probe_A, removed); };
  fit();
  faceView(scene.camera, *scene.molecule, spec.view, spec);
  fit();
  if (const auto part = zoomedRegion(spec.view, spec, *scene.molecule, spec.touch.probe_A))
    scene.camera.fit(part->centre, part->radius_A, aspect);
  scene.look.cut = cutOf(spec, *scene.molecule, scene.camera);
  if (spec.in_hand.given()) scene.body = heldBody(*scene.molecule, heldAtoms(spec, *scene.molecule));
  scene.hip = restingPlace(spheres, scene.camera, scene.body ? scene.body->reach_A : spec.touch.probe_A);
  return scene;
}

// Deletes all but the newest pictures.
void tidy(const fs::path& folder) {
  std::error_code error;
  std::vector<std::pair<fs::file_time_type, fs::path>> files;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error))
    if (it->path().extension() == ".png") files.emplace_back(it->last_write_time(error), it->path());
  if (files.size() <= kMaxKept) return;
  std::sort(files.begin(), files.end());
  for (std::size_t k = 0; k < files.size() - kMaxKept; ++k) fs::remove(files[k].second, error);
}

}  // namespace

struct CardPictures::Card : PictureTexture {
  bool begun = false;  // a job for it has started; without effect on a molecule that cannot be read
};

CardPictures::CardPictures(const Settings& settings, const ApplicationOptions& options)
    : settings_(settings), options_(options) {}
CardPictures::~CardPictures() = default;

ImTextureID CardPictures::find(const CardSubject& subject) {
  if (subject.molecule.empty()) return {};
  std::string key = look_ + subject.molecule.file.string() + '|' + sceneKey(subject);
  std::unique_ptr<Card>& card = cards_[key];
  if (!card) card = std::make_unique<Card>();
  if (!card->begun) wanted_.emplace_back(std::move(key), subject);
  return card->id();
}

void CardPictures::afterPanels() {
  std::vector<std::pair<std::string, CardSubject>> wanted = std::exchange(wanted_, {});
  const std::string now = std::string(themeName(settings_.theme)) + (settings_.colour_blind_safe ? "|safe|" : "|");
  if (now != look_) {
    look_ = now;
    wanted.clear();  // of the previous theme
    std::erase_if(cards_, [](const auto& c) { return c.second->empty(); });
  }
  const bool wait = options_.clock == ServoClock::Frames;  // deterministic on the frames' clock
  if (job_.valid() && (wait || job_.wait_for(std::chrono::seconds(0)) == std::future_status::ready)) finish(job_.get());
  waiting_ = !wanted.empty();
  if (job_.valid()) return;
  if (wanted.empty()) {
    renderer_.reset();
    return;
  }
  auto next = std::move(wanted.front());
  cards_.at(next.first)->begun = true;
  job_ = inBackground([key = std::move(next.first), subject = std::move(next.second), look = look_,
                       folder = options_.cache_folder]() mutable {
    Job job{std::move(key), std::move(subject), {}, {}, {}};
    const Expected<std::string> bytes = readFile(job.subject.molecule.file, kLargestFile, "");
    if (!bytes) return job;
    if (!folder.empty()) {
      char name[40];
      const std::uint64_t hash = fnv1a(*bytes, fnv1a(look + sceneKey(job.subject) + std::string(kDrawnAs)));
      std::snprintf(name, sizeof name, "card-%016llx.png", static_cast<unsigned long long>(hash));
      job.kept = folder / name;
      std::error_code ignored;
      if (fs::exists(job.kept, ignored))
        if (Expected<Picture> picture = readPng(job.kept)) {
          job.picture = *std::move(picture);
          return job;
        }
    }
    try {
      if (Expected<Molecule> molecule = readMolecule(job.subject.molecule))
        job.scene = sceneOf(*std::move(molecule), job.subject.scene);
    } catch (const std::exception&) {
      // A card without a picture; opening the lesson reports the fault.
    }
    return job;
  });
}

void CardPictures::finish(Job job) {
  const auto at = cards_.find(job.key);
  if (at == cards_.end()) return;
  if (!job.picture && job.scene) {
    if (!renderer_) {
      Expected<std::unique_ptr<Renderer>> made = Renderer::create();
      if (!made) return;
      renderer_ = std::move(*made);
    }
    job.scene->theme = look().viewTheme();
    job.scene->elements = elementColoursOf(settings_);
    if (renderer_->draw(*job.scene, kWidth_px, kHeight_px, {.samples = 3})) return;
    job.picture = renderer_->readPixels();
    ++drawn_;
    if (!job.kept.empty()) {
      std::error_code ignored;
      fs::create_directories(job.kept.parent_path(), ignored);
      // A failure to write, for example on a full disk, only slows the next start.
      writePng(job.kept, *job.picture);
      tidy(job.kept.parent_path());
    }
  }
  if (job.picture && !job.picture->rgb.empty()) at->second->show(*job.picture);
}

}  // namespace moltact
