// The table of haptic methods that the program offers. A new method needs its own files and a row in methods.cpp.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/haptics/sphere_grid.h"
#include "engine/haptics/tracker.h"

namespace moltact {

class SphereMesh;

/// Methods that differ only in their resolution form a family.
struct MethodFamily {
  std::string_view name;   ///< "Mesh"; untranslated (N_)
  std::string_view plain;  ///< description in a student's words, untranslated (N_)
};

/// One row of the table.
struct Method {
  std::string_view name;      ///< as in `--method exact`
  std::string_view sentence;  ///< description for the screen and `--help`
  std::unique_ptr<Tracker> (*make)(std::shared_ptr<const SphereGrid> scene, double probe_A);
  MethodFamily family{};
  std::string_view grade =
      {};  ///< resolution: "960"; empty for a family of one method, or where grid_spacing_A states it
  std::string_view variant = {};  ///< distinguishes methods of the same grade: "Smooth"; may be empty
  bool plain_variant = false;     ///< the title omits the variant: "Mesh 960" means this method
  int triangles = 0;              ///< triangles per sphere, for a method on triangles; else 0
  double grid_spacing_A = 0.0;    ///< spacing of the grid that samples the surface; 0: no grid
  bool shaded = false;            ///< the force does not point to the SCP (Contact::displacement_A)
  bool summed = false;            ///< the force is the sum of all spheres' pushes; there is no SCP on the surface
  bool follows_motion = false;    ///< follows moving spheres (Interaction::setMotion)
  bool reference = false;         ///< the method against which all others are measured; exactly one
  /// The name of the method in files of earlier versions; empty: none.
  std::string_view former_name = {};
};

/// The methods offered by the window, lessons and commands, the default first. Each accepts every scene and probe.
std::span<const Method> methods();

/// The reference: the method without an error of its own.
const Method& referenceMethod();
inline bool isReference(const Method& method) { return method.reference; }

/// Finds a method by its name or former name; nullptr if there is none.
const Method* findMethod(std::string_view name);

/// The names of methods(), in the same order.
std::vector<std::string_view> methodNames();

/// The triangles with which a method of methods() represents a sphere of radius 1; null for a method without triangles.
std::shared_ptr<const SphereMesh> feltFacets(std::string_view method);

/// The message about a method that does not follow moving spheres, untranslated (N_); empty if it follows them.
std::string_view motionSentence(const Method& method);

/// The method's resolution for display: "960", "0.4 Å"; empty for a family of one method.
std::string gradeText(const Method& method);

/// The method's title for display: "Mesh 960, Smooth". An unknown name is returned unchanged.
std::string methodTitle(std::string_view name);

}  // namespace moltact
