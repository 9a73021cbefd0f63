// The scanning tip of a scene (`scan: 10 A`, or at constant force `scan: 10 A, 100 pN`): it rasters over the molecule
// from the viewer's side, line by line, while the height picture grows beside the view. The scanned surface can then be
// touched as a height field instead of the atoms.
// Contacts with it do no task. Window's thread; afterPanels needs the GL context.
#pragma once

#include <imgui.h>

#include <memory>
#include <optional>

#include "app/ui/application/extension.h"
#include "app/ui/widgets/picture_texture.h"
#include "engine/haptics/height_field/scanning_tip.h"
#include "engine/render/mesh_piece.h"
#include "engine/render/view_scene.h"

namespace moltact {

class LessonGuide;
class Messages;

class SurfaceScan : public Extension {
 public:
  SurfaceScan(HapticSession& scene, const LessonGuide& lesson, Messages& messages, const FrameTime& time);

  /// Duration of a whole scan, and the nodes of its longer side.
  static constexpr double kRaster_s = 20.0;
  static constexpr int kNodes = 160;
  static constexpr double kFinest_A = 0.25;  ///< spacing; wider where kNodes would be exceeded

  void sceneChanged() override { begin(); }
  void lessonChanged() override { begin(); }
  void beforeTicks() override;
  void afterPanels() override;
  bool live() const override { return running(); }
  bool leadsHand() const override { return touching(); }

  /// Whether the scene is scanned.
  bool on() const { return tip_.has_value(); }
  bool running() const { return tip_ && !field_; }
  /// Whether the hand touches the scanned surface and not the atoms.
  bool touching() const;
  /// Touches the surface, which must be complete, or the atoms again.
  void touch(bool surface);
  /// Scans again from the present view.
  void again();

  const HeightField& field() const { return tip_->field(); }
  const ScanSetup& setup() const { return tip_->setup(); }
  /// The lines that are shown.
  int lines() const { return lines_; }
  /// The height picture, its first row at the top; null before the first line.
  ImTextureID texture() const;

  /// Adds the surface so far, and the tip while it scans. While the surface is touched, the hand is a point.
  void showIn(ViewScene& scene) const;

 private:
  void begin();
  void scan(double tip_A, double force_pN);
  void forget();
  void drawSurface();

  HapticSession& scene_;
  const LessonGuide& lesson_;
  Messages& messages_;
  const FrameTime& time_;
  std::optional<ScanningTip> tip_;
  std::shared_ptr<const HeightField> field_;   // once it is complete
  std::shared_ptr<const SphereGrid> spheres_;  // that are scanned
  double passed_s_ = 0.0;
  int lines_ = 0, drawn_lines_ = 0;
  std::shared_ptr<const MeshPiece> surface_;
  PictureTexture texture_;
};

}  // namespace moltact
