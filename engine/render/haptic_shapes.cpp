#include "engine/render/haptic_shapes.h"

#include <algorithm>
#include <numbers>

#include "engine/core/saturated.h"
#include "engine/core/sphere_intersections.h"
#include "engine/core/units.h"
#include "engine/haptics/mesh/sphere_mesh.h"

namespace moltact {
namespace {

constexpr std::size_t kFacetedAtoms = 6;  // largest number of atoms whose triangles are drawn
constexpr double kMaxFacets =
    700.0;  // approximate number of triangles drawn per atom; fine meshes show a patch at the contact

struct Arc {
  Vec3 centre, u, v;  // u and v are perpendicular, both of the radius's length
  Vec3 at(double t) const { return centre + std::cos(t) * u + std::sin(t) * v; }
};

class Drawer {
 public:
  Drawer(const ViewScene& scene, const MoleculeModel& model, Strokes& strokes, std::vector<LooseSphere>& dots)
      : scene_(scene), model_(model), strokes_(strokes), dots_(dots) {
    for (const std::int32_t a : scene.contact.atoms)
      if (scene.contact.touching() && a >= 0 && std::size_t(a) < model.atoms()) in_use_.push_back(std::uint32_t(a));
    focus_ = heldPlace(scene).value_or(scene.camera.target).A;
    if (scene.haptic_atoms.empty()) {
      if (scene.hip) atoms_ = nearestAtoms(model, {focus_}, scene.probe_A, 2.5, scene.max_haptic_atoms);
      fading_ = true;
    } else {
      atoms_ = scene.haptic_atoms;
      std::erase_if(atoms_, [&](std::uint32_t a) { return a >= model.atoms(); });
    }
    for (const std::uint32_t a : in_use_)
      if (std::find(atoms_.begin(), atoms_.end(), a) == atoms_.end()) atoms_.push_back(a);
  }

  void spheres() {
    for (const std::uint32_t a : atoms_) {
      gatherNeighbours(a);
      const Sphere b = inflated(a);
      const bool held = isInUse(a);
      const Stroke ring{.colour = scene_.theme.surface,
                        .alpha = (held ? 0.9f : 0.62f) * strength(a) * scene_.theme.wire_strength,
                        .hidden = 0.10f,
                        .width_px = held ? 1.5f : 1.2f};
      // Meridians and parallels about the camera's vertical, so that every sphere looks the same from every side.
      const Vec3 pole = scene_.camera.up(), e1 = scene_.camera.right(), e2 = scene_.camera.back();
      constexpr int kMeridians = 6, kParallels = 5;
      for (int m = 0; m < kMeridians; ++m) {
        const double t = std::numbers::pi * (m + 0.5) / kMeridians;
        freeArcs({b.centre_A, b.radius_A * pole, b.radius_A * (std::cos(t) * e1 + std::sin(t) * e2)}, ring);
      }
      for (int p = 1; p <= kParallels; ++p) {
        const double t = std::numbers::pi * (double(p) / (kParallels + 1) - 0.5);
        const double r = b.radius_A * std::cos(t);
        freeArcs({b.centre_A + b.radius_A * std::sin(t) * pole, r * e1, r * e2}, ring);
      }
      // The outline as seen from the eye: a circle slightly nearer than the centre.
      const Vec3 to_eye = scene_.camera.eye().A - b.centre_A;
      const double d = glm::length(to_eye);
      if (d > b.radius_A) {
        const Vec3 axis = to_eye / d, u = anyNormal(axis);
        const double r = b.radius_A * std::sqrt(1 - b.radius_A * b.radius_A / (d * d));
        Stroke outline = ring;
        outline.width_px += 0.5f;
        outline.alpha = std::min(1.0f, 1.35f * outline.alpha);
        freeArcs({b.centre_A + axis * (b.radius_A * b.radius_A / d), r * u, r * glm::cross(axis, u)}, outline);
      }
    }
  }

  void facets(const SphereMesh& mesh) {
    // The atoms in contact, then the nearest; fewer atoms are faster to draw and easier to read.
    std::vector<std::uint32_t> near = in_use_;
    for (const std::uint32_t a : nearestAtoms(model_, {focus_}, scene_.probe_A, 2.0, kFacetedAtoms))
      if (near.size() < kFacetedAtoms && !isInUse(a)) near.push_back(a);
    const double share = std::min(1.0, kMaxFacets / double(mesh.faces().size()));
    for (const std::uint32_t a : near) {
      gatherNeighbours(a);
      const Sphere b = inflated(a);
      // The radius of a cap with this fraction of a sphere.
      const double reach = share < 1.0 ? 2.0 * b.radius_A * std::sqrt(share) : 2.0 * b.radius_A + 1.0;
      const double away = glm::length(focus_ - b.centre_A);
      const Vec3 middle = away > 0.0 ? b.centre_A + (focus_ - b.centre_A) * (b.radius_A / away) : focus_;
      for (std::size_t f = 0; f < mesh.faces().size(); ++f) {
        const SphereMesh::Face& face = mesh.faces()[f];
        for (std::size_t k = 0; k < 3; ++k) {
          if (std::size_t(face.across[k]) < f) continue;  // drawn with the neighbouring face
          const Vec3 p = b.centre_A + b.radius_A * mesh.vertices()[std::size_t(face.corners[k])];
          const Vec3 q = b.centre_A + b.radius_A * mesh.vertices()[std::size_t(face.corners[(k + 1) % 3])];
          const double far = glm::length(0.5 * (p + q) - middle);
          if (far > reach) continue;
          const float fading = share < 1.0 ? float(std::clamp(3.0 * (1.0 - far / reach), 0.0, 1.0)) : 1.0f;
          const bool held = isInUse(a);
          freeLine(p, q,
                   {.colour = scene_.theme.surface,
                    .alpha = (held ? 0.95f : 0.5f) * fading * scene_.theme.wire_strength,
                    .hidden = 0.06f,
                    .width_px = held ? 1.4f : 1.1f});
        }
      }
    }
  }

  void circles() {
    eachPair([&](std::uint32_t a, std::uint32_t b) {
      const auto c = circleOf(inflated(a), inflated(b));
      if (!c) return;
      const bool held = holds(a, b);
      const Vec3 u = anyNormal(c->axis);
      const Stroke stroke{
          .colour = held ? scene_.theme.in_use : scene_.theme.surface,
          .alpha = held ? 1.0f : std::min(1.0f, 0.9f * std::min(strength(a), strength(b)) * scene_.theme.wire_strength),
          .hidden = held ? 0.4f : 0.12f,
          .width_px = held ? 2.8f : 1.7f};
      gatherNeighbours(a, b);
      const Arc arc{c->centre_A, c->radius_A * u, c->radius_A * glm::cross(c->axis, u)};
      freeArcs(arc, stroke);
    });
  }

  void points() {
    const double radius = 0.11;
    for (std::size_t i = 0; i < atoms_.size(); ++i)
      for (std::size_t j = i + 1; j < atoms_.size(); ++j)
        for (std::size_t k = j + 1; k < atoms_.size(); ++k) {
          const auto p = pointsOf(inflated(atoms_[i]), inflated(atoms_[j]), inflated(atoms_[k]));
          if (!p) continue;
          gatherNeighbours(atoms_[i], atoms_[j], atoms_[k]);
          const bool held = isInUse(atoms_[i]) && isInUse(atoms_[j]) && isInUse(atoms_[k]);
          for (const Vec3& place : *p)
            if (freedom(place) > -1e-9)
              dots_.push_back({glm::vec3(scene_.camera.toView({place})), float(held ? 1.6 * radius : radius),
                               packColour(held ? scene_.theme.in_use : scene_.theme.surface)});
        }
  }

  void cones() {
    eachPair([&](std::uint32_t a, std::uint32_t b) {
      if (!holds(a, b)) return;
      const auto c = circleOf(inflated(a), inflated(b));
      if (!c) return;
      const Vec3 u = anyNormal(c->axis), v = glm::cross(c->axis, u);
      for (const std::uint32_t apex : {a, b}) {
        const Stroke stroke{.colour = glm::mix(scene_.theme.in_use, scene_.theme.hip, apex == a ? 0.0f : 0.45f),
                            .alpha = 0.75f,
                            .hidden = 0.45f,
                            .width_px = 1.1f};
        constexpr int kLines = 18;
        for (int i = 0; i < kLines; ++i) {
          const double t = kTwoPi * i / kLines;
          strokes_.begin(stroke);
          strokes_.point(glm::vec3(scene_.camera.toView({inflated(apex).centre_A})));
          strokes_.point(
              glm::vec3(scene_.camera.toView({c->centre_A + c->radius_A * (std::cos(t) * u + std::sin(t) * v)})));
        }
      }
      addCircle(strokes_, {.colour = scene_.theme.in_use, .alpha = 0.8f, .hidden = 0.5f, .width_px = 1.4f},
                scene_.camera, c->centre_A, c->axis, c->radius_A);
    });
  }

 private:
  Sphere inflated(std::uint32_t a) const {
    const Sphere b = model_.atomSphere(a);
    return {b.centre_A, b.radius_A + scene_.probe_A};
  }
  bool isInUse(std::uint32_t a) const { return std::find(in_use_.begin(), in_use_.end(), a) != in_use_.end(); }
  bool holds(std::uint32_t a, std::uint32_t b) const { return isInUse(a) && isInUse(b); }

  float strength(std::uint32_t a) const {
    if (!fading_ || isInUse(a)) return 1.0f;
    const Sphere b = inflated(a);
    const double gap = glm::length(b.centre_A - focus_) - b.radius_A;
    return float(std::clamp(1.0 - gap / 4.0, 0.25, 1.0));
  }

  // Gathers the inflated spheres that can cover a part of the named ones.
  template <class... More>
  void gatherNeighbours(std::uint32_t a, More... more) {
    const Sphere b = inflated(a);
    neighbours_.clear();
    model_.visitAtomsNear(b.centre_A, b.radius_A + scene_.probe_A, [&](std::uint32_t i, const Sphere& n) {
      if (i == a || ((i == more) || ...)) return;
      if (n.centre_A == b.centre_A && n.radius_A <= model_.atomSphere(a).radius_A)
        return;  // a duplicate covers nothing
      if (glm::length(n.centre_A - b.centre_A) < b.radius_A + n.radius_A + scene_.probe_A)
        neighbours_.push_back(inflated(i));
    });
  }

  // The distance of a point from the gathered spheres; negative inside.
  double freedom(const Vec3& p) const {
    double smallest = 1e9;
    for (const Sphere& n : neighbours_) smallest = std::min(smallest, glm::length(p - n.centre_A) - n.radius_A);
    return smallest;
  }

  void freeArcs(const Arc& arc, const Stroke& stroke) {
    constexpr int kPieces = 72;
    const auto emit = [&](double t) { strokes_.point(glm::vec3(scene_.camera.toView({arc.at(t)}))); };
    double before = freedom(arc.at(0));
    bool open = false;
    for (int i = 0; i <= kPieces; ++i) {
      const double t = kTwoPi * i / kPieces;
      const double now = freedom(arc.at(t));
      if (i > 0 && (before > 0) != (now > 0)) {
        double out = before > 0 ? t - kTwoPi / kPieces : t, in = before > 0 ? t : t - kTwoPi / kPieces;
        for (int k = 0; k < 16; ++k) {
          const double middle = 0.5 * (out + in);
          (freedom(arc.at(middle)) > 0 ? out : in) = middle;
        }
        if (!open) strokes_.begin(stroke);
        emit(out);
        open = now > 0;
      }
      if (now > 0) {
        if (!open) strokes_.begin(stroke);
        open = true;
        emit(t);
      }
      before = now;
    }
  }

  // Draws the parts of a line outside the gathered spheres.
  void freeLine(const Vec3& p, const Vec3& q, const Stroke& stroke) {
    constexpr double kPiece_A = 0.15;
    const int pieces =
        neighbours_.empty() ? 1 : std::clamp(saturateToInteger<int>(std::ceil(glm::length(q - p) / kPiece_A)), 1, 24);
    bool open = false;
    const auto emit = [&](double t) { strokes_.point(glm::vec3(scene_.camera.toView({p + (q - p) * t}))); };
    for (int i = 0; i < pieces; ++i) {
      const bool free = freedom(p + (q - p) * ((i + 0.5) / pieces)) > 0.0;
      if (free && !open) {
        strokes_.begin(stroke);
        emit(double(i) / pieces);
      }
      if (open && !free) emit(double(i) / pieces);
      open = free;
    }
    if (open) emit(1.0);
  }

  template <class Visit>
  void eachPair(Visit&& visit) {
    for (std::size_t i = 0; i < atoms_.size(); ++i)
      for (std::size_t j = i + 1; j < atoms_.size(); ++j) visit(atoms_[i], atoms_[j]);
  }

  const ViewScene& scene_;
  const MoleculeModel& model_;
  Strokes& strokes_;
  std::vector<LooseSphere>& dots_;
  std::vector<std::uint32_t> in_use_, atoms_;
  std::vector<Sphere> neighbours_;
  Vec3 focus_{0.0};
  bool fading_ = false;
};

}  // namespace

void addHapticShapes(const ViewScene& scene, const MoleculeModel& model, Strokes& strokes,
                     std::vector<LooseSphere>& dots) {
  Drawer drawer(scene, model, strokes, dots);
  if (scene.shown.has(ViewPart::Spheres)) drawer.spheres();
  if (scene.shown.has(ViewPart::Circles)) drawer.circles();
  if (scene.shown.has(ViewPart::Points)) drawer.points();
  if (scene.shown.has(ViewPart::Cones)) drawer.cones();
  if (scene.shown.has(ViewPart::Facets) && scene.facets) drawer.facets(*scene.facets);
}

void addCircle(Strokes& strokes, const Stroke& stroke, const Camera& camera, const Vec3& centre, const Vec3& axis,
               double radius_A, int pieces) {
  const Vec3 u = anyNormal(axis), v = glm::cross(axis, u);
  strokes.begin(stroke);
  for (int i = 0; i <= pieces; ++i) {
    const double t = kTwoPi * (i % pieces) / pieces;
    strokes.point(glm::vec3(camera.toView({centre + radius_A * (std::cos(t) * u + std::sin(t) * v)})));
  }
}

}  // namespace moltact
