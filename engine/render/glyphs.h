// The probe and its markers: the water molecule at the SCP, HIP, SCP, the spring between them, the force arrow, and a
// task's targets. Pure geometry without graphics calls. Positions are in the camera's axes (unit: angstrom).
#pragma once

#include <vector>

#include "engine/render/molecule_model.h"
#include "engine/render/pixel_box.h"
#include "engine/render/sphere_impostors.h"
#include "engine/render/view_scene.h"
#include "engine/render/wireframe.h"

namespace moltact {

struct GlyphCone {
  glm::vec3 a{0.0f}, b{0.0f};
  float radius_a = 0, radius_b = 0;
  std::uint32_t colour = 0;
};

/// A model with its transform to the camera's axes.
struct GlyphModel {
  const SolidModel* model = nullptr;
  glm::mat4 to_view{1.0f};
};

struct Glyphs {
  std::vector<LooseSphere> solid, ghost, shell;  ///< a ghost marks where the solid at its position is hidden
  std::vector<GlyphCone> cones;
  std::vector<GlyphModel> models;
  Strokes strokes;
  glm::vec3 shadow_centre{0.0f};
  float shadow_radius = 0;  ///< radius of the sphere that casts a shadow on the molecule; 0: none

  void clear();
  /// Adds the extent of all glyphs in the picture.
  void addTo(PixelBoxBuilder& box) const;
};

/// The arc of a torque about its axis lies at this distance from the axis (unit: pixel, in a picture 800 high). If the
/// body's radius of gyration is greater, it lies at that radius. It is as long as the arrow of the force that gives the
/// torque at that lever, at most kMaxTorqueArc_rad.
inline constexpr double kMinTorqueArc_px = 40, kMaxTorqueArc_rad = 5.2;

/// The body's outline at the hand's pose is drawn from this largest distance between an atom there and as it rests
/// (unit: pixel, in a picture 800 high). The least distance is kMinGhost_A.
inline constexpr double kMinGhost_px = 4, kMinGhost_A = 0.05;

/// Length of the model at the HIP, in a picture 800 pixels high.
inline constexpr double kHandLength_px = 170;

/// O-H distance (unit: angstrom) and H-O-H angle (unit: degree) of water in the gas phase (Benedict, Gailar & Plyler
/// 1956).
inline constexpr double kWaterBond_A = 0.9572, kWaterAngle_deg = 104.52;

/// Adds the atoms near the probe that the scene shows as spheres in addition to another style.
void addNearSpheres(const ViewScene& scene, const MoleculeModel& model, std::vector<LooseSphere>& spheres);

/// Adds the painted atoms that are drawn without redrawing the molecule.
void addTouchedSpheres(const ViewScene& scene, const MoleculeModel& model, std::vector<LooseSphere>& spheres);

/// Adds everything except the haptic shapes. `model` may be null.
void addGlyphs(const ViewScene& scene, const MoleculeModel* model, Glyphs& glyphs);

}  // namespace moltact
