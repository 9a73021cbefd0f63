// The haptic methods there are. A method is added with its own files and a row in methods.cpp.
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

/// The methods that differ only in how finely they work make one family.
struct MethodFamily {
  std::string_view name;   ///< "Mesh"
  std::string_view plain;  ///< what it does, in a student's words
};

struct Method {
  std::string_view name;      ///< as in `--method exact`
  std::string_view sentence;  ///< what it is, for the screen and `--help`
  std::unique_ptr<Tracker> (*make)(std::shared_ptr<const SphereGrid> scene, double probe_A);
  MethodFamily family{};
  std::string_view grade =
      {};  ///< how finely: "960"; empty where a family is one method, or where grid_spacing_A says it
  std::string_view variant = {};  ///< tells methods of the same grade apart: "Smooth"; may be empty
  bool plain_variant = false;     ///< its title leaves the variant out: "Mesh 960" means this one
  int triangles = 0;              ///< a sphere's, for a method that feels triangles; else 0
  double grid_spacing_A = 0.0;    ///< how far the places lie apart at which it has its surface; 0: it has no grid
  std::size_t most_spheres = 0;   ///< it prepares the whole scene: the bench leaves it out of larger ones; 0: no limit
  bool one_probe = false;         ///< it feels only the probe that it was made for
  bool shaded = false;            ///< its force has another direction than to the SCP (Contact::displacement_A)
  bool summed = false;            ///< its force is the sum of every sphere's push; it has no SCP on the surface
  bool follows_motion = false;    ///< it goes with spheres that move (Interaction::setMotion)
  bool offered = true;            ///< to people; else it stands for comparison in the bench only
  bool reference = false;         ///< the others are judged by it; exactly one is
};

/// The methods that the window, the lessons and every command offer, the default first. Each bears any scene and probe.
std::span<const Method> methods();

/// These, then the ones that stand for comparison only, with what methods() does not allow: see most_spheres and
/// one_probe.
std::span<const Method> benchMethods();

/// The one that has no error of its own, by which all are judged.
const Method& referenceMethod();
inline bool isReference(const Method& method) { return method.reference; }

/// The method of that name among methods(), or nullptr.
const Method* findMethod(std::string_view name);

/// The same among benchMethods().
const Method* findBenchMethod(std::string_view name);

/// The names of methods(), in the same order.
std::vector<std::string_view> methodNames();

/// The triangles that a method of methods() feels for a sphere of radius 1; null for a method without.
std::shared_ptr<const SphereMesh> feltFacets(std::string_view method);

/// What a person is told of a method while the spheres of the scene move (N_); empty where it goes with them.
std::string_view motionSentence(const Method& method);

/// How finely a method works, as a person is told: "960", "0.4 Å"; empty where its family is one method.
std::string gradeText(const Method& method);

/// What a person is told that it is called: "Mesh 960, Smooth"; the name itself where there is no such method.
std::string methodTitle(std::string_view name);

}  // namespace moltact
