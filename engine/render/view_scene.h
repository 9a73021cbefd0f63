// One picture as plain data: its objects, the visible parts and the camera. No graphics calls; a value that one thread
// fills and passes to the renderer. Units: angstrom, newton. Quat is constructed as (w, x, y, z).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "engine/core/units.h"
#include "engine/haptics/body/held_body.h"
#include "engine/haptics/tracker.h"
#include "engine/molecule/draw_style.h"
#include "engine/molecule/molecule.h"
#include "engine/molecule/view_part.h"
#include "engine/render/annotations.h"
#include "engine/render/atom_style.h"
#include "engine/render/camera.h"
#include "engine/render/residue_spheres.h"
#include "engine/structure/colouring.h"

namespace moltact {

class SphereMesh;
struct MeshPiece;
struct SolidModel;

/// The colours of everything except atoms.
struct Theme {
  Colour background_top, background_bottom;
  Colour surface;  ///< wires of the haptic surface
  Colour in_use;   ///< the feature on which the SCP lies
  Colour hip, scp, probe;
  Colour force, strong, strongest;  ///< no force, half and full force
  Colour bond;                      ///< hydrogen bonds
  Colour measure;                   ///< lengths and angles
  Colour touched;                   ///< touched atoms, and the trail of the probe
  Colour target;                    ///< task targets and highlighted atoms
  Colour attracts, repels;          ///< atoms whose energy with what the hand holds is negative; positive
  float wire_strength = 1.0f;       ///< factor on wires, which need more weight on a light background
  float fade = 0.6f;                ///< fraction of the background's colour in the farthest atom, 0 to 1
  bool operator==(const Theme&) const = default;
};
/// The colour of a force given as a fraction (0 to 1) of the strongest.
Colour forceColour(const Theme& theme, double share);
Theme lightTheme();
Theme darkTheme();

/// A position that a task asks the student to reach.
struct TargetMarker {
  PointA centre;
  double radius_A = 1.0;
  bool reached = false;  ///< drawn in the success colour
  friend bool operator==(const TargetMarker&, const TargetMarker&) = default;
};

/// How some atoms are drawn.
struct StyledAtoms {
  DrawStyle style = DrawStyle::Spheres;
  AtomList atoms = nullptr;  ///< null: all
  float opacity = 1.0f;      ///< below 1 the background shows through
  friend bool operator==(const StyledAtoms&, const StyledAtoms&) = default;
};

/// Cuts the molecule open: the half-space beyond the plane, on the side of the normal, is not drawn.
struct CutPlane {
  Vec3 normal{0.0, 0.0, 1.0};  ///< unit vector in the molecule's axes
  double offset_A = 0.0;       ///< a point p is cut away if dot(normal, p) > offset_A
  friend bool operator==(const CutPlane&, const CutPlane&) = default;
};

/// The appearance of the molecule.
struct AtomsLook {
  std::vector<StyledAtoms> styles;  ///< drawn together; empty: all atoms as spheres
  AtomList hidden;                  ///< not drawn in any style; null: none
  /// With other styles: atoms whose surface is within this distance of the probe's are drawn as spheres too (0: none).
  double spheres_near_A = 0.0;
  std::optional<CutPlane> cut;
  std::shared_ptr<const std::vector<OwnColour>>
      marks;                                       ///< parts with colours of their own, over all others; null: none
  std::shared_ptr<const Colouring> colouring;      ///< null: use `colour_by` of the scene
  std::shared_ptr<const Annotations> annotations;  ///< names and hydrogen bonds requested by the user; null: none

  /// True if the picture equals the felt shape: every atom is drawn as a sphere.
  bool allSpheres() const {
    return !hidden && !cut && (styles.empty() || (styles.size() == 1 && styles[0] == StyledAtoms{}));
  }
  friend bool operator==(const AtomsLook&, const AtomsLook&) = default;
};

/// An atom with its share of a contact's force.
struct LoadedAtom {
  std::uint32_t atom = 0;
  double share = 1.0;  ///< of the sum of all sizes, 0 to 1
  friend bool operator==(const LoadedAtom&, const LoadedAtom&) = default;
};

/// The ball at the end of a scanning tip.
struct DrawnTip {
  PointA centre;
  double radius_A = 1.0;
  friend bool operator==(const DrawnTip&, const DrawnTip&) = default;
};

struct ViewScene {
  std::shared_ptr<const Molecule> molecule;  ///< may be null: only the background and the glyphs are drawn
  Camera camera;
  ViewPartSet shown = defaultViewParts();
  Theme theme = darkTheme();
  ElementColours elements = ElementColours::Customary;
  ColourBy colour_by = ColourBy::Element;
  AtomsLook look;
  std::size_t max_single_atoms = kMaxSingleAtoms;  ///< with more atoms, residues are drawn instead
  bool blank = false;                              ///< nothing is drawn: the dark screen of a task by touch alone

  std::optional<PointA> hip;  ///< empty: no probe is drawn
  Contact contact;            ///< SCP, displacement and atoms are used in contact
  bool coupled = false;       ///< what the hand holds is at contact.scp, also where it touches nothing
  double force_N = 0.0;       ///< size of the force, along the contact's displacement or `field_direction`
  /// Direction of the combined force of field and contact, of any length. Zero: no field acts.
  Vec3 field_direction{0.0};
  double strongest_N = 3.0;  ///< the force drawn as the strongest
  double probe_A = kWaterProbe_A;
  std::shared_ptr<const HeldBody> body;  ///< drawn instead of the probe; null: the probe
  std::optional<PointA> body_place;      ///< position of its middle; empty: at the SCP
  Quat body_orientation = kNoRotation;   ///< relative to the molecule
  /// The hand's orientation where a body is held: an outline shows the body at the hand's pose where the two differ
  /// visibly. Empty: no outline.
  std::optional<Quat> hand_orientation;
  /// Another pose of the body, drawn as an outline: the place of its middle (empty: none) and its orientation.
  std::optional<PointA> marked_place;
  Quat marked_orientation = kNoRotation;
  std::vector<LoadedAtom>
      body_stopped;                    ///< atoms of the body that the scene stops, by index within the body, ascending
  std::vector<LoadedAtom> stopped_by;  ///< atoms of the molecule that stop the body; they glow
  /// Atoms of the molecule that attract or repel what the hand holds; they glow by their share of both.
  std::vector<LoadedAtom> attracting, repelling;
  /// Lines between what the hand holds and the molecule, drawn with the probe; null: none.
  std::shared_ptr<const Annotations> held_lines;
  Vec3 torque_N_A{0.0};         ///< of a body on the hand, about the body's middle, in the molecule's axes
  std::optional<PointA> ghost;  ///< where a guide leads the probe, drawn as its outline; empty: no guide
  bool water = true;            ///< a probe of water's size is drawn as a water molecule; false: as a sphere
  /// The model of a hand, with its origin at the HIP and +y toward the user's hand; may be null.
  std::shared_ptr<const SolidModel> hand;
  bool left_hand = false;      ///< the hand comes from the left (default: from the right)
  double arrow_A_per_N = 2.0;  ///< length of the force arrow per newton

  std::vector<std::uint32_t> haptic_atoms;  ///< atoms whose haptic shapes are drawn; empty: those nearest to the SCP
  std::size_t max_haptic_atoms = 14;        ///< their number if haptic_atoms is empty

  /// The triangles with which the method represents a sphere of radius 1; null: no triangles.
  std::shared_ptr<const SphereMesh> facets;

  std::vector<std::shared_ptr<const Annotations>> annotations;  ///< drawn into the picture; never null
  /// The atoms shown as touched by words and rings; empty: those of the contact.
  std::optional<std::array<std::int32_t, 3>> named_atoms = {};
  AtomList touched_now = nullptr;  ///< additional lightly painted atoms, without redrawing the molecule; null: none
  AtomList touched = nullptr;      ///< lightly painted atoms; null: none

  std::vector<std::uint32_t> highlighted;  ///< atoms in the target's colour; indices out of range are ignored
  std::vector<TargetMarker> targets;

  /// A scanned surface, drawn translucent in front of everything under it; null: none. A new object for each change.
  std::shared_ptr<const MeshPiece> relief;
  std::optional<DrawnTip> scanning_tip;  ///< of a scan that runs; drawn like the probe

  /// Molecules, models and meshes are compared by address.
  friend bool operator==(const ViewScene&, const ViewScene&) = default;
};

/// The place of what the hand holds: the SCP in contact or where a spring couples it to the hand, else the HIP. Empty
/// without a hand.
inline std::optional<PointA> heldPlace(const ViewScene& scene) {
  if (!scene.hip) return std::nullopt;
  return scene.contact.touching() || scene.coupled ? scene.contact.scp : *scene.hip;
}

/// True if two scenes give the same picture.
inline bool sameView(const ViewScene& a, const ViewScene& b) { return (a.blank && b.blank) || a == b; }

}  // namespace moltact
