// One picture as plain data: what is there, what of it is shown, and from where. No graphics calls; a value that one
// thread fills and hands to the renderer. Units: angstrom, newton.
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
struct SolidModel;

/// The colours of everything that is not an atom.
struct Theme {
  Colour background_top, background_bottom;
  Colour surface;  ///< wires of the haptic surface
  Colour in_use;   ///< the feature the SCP lies on
  Colour hip, scp, probe;
  Colour force, strong, strongest;  ///< of the force: none, half and all of it
  Colour bond;                      ///< hydrogen bonds
  Colour measure;                   ///< lengths and angles
  Colour touched;                   ///< what a hand has touched, and its way
  Colour target;                    ///< task targets and highlighted atoms
  float wire_strength = 1.0f;       ///< wires need more weight on a light ground (default 1)
  float fade = 0.6f;                ///< how much of the background the farthest atom takes on, 0 to 1 (default 0.6)
  bool operator==(const Theme&) const = default;
};
/// The colour of a force that is such a share (0 to 1) of the strongest.
Colour forceColour(const Theme& theme, double share);
Theme lightTheme();
Theme darkTheme();

/// A place that a task asks the learner to reach.
struct TargetMarker {
  PointA centre;
  double radius_A = 1.0;
  bool reached = false;  ///< drawn in the colour of success
  friend bool operator==(const TargetMarker&, const TargetMarker&) = default;
};

/// How some atoms are drawn.
struct StyledAtoms {
  DrawStyle style = DrawStyle::Spheres;
  AtomList atoms = nullptr;  ///< null: all
  float opacity = 1.0f;      ///< below 1 what lies behind shines through
  friend bool operator==(const StyledAtoms&, const StyledAtoms&) = default;
};

/// Cuts the molecule open: what lies beyond the plane, on the side of the normal, is not drawn.
struct CutPlane {
  Vec3 normal{0.0, 0.0, 1.0};  ///< of length 1, in the molecule's axes
  double offset_A = 0.0;       ///< a place p is cut away where dot(normal, p) > offset_A
  friend bool operator==(const CutPlane&, const CutPlane&) = default;
};

/// What of the molecule is drawn, and how.
struct AtomsLook {
  std::vector<StyledAtoms> styles;  ///< drawn together; empty: all atoms as spheres
  AtomList hidden;                  ///< not drawn in any style; null: none
  double spheres_near_A = 0.0;      ///< beside other styles: atoms whose surface is so near to the probe's are drawn as
                                    ///< spheres too (default 0: none)
  std::optional<CutPlane> cut;
  std::shared_ptr<const std::vector<OwnColour>> marks;  ///< parts in colours of their own, over all others; null: none
  std::shared_ptr<const Colouring> colouring;           ///< null: as `colour_by` of the scene says
  std::shared_ptr<const Annotations> annotations;  ///< names and hydrogen bonds that a person asked for; null: none

  /// Whether all that is felt is seen as it is felt: every atom a sphere.
  bool allSpheres() const {
    return !hidden && !cut && (styles.empty() || (styles.size() == 1 && styles[0] == StyledAtoms{}));
  }
  friend bool operator==(const AtomsLook&, const AtomsLook&) = default;
};

struct ViewScene {
  std::shared_ptr<const Molecule> molecule;  ///< may be null: only the background and the glyphs are drawn
  Camera camera;
  ViewPartSet shown = defaultViewParts();
  Theme theme = darkTheme();
  ElementColours elements = ElementColours::Customary;
  ColourBy colour_by = ColourBy::Element;
  AtomsLook look;
  std::size_t most_single_atoms = kMaxSingleAtoms;  ///< of more than these, residues are drawn in the atoms' place
  bool blank = false;  ///< the dark screen of a task done by touch alone: nothing is drawn (default off)

  std::optional<PointA> hip;  ///< no probe is drawn without it
  Contact contact;            ///< its SCP, displacement and atoms are used while touching
  double force_N = 0.0;       ///< length of the force, along the contact's displacement or `field_direction`
  /// Where a field acts: the direction of its force and the contact's together, of any length. Zero: no field acts.
  Vec3 field_direction{0.0};
  double strongest_N = 3.0;  ///< the force that is drawn as the strongest (default 3 N)
  double probe_A = kWaterProbe_A;
  std::shared_ptr<const HeldBody> body;     ///< drawn in the probe's place; null: the probe
  std::optional<PointA> body_place;         ///< of its middle; empty: at the SCP
  Quat body_orientation = kNoRotation;      ///< relative to the molecule
  std::vector<std::uint32_t> body_stopped;  ///< atoms of the body, by their numbers in it, that glow: others stop them
  bool water = true;  ///< a probe as large as a water molecule is drawn as one; false: as a sphere (default true)
  std::shared_ptr<const SolidModel>
      hand;                    ///< stands with its origin at the HIP, its +y toward the person's hand; may be null
  bool left_hand = false;      ///< the hand comes from the left (default: from the right)
  double arrow_A_per_N = 2.0;  ///< length of the force arrow (default 2 A for 1 N)

  std::vector<std::uint32_t> haptic_atoms;  ///< whose haptic shapes are drawn; empty: those nearest to the SCP
  std::size_t haptic_atoms_at_most = 14;    ///< how many are taken when haptic_atoms is empty (default 14)

  std::shared_ptr<const SphereMesh>
      facets;  ///< what the method in use feels for a sphere of radius 1; null: no triangles

  std::vector<std::shared_ptr<const Annotations>> annotations;  ///< written into the picture; none is null
  std::optional<std::array<std::int32_t, 3>> named_atoms =
      {};                          ///< that words name as touched now, and rings with them;
                                   ///< none: those of the contact
  AtomList touched_now = nullptr;  ///< lightly painted too, without the molecule being drawn again; null: none
  AtomList touched = nullptr;      ///< atoms that are lightly painted; null: none

  std::vector<std::uint32_t> highlighted;  ///< atoms marked in the target's colour; out-of-range ones are ignored
  std::vector<TargetMarker> targets;

  /// Molecules, models and meshes are compared by address.
  friend bool operator==(const ViewScene&, const ViewScene&) = default;
};

/// Whether two scenes give the same picture.
inline bool sameView(const ViewScene& a, const ViewScene& b) { return (a.blank && b.blank) || a == b; }

}  // namespace moltact
