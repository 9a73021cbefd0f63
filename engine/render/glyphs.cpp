#include "engine/render/glyphs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "engine/core/sphere_intersections.h"
#include "engine/core/units.h"
#include "engine/gltf/gltf_file.h"
#include "engine/render/contact_shadow.h"
#include "engine/render/haptic_shapes.h"

namespace moltact {
namespace {

// Bright on a dark edge: visible on atoms of every colour in every theme.
const Colour kTouchedRing{1.0f, 0.94f, 0.62f};

constexpr double kGlow_A = 0.25;  // width of the strongest glow around an atom in contact with a body
constexpr std::size_t kMaxGhostAtoms =
    400;  // the outline of a larger body is not drawn: each arc is compared with each atom

class Maker {
 public:
  Maker(const ViewScene& scene, Glyphs& out) : scene_(scene), out_(out) {
    touching_ = scene.hip && scene.contact.touching();
    if (!scene.hip) return;
    apart_ = touching_ || scene.coupled;
    scp_ = heldPlace(scene)->A;
    outward_ = scene.contact.outward();
    if (!touching_ || outward_ == Vec3(0.0)) outward_ = scene.camera.up();
    const Vec3& displacement = scene.contact.displacement_A;
    if (const double length = glm::length(displacement); touching_)
      along_force_ = length > 1e-9 ? displacement / length : outward_;
    if (const double field = glm::length(scene.field_direction); field > 0.0)
      along_force_ = scene.field_direction / field;
  }

  void shadow() {
    out_.shadow_centre = view(scp_);
    out_.shadow_radius = float(std::max(held().reach_A(), 0.12));
  }

  // The oxygen lies at the centre of the felt sphere. The hydrogens point away from the surface, spread in the plane
  // that the viewer sees best. The probe's colours occur in no molecule, and its rim is bright on a dark edge, so that
  // it stands out against atoms of every colour.
  void probe() {
    const bool water = scene_.water && std::abs(scene_.probe_A - kWaterProbe_A) < 0.35;
    shell(scp_, std::max(scene_.probe_A, 0.12), scene_.theme.probe, 0.9f);
    const Vec3 centre = silhouetteCentre(scp_, scene_.probe_A);
    const double radius = silhouetteRadius(scp_, scene_.probe_A);
    for (const Stroke& stroke : {Stroke{.colour = glm::vec3(0.0f), .alpha = 0.45f, .hidden = 0.35f, .width_px = 4.4f},
                                 Stroke{.colour = glm::mix(scene_.theme.probe, glm::vec3(1.0f), 0.35f),
                                 .alpha = 1.0f,
                                 .hidden = 0.45f,
                                 .width_px = 2.0f}})
      addCircle(out_.strokes, stroke, scene_.camera, centre, toEye(scp_), radius);
    if (!water) return;
    Vec3 side = glm::cross(toEye(scp_), outward_);
    side = glm::length(side) > 1e-3 ? glm::normalize(side) : anyNormal(outward_);
    const double half = 0.5 * kWaterAngle_deg * std::numbers::pi / 180;
    solid(scp_, 0.62, scene_.theme.probe, 0.35f);
    for (const double sign : {-1.0, 1.0})
      solid(scp_ + kWaterBond_A * (std::cos(half) * outward_ + sign * std::sin(half) * side), 0.44, Colour(0.97f),
            0.35f);
  }

  // The body in the hand replaces the probe: the molecule's atoms at the positions given by the springs, with carbon in
  // the probe's colour, which occurs in no molecule. Hidden parts show through.
  void body(const MoleculeModel& model) {
    const Vec3 middle = scene_.body_place ? scene_.body_place->A : scp_;
    const glm::dmat3 axes = glm::mat3_cast(scene_.body_orientation);
    for (std::size_t i = 0; i < scene_.body->atoms.size(); ++i) {
      const std::uint32_t atom = scene_.body->atoms[i];
      if (atom >= model.atoms()) continue;
      constexpr std::uint32_t kGhost = 0x4Cu << 24;
      const bool carbon = scene_.molecule->atoms[atom].atomic_number == 6;
      const double load = loadOf(scene_.body_stopped, std::uint32_t(i));
      const bool stopped = load > 0.0;
      const std::uint32_t colour = stopped  ? packColour(forceColour(scene_.theme, 1.0))
                                   : carbon ? packColour(scene_.theme.probe)
                                            : model.colour[model.sphereOf(atom)];
      const Vec3 place = middle + axes * scene_.body->spheres[i].centre_A;
      const glm::vec3 centre = view(place);
      const auto radius = float(model.atomSphere(atom).radius_A);
      if (stopped) glow(place, double(radius), load);
      out_.solid.push_back({centre, radius, colour});
      out_.ghost.push_back({centre, radius, (colour & 0xFFFFFFu) | kGhost});
    }
  }

  // The atoms that stop the body glow like those that they stop; not if the molecule must be felt without being seen.
  void stoppers(const MoleculeModel& model) {
    for (const LoadedAtom& one : scene_.stopped_by) {
      if (one.atom >= model.atoms() || isHidden(one.atom)) continue;
      const Sphere b = model.atomSphere(one.atom);
      glow(b.centre_A, b.radius_A, loadOf(scene_.stopped_by, one.atom));
    }
  }

  // The atoms whose field is felt.
  void fieldAtoms(const MoleculeModel& model) {
    double greatest = 0.0;
    for (const auto* atoms : {&scene_.attracting, &scene_.repelling})
      for (const LoadedAtom& one : *atoms) greatest = std::max(greatest, one.share);
    if (!(greatest > 0.0)) return;
    for (const auto& [atoms, colour] :
         {std::pair{&scene_.attracting, scene_.theme.attracts}, std::pair{&scene_.repelling, scene_.theme.repels}})
      for (const LoadedAtom& one : *atoms) {
        if (one.atom >= model.atoms() || isHidden(one.atom)) continue;
        const Sphere b = model.atomSphere(one.atom);
        glow(b.centre_A, b.radius_A, one.share / greatest, colour);
      }
  }

  void heldLines() {
    if (scene_.held_lines) addLines(*scene_.held_lines, scene_.camera, scene_.theme, out_.strokes);
  }

  // The body at the hand's pose: the springs pull from the drawn body to there.
  void ghost(const MoleculeModel& model) {
    if (scene_.hand_orientation && scene_.body)
      outline(model, scene_.hip->A, glm::mat3_cast(*scene_.hand_orientation), scene_.theme.hip);
  }

  void markedPose(const MoleculeModel& model) {
    if (scene_.marked_place && scene_.body)
      outline(model, scene_.marked_place->A, glm::mat3_cast(scene_.marked_orientation), scene_.theme.target);
  }

  // The body at another pose, as the outlines of its atoms, where that differs visibly from the drawn one. Parts of an
  // outline in front of or behind another atom of it are omitted.
  void outline(const MoleculeModel& model, const Vec3& there, const glm::dmat3& turned, const Colour& colour) {
    const Vec3 middle = scene_.body_place ? scene_.body_place->A : scp_;
    const glm::dmat3 axes = glm::mat3_cast(scene_.body_orientation);
    const double visible_A = sized(kMinGhost_A, kMinGhost_px);
    const std::vector<Sphere>& spheres = scene_.body->spheres;
    if (spheres.size() > kMaxGhostAtoms || spheres.size() != scene_.body->atoms.size()) return;
    std::vector<Sphere> at;
    double farthest_A = 0.0;
    for (std::size_t i = 0; i < spheres.size(); ++i) {
      const Vec3 place = there + turned * spheres[i].centre_A;
      farthest_A = std::max(farthest_A, glm::distance(place, middle + axes * spheres[i].centre_A));
      const std::uint32_t atom = scene_.body->atoms[i];
      if (atom < model.atoms()) at.push_back({place, model.atomSphere(atom).radius_A});
    }
    if (farthest_A < visible_A) return;
    const Vec3 eye = scene_.camera.eye().A;
    // Whether the ray from the eye through p meets another atom of the outline.
    const auto covered = [&](const Vec3& p, std::size_t self) {
      const Vec3 ray = glm::normalize(p - eye);
      for (std::size_t j = 0; j < at.size(); ++j) {
        if (j == self) continue;
        const Vec3 to = at[j].centre_A - eye;
        const Vec3 off = to - ray * glm::dot(to, ray);
        if (glm::dot(off, off) < at[j].radius_A * at[j].radius_A) return true;
      }
      return false;
    };
    constexpr int kPieces = 60;
    std::array<bool, kPieces + 1> open{};
    std::array<glm::vec3, kPieces + 1> points{};
    for (std::size_t i = 0; i < at.size(); ++i) {
      const Vec3 centre = silhouetteCentre(at[i].centre_A, at[i].radius_A), axis = toEye(at[i].centre_A);
      const double r = silhouetteRadius(at[i].centre_A, at[i].radius_A);
      const Vec3 u = anyNormal(axis), v = glm::cross(axis, u);
      for (int k = 0; k <= kPieces; ++k) {
        const double t = kTwoPi * (k % kPieces) / kPieces;
        const Vec3 p = centre + r * (std::cos(t) * u + std::sin(t) * v);
        open[std::size_t(k)] = !covered(p, i);
        points[std::size_t(k)] = view(p);
      }
      for (const Stroke& stroke : {Stroke{.colour = glm::vec3(0.0f), .alpha = 0.45f, .hidden = 0.35f, .width_px = 3.6f},
                                   Stroke{.colour = colour, .alpha = 0.95f, .hidden = 0.7f, .width_px = 1.8f}}) {
        bool drawing = false;
        for (std::size_t k = 0; k <= kPieces; ++k) {
          if (open[k] && !drawing) out_.strokes.begin(stroke);
          if (open[k]) out_.strokes.point(points[k]);
          drawing = open[k];
        }
      }
    }
  }

  // The torque as an arc with a head about its axis through the body's middle, right-handed.
  void torque() {
    const double size = glm::length(scene_.torque_N_A);
    if (!scene_.body || !(size > 0.0) || !std::isfinite(size)) return;
    const Vec3 axis = scene_.torque_N_A / size, middle = scene_.body_place ? scene_.body_place->A : scp_;
    const double thick = sized(0.10, 1.9), head = 4.2 * thick;
    const double r = std::max(radiusOfGyration_A(*scene_.body), sized(0.0, kMinTorqueArc_px));
    const double angle = std::min(size * scene_.arrow_A_per_N / (r * r), kMaxTorqueArc_rad);
    if (angle * r < 0.3 * head) return;
    // The arc's middle is where it is nearest to the eye.
    Vec3 front = toEye(middle);
    front -= axis * glm::dot(front, axis);
    const Vec3 u = glm::length(front) > 1e-3 ? glm::normalize(front) : anyNormal(axis), v = glm::cross(axis, u);
    const auto at = [&](double t) { return middle + r * (std::cos(t) * u + std::sin(t) * v); };
    const double strength = scene_.strongest_N > 0 ? size / (r * scene_.strongest_N) : 0.0;
    const std::uint32_t colour = packColour(forceColour(scene_.theme, strength));
    const int pieces = std::max(2, int(std::ceil(angle / 0.12)));
    // Inside the body the arc shows through as a line.
    out_.strokes.begin(
        {.colour = forceColour(scene_.theme, strength), .alpha = 1.0f, .hidden = 0.6f, .width_px = 2.6f});
    for (int k = 0; k <= pieces; ++k) out_.strokes.point(view(at(angle * (double(k) / pieces - 0.5))));
    for (int k = 0; k < pieces; ++k)
      out_.cones.push_back({view(at(angle * (double(k) / pieces - 0.5))), view(at(angle * ((k + 1.0) / pieces - 0.5))),
                            float(thick), float(thick), colour});
    const Vec3 neck = at(0.5 * angle), along = std::cos(0.5 * angle) * v - std::sin(0.5 * angle) * u;
    out_.cones.push_back({view(neck), view(neck + along * head), float(2.3 * thick), 0.0f, colour});
  }

  void hip() {
    const double r = sized(0.22, 4.5);
    solid(scene_.hip->A, r, scene_.theme.hip, 0.75f);
    if (!apart_) return;
    // Seen along the push, the probe is in front of the hand: a ring on it shows how far the hand has penetrated.
    addCircle(out_.strokes, {.colour = scene_.theme.hip, .alpha = 0.95f, .hidden = 0.9f, .width_px = 2.4f},
              scene_.camera, scene_.hip->A, toEye(scene_.hip->A), 1.5 * r, 48);
    spring();
  }

  // From the HIP to the SCP: a coil whose thickness and colour indicate the force.
  void spring() {
    const Vec3 displacement = scp_ - scene_.hip->A;
    const double length = glm::length(displacement), thick = sized(0.13, 2.6) * (1.0 + 0.6 * strength());
    const Colour colour = forceColour(scene_.theme, strength());
    const Vec3 axis = length > 1e-9 ? displacement / length : outward_, u = anyNormal(axis), v = glm::cross(axis, u);
    constexpr int kTurns = 7, kPieces = 16 * kTurns;
    for (const bool under : {true, false}) {
      out_.strokes.begin({.colour = under ? Colour(0.0f) : colour,
                          .alpha = under ? 0.4f : 1.0f,
                          .hidden = under ? 0.5f : 0.8f,
                          .width_px = float(under ? 3.8 : 1.8) + float(strength())});
      for (int i = 0; i <= kPieces; ++i) {
        const double t = double(i) / kPieces, turn = kTwoPi * kTurns * t;
        const double wide = thick * std::min(1.0, 8.0 * std::min(t, 1.0 - t));
        out_.strokes.point(view(scene_.hip->A + displacement * t + wide * (std::cos(turn) * u + std::sin(turn) * v)));
      }
    }
  }

  // From below the line of sight, like a pen held in front of a screen; of equal size in every picture.
  void hand() {
    if (!scene_.hand) return;
    const float side = scene_.left_hand ? -1.0f : 1.0f;
    const glm::vec3 body = glm::normalize(glm::vec3(0.62f * side, -0.50f, 0.60f));
    const glm::vec3 over = glm::normalize(glm::cross(glm::cross(body, glm::vec3(-0.35f * side, 0.75f, 0.55f)), body));
    const glm::mat3 turn(glm::cross(body, over), body, over);
    const float extent = scene_.hand->high.y - scene_.hand->low.y;
    if (!(extent > 0)) return;
    const double depth = std::max(0.1, -scene_.camera.toView(*scene_.hip).z);
    const auto scale = float(kHandLength_px * scene_.camera.pixel_A(depth, 800)) / extent;
    glm::mat4 place(turn * scale);
    place[3] = glm::vec4(view(scene_.hip->A), 1.0f);
    out_.models.push_back({scene_.hand.get(), place});
  }

  void scp() {
    if (!apart_) return;
    const double r = sized(0.14, 3.2);
    solid(scp_, r, scene_.theme.scp, 0.85f);
    addCircle(out_.strokes, {.colour = scene_.theme.scp, .alpha = 0.9f, .hidden = 0.8f, .width_px = 1.6f},
              scene_.camera, scp_, toEye(scp_), 2.1 * r, 48);
  }

  // A ring around the probe, whose size and colour indicate the force, and an arrow along it. Toward the eye the arrow
  // would be unrecognizable, so a sign replaces it.
  void force() {
    if (along_force_ == Vec3(0.0) || !(scene_.force_N > 0) || !std::isfinite(scene_.force_N)) return;
    const Colour warm = forceColour(scene_.theme, strength());
    // Around the probe; a body shows its contacts by its atoms.
    const double round = silhouetteRadius(scp_, scene_.probe_A) + sized(0.06, 4.0) + sized(0.3, 9.0) * strength();
    for (const Stroke& stroke :
         {Stroke{.colour = glm::vec3(0.0f), .alpha = 0.35f, .hidden = 0.5f, .width_px = float(4.0 + 5.0 * strength())},
          Stroke{.colour = warm, .alpha = 1.0f, .hidden = 0.6f, .width_px = float(2.0 + 5.0 * strength())}})
      if (!scene_.body) addCircle(out_.strokes, stroke, scene_.camera, scp_, toEye(scp_), round);
    constexpr double kTowardEye = 0.87;  // within 30 degrees of the line of sight
    if (const double toward = glm::dot(along_force_, toEye(scp_)); std::abs(toward) > kTowardEye) {
      headOn(toward > 0.0, warm);
      return;
    }
    const double thick = sized(0.13, 2.4), head = 4.2 * thick;
    const double length = std::max(scene_.force_N * scene_.arrow_A_per_N, 0.3 * head);
    const Vec3 tip = scp_ + along_force_ * (length + head);
    const Vec3 neck = scp_ + along_force_ * length;
    const std::uint32_t colour = packColour(warm);
    out_.cones.push_back({view(scp_), view(neck), float(thick), float(thick), colour});
    out_.cones.push_back({view(neck), view(tip), float(2.3 * thick), 0.0f, colour});
  }

  // A vector along the line of sight in the notation of drawings: a ring with a dot (toward the viewer) or a cross
  // (away). It lies in front of the probe and grows with the force like the arrow, up to an eighth of the picture.
  void headOn(bool toward, const Colour& warm) {
    const Vec3 eye = toEye(scp_), right = scene_.camera.right(), up = glm::cross(eye, right);
    const Vec3 at = scp_ + eye * (held().reach_A() + 0.3);
    const double r =
        std::min(std::max(sized(0.3, 13.0), 0.4 * scene_.force_N * scene_.arrow_A_per_N), sized(0.0, 100.0));
    const auto draw = [&](const auto& lines) {
      for (const Stroke& stroke : {Stroke{.colour = glm::vec3(0.0f), .alpha = 0.55f, .hidden = 0.55f, .width_px = 5.0f},
                                   Stroke{.colour = warm, .alpha = 1.0f, .hidden = 1.0f, .width_px = 2.6f}})
        lines(stroke);
    };
    draw([&](const Stroke& s) { addCircle(out_.strokes, s, scene_.camera, at, eye, r, 48); });
    if (toward) {
      solid(at, std::min(0.3 * r, sized(0.3, 9.0)), warm, 1.0f);
      return;
    }
    for (const double side : {-1.0, 1.0})
      draw([&](const Stroke& s) {
        const Vec3 arm = r * std::numbers::sqrt2 * 0.5 * (right + side * up);
        out_.strokes.begin(s);
        out_.strokes.point(view(at - arm));
        out_.strokes.point(view(at + arm));
      });
  }

  // The probe where a guide leads it, and a dashed line to there. Both show through the molecule.
  void ledProbe() {
    if (!scene_.ghost || scene_.body) return;
    const Vec3 at = scene_.ghost->A;
    const double r = std::max(scene_.probe_A, sized(0.1, 3.0));
    shell(at, r, scene_.theme.target, 0.35f);
    addCircle(out_.strokes, {.colour = scene_.theme.target, .alpha = 1.0f, .hidden = 0.8f, .width_px = 2.6f},
              scene_.camera, silhouetteCentre(at, r), toEye(at), silhouetteRadius(at, r));
    constexpr int kDashes = 6;
    for (int k = 0; k < kDashes; ++k) {
      out_.strokes.begin({.colour = scene_.theme.target, .alpha = 0.9f, .hidden = 0.7f, .width_px = 2.0f});
      for (const double part : {(k + 0.25) / kDashes, (k + 0.75) / kDashes})
        out_.strokes.point(view(scp_ + (at - scp_) * part));
    }
  }

  void targets() {
    for (const TargetMarker& t : scene_.targets) {
      const Colour colour = t.reached ? scene_.theme.force : scene_.theme.target;
      const double r = std::max(t.radius_A, 0.05);
      shell(t.centre.A, r, colour, 0.75f);
      const Vec3 eye = toEye(t.centre.A);
      addCircle(out_.strokes, {.colour = colour, .alpha = 1.0f, .hidden = 0.55f, .width_px = 2.6f}, scene_.camera,
                silhouetteCentre(t.centre.A, r), eye, silhouetteRadius(t.centre.A, r));
      addCircle(out_.strokes, {.colour = colour, .alpha = 0.55f, .hidden = 0.3f, .width_px = 1.4f}, scene_.camera,
                t.centre.A, eye, r + sized(0.35, 7.0));
    }
  }

  // A ring around each of a few atoms. Many atoms are marked by colour only, because hundreds of rings hide them and
  // dominate the drawing time.
  void highlights(const MoleculeModel& model) {
    constexpr std::size_t kMaxRings = 120;
    if (scene_.highlighted.size() > kMaxRings) return;
    for (const std::uint32_t a : scene_.highlighted) {
      if (a >= model.atoms()) continue;
      const Sphere b = model.atomSphere(a);
      // An atom in the hand has left this place, which is drawn as a ghost.
      if (scene_.body && std::binary_search(scene_.body->atoms.begin(), scene_.body->atoms.end(), a)) {
        shell(b.centre_A, b.radius_A, scene_.theme.target, 0.50f);
        continue;
      }
      const double r = b.radius_A + 0.12;
      addCircle(out_.strokes, {.colour = scene_.theme.target, .alpha = 0.95f, .hidden = 0.22f, .width_px = 2.4f},
                scene_.camera, silhouetteCentre(b.centre_A, r), toEye(b.centre_A), silhouetteRadius(b.centre_A, r));
    }
  }

  // A ring around each atom that blocks the probe; not if the molecule must be felt without being seen.
  void touched(const MoleculeModel& model) {
    if (!touching_) return;
    for (const std::int32_t a : scene_.named_atoms.value_or(scene_.contact.atoms)) {
      if (a < 0 || std::size_t(a) >= model.atoms() || isHidden(std::uint32_t(a))) continue;
      const Sphere b = model.atomSphere(std::uint32_t(a));
      const double ring = b.radius_A + 0.10;
      for (const Stroke& stroke : {Stroke{.colour = glm::vec3(0.0f), .alpha = 0.55f, .hidden = 0.3f, .width_px = 4.6f},
                                   Stroke{.colour = kTouchedRing, .alpha = 1.0f, .hidden = 0.3f, .width_px = 2.2f}})
        addCircle(out_.strokes, stroke, scene_.camera, silhouetteCentre(b.centre_A, ring), toEye(b.centre_A),
                  silhouetteRadius(b.centre_A, ring));
    }
  }

  HandShape held() const {
    return scene_.body ? HandShape(*scene_.body, scene_.body_orientation) : HandShape(scene_.probe_A);
  }
  bool hasHip() const { return scene_.hip.has_value(); }
  // The force as a fraction of the strongest, 0 to 1.
  double strength() const {
    return scene_.force_N > 0 && scene_.strongest_N > 0 ? std::min(1.0, scene_.force_N / scene_.strongest_N) : 0.0;
  }

 private:
  bool isHidden(std::uint32_t atom) const {
    const AtomList& hidden = scene_.look.hidden;
    return hidden && std::binary_search(hidden->begin(), hidden->end(), atom);
  }
  // The load of an atom as a fraction of the greatest; 0: none.
  static double loadOf(const std::vector<LoadedAtom>& loads, std::uint32_t atom) {
    double own = 0.0, greatest = 0.0;
    for (const LoadedAtom& one : loads) {
      greatest = std::max(greatest, one.share);
      if (one.atom == atom) own = one.share;
    }
    return greatest > 0.0 ? own / greatest : 0.0;
  }
  void glow(const Vec3& place, double radius_A, double load) {
    glow(place, radius_A, load, forceColour(scene_.theme, 1.0));
  }
  void glow(const Vec3& place, double radius_A, double load, const Colour& colour) {
    shell(place, radius_A + kGlow_A * (0.4 + 0.6 * load), colour, float(0.15 + 0.4 * load));
  }
  glm::vec3 view(const Vec3& p) const { return glm::vec3(scene_.camera.toView({p})); }
  Vec3 toEye(const Vec3& p) const { return glm::normalize(scene_.camera.eye().A - p); }
  // A size in angstroms of at least `min_px` pixels, so that it is visible in a large molecule.
  double sized(double A, double min_px) const {
    // Pixels refer to a picture of 800 rows, so that small and large pictures look alike.
    const double depth = std::max(0.1, -scene_.camera.toView({scp_}).z);
    return std::max(A, min_px * scene_.camera.pixel_A(depth, 800));
  }
  Vec3 silhouetteCentre(const Vec3& p, double r) const {
    const double d = glm::length(scene_.camera.eye().A - p);
    return d > r ? p + toEye(p) * (r * r / d) : p;
  }
  double silhouetteRadius(const Vec3& p, double r) const {
    const double d = glm::length(scene_.camera.eye().A - p);
    return d > r ? r * std::sqrt(1 - r * r / (d * d)) : r;
  }
  void solid(const Vec3& p, double r, const Colour& colour, float ghost) {
    out_.solid.push_back({view(p), float(r), packColour(colour)});
    if (ghost > 0) out_.ghost.push_back({view(p), float(r), packColour(colour, ghost)});
  }
  void shell(const Vec3& p, double r, const Colour& colour, float alpha) {
    out_.shell.push_back({view(p), float(r), packColour(colour, alpha)});
  }

  const ViewScene& scene_;
  Glyphs& out_;
  bool touching_ = false, apart_ = false;  // apart_: the held probe is drawn apart from the HIP
  Vec3 scp_{0.0}, outward_{0, 1, 0};
  Vec3 along_force_{0.0};  // zero: no force
};

}  // namespace

void Glyphs::clear() {
  solid.clear();
  ghost.clear();
  shell.clear();
  cones.clear();
  models.clear();
  strokes.clear();
  shadow_radius = 0;
}

void Glyphs::addTo(PixelBoxBuilder& box) const {
  for (const auto* spheres : {&solid, &ghost, &shell})
    for (const LooseSphere& s : *spheres) box.add(s.centre, s.radius);
  for (const GlyphCone& c : cones) {
    box.add(c.a, c.radius_a);
    box.add(c.b, c.radius_b);
  }
  for (const GlyphModel& m : models) {
    const glm::vec3 middle = 0.5f * (m.model->low + m.model->high);
    const float reach = glm::distance(m.model->low, m.model->high) * 0.5f * glm::length(glm::vec3(m.to_view[0]));
    box.add(glm::vec3(m.to_view * glm::vec4(middle, 1.0f)), reach);
  }
  for (const Strokes::Line& line : strokes.lines())
    for (std::size_t i = line.begin; i < line.end; ++i) box.add(strokes[i], 0.0f);
  if (shadow_radius > 0) box.add(shadow_centre, shadow_radius * ContactShadow::kReach);
}

void addGlyphs(const ViewScene& scene, const MoleculeModel* model, Glyphs& glyphs) {
  Maker make(scene, glyphs);
  if (scene.shown.has(ViewPart::Target)) {
    make.targets();
    if (model) make.highlights(*model);
  }
  if (!make.hasHip()) return;
  if (model && scene.shown.has(ViewPart::Atoms)) make.touched(*model);
  if (model && scene.shown.has(ViewPart::Atoms)) make.stoppers(*model);
  if (model && scene.shown.has(ViewPart::Atoms)) make.fieldAtoms(*model);
  if (scene.shown.has(ViewPart::Probe) && !scene.body) make.probe();
  if (scene.shown.has(ViewPart::Probe) && scene.body && model) make.body(*model);
  if (scene.shown.has(ViewPart::Probe) && scene.body && model) make.ghost(*model);
  if (scene.shown.has(ViewPart::Probe) && scene.body && model) make.markedPose(*model);
  if (scene.shown.has(ViewPart::Probe)) make.ledProbe();
  if (scene.shown.has(ViewPart::Probe)) make.hand();
  if (model && scene.shown.has(ViewPart::Probe)) make.shadow();
  if (scene.shown.has(ViewPart::Hip)) make.hip();
  if (scene.shown.has(ViewPart::Scp)) make.scp();
  if (scene.shown.has(ViewPart::Force)) make.force();
  if (scene.shown.has(ViewPart::Force)) make.torque();
  if (scene.shown.has(ViewPart::Probe)) make.heldLines();
}

}  // namespace moltact
