#include "engine/bench/energies/field_scenes.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/bench/scenes.h"

namespace moltact::bench {
namespace {

// Argon: the depth of its well is 0.238 kcal/mol at 3.82 A.
constexpr float kArgonHalf_A = 1.91f, kArgonDepth_kcal_mol = 0.238f;
// The contact is where the energy of two such atoms is zero: 2^(-1/6) of the distance of the minimum.
constexpr double kZero = 0.8908987181403393;
constexpr int kHeldInField = 1000;

PairAtom atom(const Vec3& at, float half_A, float depth_kcal_mol, float charge_e = 0.0f) {
  return {at, half_A, depth_kcal_mol, charge_e};
}
PairAtom argon(const Vec3& at, float charge_e = 0.0f) { return atom(at, kArgonHalf_A, kArgonDepth_kcal_mol, charge_e); }

// The path of a hand, composed of straight segments.
struct HandPath {
  std::vector<Vec3> places;
  std::size_t held_from = 0, held_to = 0;
  explicit HandPath(const Vec3& start) : places{start} {}
  HandPath& to(const Vec3& place, double A_per_tick) {
    const Vec3 from = places.back();
    const int n = std::max(1, int(std::ceil(glm::distance(from, place) / A_per_tick)));
    for (int k = 1; k <= n; ++k) places.push_back(from + (place - from) * (double(k) / n));
    return *this;
  }
  /// Stands still in the field.
  HandPath& hold(int ticks) {
    held_from = places.size();
    pause(ticks);
    held_to = places.size();
    return *this;
  }
  HandPath& pause(int ticks) {
    places.insert(places.end(), std::size_t(ticks), Vec3(places.back()));
    return *this;
  }
};

FieldScene scene(std::string name, std::string question, std::vector<PairAtom> atoms, const PairAtom& probe,
                 HandPath path) {
  FieldScene out{.name = std::move(name), .question = std::move(question)};
  for (const PairAtom& a : atoms) out.spheres.push_back({a.centre_A, kZero * double(a.half_minimum_A)});
  out.atoms = std::move(atoms);
  out.probe = probe;
  out.probe_A = kZero * double(probe.half_minimum_A);
  out.path = std::move(path.places);
  out.held_from = path.held_from, out.held_to = path.held_to;
  return out;
}

// Argon's well is shallow; with this it is felt as a third of a newton.
FieldScene magnified(FieldScene s) {
  s.N_per_kcal_mol_A = 2.0;
  return s;
}

FieldScene inVacuum(FieldScene s) {
  s.model.kind = Dielectric::Constant;
  s.model.dielectric = 1.0;
  return s;
}

}  // namespace

std::vector<FieldScene> fieldScenes(std::uint64_t seed, std::size_t draw) {
  const Vec3 far(0.0, 0.0, 12.0);
  std::vector<FieldScene> out;
  out.push_back(
      scene("steep wall at speed", "Does a hand that runs into an atom at 0.5 A a tick stay outside and gain nothing?",
            {argon({0, 0, 0})}, argon({}),
            HandPath({1.0, 0.3, 12.0}).to({1.0, 0.3, -12.0}, 0.5).to({1.0, 0.3, 12.0}, 0.5).pause(kHeldInField)));
  out.push_back(magnified(scene("two wells close together",
                                "Does a slow hand pass from one well into the next without vibration?",
                                {argon({-3.2, 0, 0}), argon({3.2, 0, 0})}, argon({}),
                                HandPath({-2.0, 0, 12.0})
                                    .to({-2.0, 0, 3.4}, 0.01)
                                    .to({2.0, 0, 3.4}, 0.002)
                                    .to({0.0, 0, 3.4}, 0.002)
                                    .hold(kHeldInField)
                                    .to({-2.0, 0, 12.0}, 0.01))));
  out.push_back(
      inVacuum(scene("two charges in vacuum", "Does an attraction of 20 N at contact let the hand rest there?",
                     {argon({0, 0, 0}, 1.0f)}, argon({}, -1.0f),
                     HandPath(far).to({0, 0, 4.0}, 0.01).hold(kHeldInField).to(far, 0.01).pause(kHeldInField))));
  out.push_back(magnified(scene("face of a cell, to and fro",
                                "Is the force continuous where an atom crosses a grid's face again and again?",
                                {argon({0, 0, 0}), argon({3.8, 0, 0})}, argon({}), [&] {
                                  HandPath path(far);
                                  path.to({1.9, 1.0, 3.2}, 0.02);
                                  for (int k = 0; k < 20; ++k) path.to({1.9, 1.3, 3.2}, 0.01).to({1.9, 0.7, 3.2}, 0.01);
                                  return path.to(far, 0.02);
                                }())));
  out.push_back(scene("jump by 5 A", "Does a hand that jumps across an atom and back gain nothing?", {argon({0, 0, 0})},
                      argon({}),
                      HandPath(far)
                          .to({0.5, 0, 2.5 + 1.2}, 0.02)
                          .pause(100)
                          .to({0.5, 0, -1.3}, 5.0)
                          .pause(100)
                          .to({0.5, 0, 3.7}, 5.0)
                          .pause(100)
                          .to(far, 0.02)));
  out.push_back(scene("start inside an atom", "Is there no force before the probe has been outside once?",
                      {argon({0, 0, 0})}, argon({}),
                      HandPath({0.4, 0.1, 0.3}).pause(300).to(far, 0.02).pause(kHeldInField)));
  out.push_back(
      inVacuum(scene("overlapping hydrogen", "Does a charge inside the radius of its atom not capture the probe?",
                     {atom({0, 0, 0}, 1.7683f, 0.152f, -0.834f), atom({0, 0, 0.9572}, 0.0f, 0.0f, 0.417f),
                      atom({0.9266, 0, -0.24}, 0.0f, 0.0f, 0.417f)},
                     atom({}, 1.7683f, 0.152f, -1.0f),
                     HandPath(far).to({0, 0, 1.5}, 0.01).hold(kHeldInField).to(far, 0.01).pause(kHeldInField))));
  FieldScene scaled = inVacuum(
      scene("well deeper than the device bears", "Does a well scaled by 1 N for each kcal/mol/A keep the hand at rest?",
            {argon({0, 0, 0}, 0.5f)}, argon({}, -0.5f),
            HandPath(far).to({0, 0, 3.6}, 0.01).hold(kHeldInField).to(far, 0.01).pause(kHeldInField)));
  scaled.N_per_kcal_mol_A = 1.0;
  out.push_back(std::move(scaled));
  if (draw == 0) return out;
  scenes::Random random(seed * 1000 + draw);
  for (FieldScene& s : out) {
    const Quat by = glm::angleAxis(random.uniform(0.0, kTwoPi), random.direction());
    const Vec3 shift = random.uniform(0.0, 0.375) * random.direction();
    for (Sphere& sphere : s.spheres) sphere.centre_A = by * sphere.centre_A + shift;
    for (PairAtom& a : s.atoms) a.centre_A = by * a.centre_A + shift;
    for (Vec3& place : s.path) place = by * place + shift;
  }
  return out;
}

}  // namespace moltact::bench
