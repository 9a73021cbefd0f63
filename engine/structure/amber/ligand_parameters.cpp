#include "engine/structure/amber/ligand_parameters.h"

#include <algorithm>

namespace moltact {
namespace {

using Hybrid = AtomValence::Hybrid;

constexpr GaffType kGaff[] = {
    {"c1", 1.9080f, 0.2100f}, {"c2", 1.9080f, 0.0860f}, {"c3", 1.9080f, 0.1094f}, {"n", 1.8240f, 0.1700f},
    {"o", 1.6612f, 0.2100f},  {"oh", 1.7210f, 0.2104f}, {"os", 1.6837f, 0.1700f}, {"ow", 1.7683f, 0.1520f},
    {"s", 2.0000f, 0.2500f},  {"p5", 2.1000f, 0.2000f}, {"f", 1.7500f, 0.0610f},  {"cl", 1.9480f, 0.2650f},
    {"br", 2.0200f, 0.4200f}, {"i", 2.1500f, 0.5000f},  {"hn", 0.6000f, 0.0157f}, {"ho", 0.0000f, 0.0000f},
    {"hs", 0.6000f, 0.0157f}, {"hp", 0.6000f, 0.0157f}, {"hw", 0.0000f, 0.0000f}, {"hc", 1.4870f, 0.0157f},
    {"h1", 1.3870f, 0.0157f}, {"h2", 1.2870f, 0.0157f}, {"h3", 1.1870f, 0.0157f}, {"ha", 1.4590f, 0.0150f},
    {"h4", 1.4090f, 0.0150f}, {"h5", 1.3590f, 0.0150f},
};

const GaffType* gaff(std::string_view name) {
  return std::find_if(std::begin(kGaff), std::end(kGaff), [&](const GaffType& t) { return t.name == name; });
}

// The electronegativity of an orbital at charge q: a + b q + c q^2, in volts.
struct Electronegativity {
  double a, b, c;
  // The polynomial has its meaning near 0; beyond, no charge may grow without bound.
  double at(double charge_e) const {
    const double q = std::clamp(charge_e, -3.0, 3.0);
    return a + q * (b + q * c);
  }
};
constexpr Electronegativity kHydrogenOrbital{7.17, 6.24, -0.56},
    kCarbon[] = {{7.98, 9.18, 1.88}, {8.79, 9.32, 1.51}, {10.39, 9.45, 0.73}},
    kNitrogen[] = {{11.54, 10.82, 1.36}, {12.87, 11.15, 0.85}, {15.68, 11.70, -0.27}},
    kConjugatedNitrogen{12.32, 11.20, 1.34}, kOxygen[] = {{14.18, 12.92, 1.39}, {17.07, 13.79, 0.47}},
    kFluorine{14.66, 13.85, 2.31}, kPhosphorus{8.90, 8.24, 0.96}, kSulphur{10.14, 9.13, 1.38},
    kSulphone{12.00, 10.805, 1.195}, kChlorine{11.00, 9.69, 1.35}, kBromine{10.08, 8.47, 1.16},
    kIodine{9.90, 7.96, 0.96};
// The electronegativity of a hydrogen's cation, which the polynomial does not give.
constexpr double kProton_V = 20.02;

const Electronegativity* electronegativity(int atomic_number, const AtomValence& v) {
  switch (atomic_number) {
    case 1:
      return &kHydrogenOrbital;
    case 6:
      return &kCarbon[int(v.hybrid)];
    case 7:
      return v.conjugated ? &kConjugatedNitrogen : &kNitrogen[int(v.hybrid)];
    case 8:
      return &kOxygen[v.hybrid == Hybrid::Sp3 ? 0 : 1];
    case 9:
      return &kFluorine;
    case 15:
      return &kPhosphorus;
    case 16:
    case 34:
      return v.sulfone ? &kSulphone : &kSulphur;
    case 17:
      return &kChlorine;
    case 35:
      return &kBromine;
    case 53:
      return &kIodine;
    default:
      return nullptr;
  }
}

bool withdraws(int atomic_number) {
  return atomic_number == 7 || atomic_number == 8 || atomic_number == 9 || atomic_number == 16 || atomic_number == 17 ||
         atomic_number == 35 || atomic_number == 53;
}

}  // namespace

const GaffType* gaffType(const Molecule& m, std::span<const AtomValence> valences, std::uint32_t atom,
                         std::span<const std::uint32_t> neighbours, std::span<const std::uint32_t> around) {
  const AtomValence& v = valences[atom];
  const auto hydrogen = [&](std::uint32_t i) { return m.atoms[i].atomic_number == 1; };
  switch (m.atoms[atom].atomic_number) {
    case 1: {
      if (neighbours.empty()) return gaff("hc");
      switch (m.atoms[neighbours[0]].atomic_number) {
        case 6: {
          const auto pulls = std::count_if(around.begin(), around.end(),
                                           [&](std::uint32_t i) { return withdraws(m.atoms[i].atomic_number); });
          if (valences[neighbours[0]].hybrid == Hybrid::Sp3)
            return gaff(pulls == 0 ? "hc" : pulls == 1 ? "h1" : pulls == 2 ? "h2" : "h3");
          return gaff(pulls == 0 ? "ha" : pulls == 1 ? "h4" : "h5");
        }
        case 7:
          return gaff("hn");
        case 8:
          return gaff(std::count_if(around.begin(), around.end(), hydrogen) == 2 ? "hw" : "ho");
        case 15:
          return gaff("hp");
        default:
          return gaff("hs");
      }
    }
    case 6:
      return gaff(v.hybrid == Hybrid::Sp3 ? "c3" : v.hybrid == Hybrid::Sp2 ? "c2" : "c1");
    case 7:
      return gaff("n");
    case 8: {
      const auto own = std::count_if(neighbours.begin(), neighbours.end(), hydrogen) + v.hydrogens;
      return gaff(own >= 2 ? "ow" : own == 1 ? "oh" : v.multiple || neighbours.size() < 2 ? "o" : "os");
    }
    case 9:
      return gaff("f");
    case 15:
      return gaff("p5");
    case 16:
      return gaff("s");
    case 17:
      return gaff("cl");
    case 35:
      return gaff("br");
    case 53:
      return gaff("i");
    default:
      return nullptr;
  }
}

bool hasElectronegativity(int atomic_number) { return electronegativity(atomic_number, {}) != nullptr; }

GasteigerCharges gasteigerCharges(const Molecule& m, std::span<const Bond> bonds, const std::vector<char>& wanted,
                                  std::span<const AtomValence> valences) {
  constexpr int kIterations = 6;
  constexpr double kDamping = 0.5;
  const std::size_t n = m.atoms.size();
  const auto orbital = [&](std::uint32_t i) {
    return wanted[i] ? electronegativity(m.atoms[i].atomic_number, valences[i]) : nullptr;
  };
  std::vector<double> q(n, 0.0), of_hydrogen(n, 0.0), next(n), next_of_hydrogen(n);
  for (std::size_t i = 0; i < n; ++i)
    if (wanted[i]) q[i] = double(valences[i].formal_e);
  const auto cation = [](const Electronegativity* e) { return e == &kHydrogenOrbital ? kProton_V : e->at(1.0); };
  double damping = 1.0;
  for (int k = 0; k < kIterations; ++k) {
    damping *= kDamping;
    next = q, next_of_hydrogen = of_hydrogen;
    // Electrons flow from the less electronegative atom; its cation gives the scale.
    const auto flow = [&](const Electronegativity* a, double qa, const Electronegativity* b, double qb) {
      const double difference = b->at(qb) - a->at(qa);
      return difference / cation(difference > 0.0 ? a : b) * damping;
    };
    for (const Bond& b : bonds) {
      const Electronegativity *one = orbital(b.first), *other = orbital(b.second);
      if (!one || !other || b.order == BondOrder::Coordination) continue;
      const double moved = flow(one, q[b.first], other, q[b.second]);
      next[b.first] += moved, next[b.second] -= moved;
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      const Electronegativity* own = orbital(i);
      if (!own || valences[i].hydrogens == 0) continue;
      const double moved = flow(&kHydrogenOrbital, of_hydrogen[i], own, q[i]);
      next_of_hydrogen[i] += moved, next[i] -= moved * valences[i].hydrogens;
    }
    q.swap(next), of_hydrogen.swap(next_of_hydrogen);
  }
  return {{q.begin(), q.end()}, {of_hydrogen.begin(), of_hydrogen.end()}};
}

}  // namespace moltact
