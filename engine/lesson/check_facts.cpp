// Computes the facts of a lesson.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "engine/language/catalogue.h"
#include "engine/lesson/checks.h"
#include "engine/lesson/facts.h"
#include "engine/lesson/passable.h"
#include "engine/lesson/ways_in.h"
#include "engine/structure/measure.h"

namespace moltact {
namespace {

namespace facts {

using Atoms = std::vector<std::uint32_t>;

constexpr double kLargestProbe_A = 20.0;
constexpr std::size_t kMaxPairs = 100'000'000;  // of atoms that a distance compares

// The molecule of a facts block, without the removed atoms.
struct Subject {
  const Molecule& molecule;
  double probe_A;
  std::vector<std::int32_t> kept;  // by atom: its index in `spheres`; -1 if it is removed
  std::vector<Sphere> spheres;
  std::optional<WaysIn> ways;
  std::optional<SphereGrid> grid;

  Subject(const Molecule& whole, const Selection& removed, double probe) : molecule(whole), probe_A(probe) {
    kept.assign(molecule.atoms.size(), 0);
    if (removed.given())
      for (const std::uint32_t a : removed.select(molecule)) kept[a] = -1;
    for (std::size_t a = 0; a < kept.size(); ++a)
      if (kept[a] == 0) {
        kept[a] = static_cast<std::int32_t>(spheres.size());
        spheres.push_back(molecule.spheres[a]);
      }
  }
  WaysIn& waysIn() { return ways ? *ways : ways.emplace(spheres, probe_A); }
  SphereGrid& sphereGrid() { return grid ? *grid : grid.emplace(SharedArray<Sphere>(spheres)); }

  // The selected atoms that are not removed, ascending.
  Atoms select(const Selection& selection) const {
    Atoms out = selection.select(molecule);
    std::erase_if(out, [&](std::uint32_t a) { return kept[a] < 0; });
    return out;
  }
  Atoms inSpheres(const Atoms& atoms) const {
    Atoms out;
    for (const std::uint32_t a : atoms) out.push_back(static_cast<std::uint32_t>(kept[a]));
    return out;
  }
  const Sphere& sphere(std::uint32_t atom) const { return molecule.spheres[atom]; }
  PointA middle(const Atoms& atoms) const {
    Vec3 sum(0.0);
    for (const std::uint32_t a : atoms) sum += sphere(a).centre_A / double(atoms.size());
    return {sum};
  }
};

// A value, or why there is none.
using Computed = Expected<double>;

Computed pairValue(const Subject& s, const std::vector<Atoms>& of, bool largest,
                   const std::function<double(const Sphere&, const Sphere&)>& measure) {
  if (of[0].size() > kMaxPairs / of[1].size())
    return Problem{{}, 0, 0, tr("these are too many pairs of atoms"), tr("select fewer")};
  double best = largest ? -std::numeric_limits<double>::max() : std::numeric_limits<double>::max();
  bool found = false;
  for (const std::uint32_t a : of[0])
    for (const std::uint32_t b : of[1]) {
      if (a == b) continue;
      const double value = measure(s.sphere(a), s.sphere(b));
      if (largest ? value > best : value < best) best = value;
      found = true;
    }
  if (!found) return Problem{{}, 0, 0, tr("both selections are the same atom"), tr("select two atoms")};
  return best;
}

double between(const Sphere& a, const Sphere& b) { return glm::distance(a.centre_A, b.centre_A); }

Computed turn(Subject& s, const std::vector<Atoms>& of) {
  if (of[0].size() != 1 || of[1].size() != 1)
    return Problem{
        {}, 0, 0, tr("the force turns between two atoms, but more are selected"), tr("select one on each side")};
  const Sphere &one = s.sphere(of[0][0]), &other = s.sphere(of[1][0]);
  const double a = one.radius_A + s.probe_A, b = other.radius_A + s.probe_A, d = between(one, other);
  const double cosine = (a * a + b * b - d * d) / (2.0 * a * b);
  if (!(std::abs(cosine) <= 1.0))
    return Problem{
        {}, 0, 0, tr("the probe does not touch both atoms at once"), tr("select neighbours, or a larger probe")};
  return std::acos(cosine) * 180.0 / 3.14159265358979323846;
}

Computed radius(Subject& s, const std::vector<Atoms>& of) {
  for (const std::uint32_t a : of[0])
    if (s.sphere(a).radius_A != s.sphere(of[0][0]).radius_A)
      return Problem{{}, 0, 0, tr("these atoms differ in radius"), tr("select atoms of one element")};
  return s.sphere(of[0][0]).radius_A;
}

Computed outOfPlane(Subject& s, const std::vector<Atoms>& of) {
  const Atoms ring = s.inSpheres(of[1]);
  const std::optional<AtomRing> plane = ringOf(s.sphereGrid(), ring);
  if (!plane) return Problem{{}, 0, 0, tr("a plane needs three atoms or more"), tr("select more behind the ' - '")};
  return std::abs(glm::dot(s.middle(of[0]).A - plane->centre_A, plane->axis));
}

// Both searches: the one of the tasks, which knows creases and pits, and the thorough one.
Computed largest(Subject& s, const std::vector<Atoms>& of) {
  const Atoms atoms = s.inSpheres(of[0]);
  const auto touches = [&](double ball_A) {
    if (!reachablePlaces(s.sphereGrid(), atoms, ball_A, true).empty()) return true;
    const WaysIn ways(s.spheres, ball_A);
    return std::any_of(atoms.begin(), atoms.end(), [&](std::uint32_t a) { return ways.straight(a); });
  };
  // From below, because the searches take longer with a larger probe.
  double least_A = 0.0, most_A = 0.5;
  for (; most_A < kLargestProbe_A && touches(most_A); most_A = std::min(2.0 * most_A, kLargestProbe_A))
    least_A = most_A;
  const std::optional<double> found = largestProbe(least_A, most_A, touches);
  if (!found) return Problem{{}, 0, 0, tr("not even a point touches these atoms from outside"), tr("select others")};
  return *found;
}

template <class Of>
double countOf(const Atoms& atoms, Of&& owner) {
  std::set<std::uint32_t> seen;
  for (const std::uint32_t a : atoms) seen.insert(owner(a));
  return double(seen.size());
}

Computed onAnyPath(Subject& s, const Atoms& atoms, bool share) {
  if (!s.waysIn().searchable())
    return Problem{{}, 0, 0, tr("the molecule is too large for a search on every path"), tr("use 'touched'")};
  if (!share) return double(s.waysIn().crooked(atoms).size());
  if (atoms.size() != 1) return Problem{{}, 0, 0, tr("'share' is about one atom"), tr("select one")};
  return s.waysIn().share(atoms[0]);
}

Computed angle(Subject& s, const std::vector<Atoms>& of) {
  std::vector<PointA> p;
  for (const Atoms& atoms : of) p.push_back(s.middle(atoms));
  return p.size() == 3 ? angle_deg(p[0], p[1], p[2]) : torsion_deg(p[0], p[1], p[2], p[3]);
}

// How each kind of fact is computed. A count may be about no atom; every other kind needs one in each selection.
const std::map<std::string_view, std::function<Computed(Subject&, const std::vector<Atoms>&)>>& computations() {
  static const std::map<std::string_view, std::function<Computed(Subject&, const std::vector<Atoms>&)>> kTable{
      {"atoms", [](Subject&, const auto& of) -> Computed { return double(of[0].size()); }},
      {"residues",
       [](Subject& s, const auto& of) -> Computed {
         return countOf(of[0], [&](std::uint32_t a) { return s.molecule.atoms[a].residue; });
       }},
      {"chains",
       [](Subject& s, const auto& of) -> Computed {
         return countOf(of[0], [&](std::uint32_t a) {
           const std::uint32_t residue = s.molecule.atoms[a].residue;
           return residue < s.molecule.residues.size() ? s.molecule.residues[residue].chain : 0;
         });
       }},
      {"nearest", [](Subject& s, const auto& of) { return pairValue(s, of, false, between); }},
      {"farthest", [](Subject& s, const auto& of) { return pairValue(s, of, true, between); }},
      {"gap",
       [](Subject& s, const auto& of) {
         return pairValue(s, of, false,
                          [](const Sphere& a, const Sphere& b) { return between(a, b) - a.radius_A - b.radius_A; });
       }},
      {"distance",
       [](Subject& s, const auto& of) -> Computed { return glm::distance(s.middle(of[0]).A, s.middle(of[1]).A); }},
      {"out-of-plane", outOfPlane},
      {"radius", radius},
      {"angle", angle},
      {"turn", turn},
      {"touched",
       [](Subject& s, const auto& of) -> Computed { return double(s.waysIn().straight(s.inSpheres(of[0])).size()); }},
      {"reached", [](Subject& s, const auto& of) { return onAnyPath(s, s.inSpheres(of[0]), false); }},
      {"share", [](Subject& s, const auto& of) { return onAnyPath(s, s.inSpheres(of[0]), true); }},
      {"largest", largest},
  };
  return kTable;
}

const KeySpec& keyNamed(std::string_view name) {
  const std::vector<KeySpec>& keys = keysOf(KeyBlock::Facts);
  return *std::find_if(keys.begin(), keys.end(), [&](const KeySpec& k) { return k.name == name; });
}

void judge(Subject& subject, std::string_view kind, const FactSpec& fact, checks::Findings& findings) {
  const KeySpec& key = keyNamed(kind);
  std::vector<Atoms> of;
  for (std::size_t i = 0; i < fact.atoms.size(); ++i) {
    of.push_back(subject.select(fact.atoms[i]));
    if (!of.back().empty() || key.dimension == Dimension::None) continue;
    Problem why = fact.atoms[i].whyEmpty(subject.molecule);
    const Place place = fact.places[i];
    findings.error({place.line, place.column + why.column - 1}, std::move(why.message), std::move(why.remedy));
    return;
  }
  const Computed computed = computations().at(kind)(subject, of);
  if (!computed) {
    findings.error(fact.place, computed.problem().message, computed.problem().remedy);
  } else if (!fact.holds(*computed)) {
    const std::string is = computedText(key, fact, *computed);
    findings.error(fact.place, trf("'{0}' is stated as {1}, but computed as {2}", kind, fact.stated, is),
                   tr("correct the number here and in the text, or select other atoms"));
  }
}

}  // namespace facts
}  // namespace

std::vector<Problem> checkFacts(const Lesson& lesson, const MoleculeByName& molecule) {
  checks::Findings findings{lesson.file, {}, {}};
  for (const Step& step : lesson.steps)
    for (const FactsSpec& block : step.facts) {
      if (findings.enough()) break;
      const auto found = molecule(block.molecule);
      if (!found) {
        findings.error(block.molecule_place, found.problem().message, found.problem().remedy);
        continue;
      }
      if (block.remove.given() && block.remove.select(**found).empty()) {
        Problem why = block.remove.whyEmpty(**found);
        findings.error(block.remove_place, std::move(why.message), std::move(why.remedy));
        continue;
      }
      facts::Subject subject(**found, block.remove, block.probe_A);
      for (const auto& [kind, fact] : block.facts)
        if (!findings.enough()) facts::judge(subject, kind, fact, findings);
    }
  orderProblems(findings.errors);
  return std::move(findings.errors);
}

}  // namespace moltact
