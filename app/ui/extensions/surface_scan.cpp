#include "app/ui/extensions/surface_scan.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "app/ui/lesson/lesson_guide.h"
#include "app/ui/widgets/imgui_versions.h"
#include "app/ui/widgets/messages.h"
#include "engine/render/gl.h"
#include "engine/render/height_picture.h"
#include "engine/render/relief.h"

namespace moltact {

SurfaceScan::SurfaceScan(HapticSession& scene, const LessonGuide& lesson, Messages& messages, const FrameTime& time)
    : scene_(scene), lesson_(lesson), messages_(messages), time_(time) {}

bool SurfaceScan::touching() const { return field_ && scene_.scanned().field() == field_; }

void SurfaceScan::forget() {
  touch(false);
  tip_.reset();
  field_.reset();
  spheres_.reset();
  surface_.reset();
  passed_s_ = 0.0;
  lines_ = drawn_lines_ = 0;
}

// A scan goes on where the scene has only been placed anew.
void SurfaceScan::begin() {
  const LessonSession* session = lesson_.session();
  if (!session || !lesson_.onStage() || !scene_.stage()) return forget();
  const SceneSpec& spec = session->scene();
  if (!(spec.scan_A > 0.0)) return forget();
  const bool same = tip_ && tip_->setup().tip_A == spec.scan_A && tip_->setup().force_pN == spec.scan_force_pN;
  if (same && spheres_ == scene_.stage().spheres) return touch(false);
  scan(spec.scan_A, spec.scan_force_pN);
}

void SurfaceScan::again() {
  if (tip_) scan(tip_->setup().tip_A, tip_->setup().force_pN);
}

void SurfaceScan::scan(double tip_A, double force_pN) {
  forget();
  const TouchableModel& stage = scene_.stage();
  ScanSetup setup{
      .tip_A = tip_A, .spacing_A = kFinest_A, .force_pN = force_pN, .orientation = scene_.camera.orientation};
  const std::vector<std::uint32_t> without = stage.spheres->untouchable();
  auto tip = ScanningTip::over(stage.spheres->spheres(), setup, without);
  // Where the scan is too large, at the coarsest spacing first, to learn how large it is.
  if (!tip) {
    setup.spacing_A = kMaxScanSpacing_A;
    tip = ScanningTip::over(stage.spheres->spheres(), setup, without);
  }
  if (tip) {
    const HeightField& field = tip->field();
    const double longest_A = std::max(field.width_A(), field.depth_A());
    if (longest_A > kFinest_A * kNodes) {
      setup.spacing_A = std::min(longest_A / kNodes, kMaxScanSpacing_A);
      tip = ScanningTip::over(stage.spheres->spheres(), setup, without);
    }
  }
  if (!tip) return messages_.error(tip.problem().text());
  tip_ = *std::move(tip);
  spheres_ = stage.spheres;
}

void SurfaceScan::touch(bool surface) {
  if (surface == touching() || (surface && !field_)) return;
  if (!surface) return scene_.scanned().touch(nullptr);
  // The surface is that of spheres which are larger by the tip and lower by its radius, and lower by the depth to which
  // a force presses the tip into them; the substrate is nearly flat.
  constexpr double kFlat_A = 1e5;
  const ScanSetup& setup = tip_->setup();
  const double probe_A = scene_.servo_settings.probe_A;
  const Vec3 up = field_->frame.orientation * Vec3(0, 0, 1);
  const SphereGrid& atoms = *scene_.stage().spheres;
  const auto sunk_A = [&](const Sphere& atom) {
    const Vec3 at = field_->frame.toScan(atom.centre_A);
    const auto node = [&](double x, int count) {
      return std::clamp(static_cast<int>(std::lround(x / field_->spacing_A)), 0, count - 1);
    };
    return std::max(0.0, at.z + atom.radius_A - field_->at(node(at.x, field_->columns), node(at.y, field_->rows)));
  };
  std::vector<Sphere> like;
  for (std::size_t i = 0; i < atoms.size(); ++i)
    if (atoms.touchable(i)) {
      const double lower_A = setup.tip_A + (setup.force_pN > 0.0 ? sunk_A(atoms[i]) : 0.0);
      like.push_back({atoms[i].centre_A - lower_A * up, std::max(0.0, atoms[i].radius_A + setup.tip_A - probe_A)});
    }
  const Vec3 middle = field_->frame.toMolecule({0.5 * field_->width_A(), 0.5 * field_->depth_A(), 0.0});
  like.push_back({middle - (kFlat_A + probe_A) * up, kFlat_A});
  scene_.scanned().touch(field_, std::make_shared<const SphereGrid>(std::move(like)));
}

void SurfaceScan::beforeTicks() {
  if (!tip_ || field_) return;
  passed_s_ += time_.dt_s;
  const int rows = tip_->field().rows;
  lines_ = std::clamp(static_cast<int>(std::ceil(rows * passed_s_ / kRaster_s)), 0, rows);
  while (tip_->linesDone() < lines_) tip_->scanLine();
  if (tip_->done()) field_ = std::make_shared<const HeightField>(tip_->field());
}

void SurfaceScan::afterPanels() {
  if (!tip_ || lines_ == drawn_lines_) return;
  drawn_lines_ = lines_;
  surface_ = std::make_shared<const MeshPiece>(reliefOf(tip_->field(), lines_));
  texture_.show(heightPicture(tip_->field(), lines_, Colour(0.5f)));
}

ImTextureID SurfaceScan::texture() const { return drawn_lines_ > 0 ? texture_.id() : ImTextureID(); }

void SurfaceScan::showIn(ViewScene& scene) const {
  if (!tip_) return;
  scene.relief = surface_;
  if (touching()) scene.probe_A = 0.0;
  if (field_ || lines_ < 1) return;
  // Along the line that is being scanned, there and back.
  const HeightField& field = tip_->field();
  const double at = field.rows * passed_s_ / kRaster_s, along = at - std::floor(at);
  const int row = lines_ - 1;
  const double share = row % 2 == 0 ? along : 1.0 - along;
  const int column = std::clamp(static_cast<int>(std::lround(share * (field.columns - 1))), 0, field.columns - 1);
  const double radius_A = tip_->setup().tip_A;
  const Vec3 centre(field.spacing_A * column, field.spacing_A * row, field.at(column, row) + radius_A);
  scene.scanning_tip = DrawnTip{{field.frame.toMolecule(centre)}, radius_A};
}

}  // namespace moltact
