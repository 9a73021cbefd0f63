#include "engine/haptics/field/pair_kernel.h"

#include <cmath>
#include <cstring>

#if defined(__x86_64__) && !defined(_WIN32)  // Windows' GCC does not align the stack for them
#define MOLTACT_HAS_AVX2_LOOP
#endif

namespace moltact {
namespace {

#define MOLTACT_INLINE inline __attribute__((always_inline))

using V8 = float __attribute__((vector_size(32)));
using M8 = int __attribute__((vector_size(32)));

// An energy as a function of t, the squared distance, with its derivatives by t.
struct Curve {
  V8 value, first, second;
};

MOLTACT_INLINE V8 all(float x) { return V8{x, x, x, x, x, x, x, x}; }
MOLTACT_INLINE V8 load(const float* from) {
  V8 out;
  std::memcpy(&out, from, sizeof out);
  return out;
}
MOLTACT_INLINE V8 greater(V8 a, V8 b) { return a > b ? a : b; }
MOLTACT_INLINE V8 smaller(V8 a, V8 b) { return a < b ? a : b; }

MOLTACT_INLINE V8 squareRoot(V8 a) {
  V8 out;
  for (int k = 0; k < PairBlock::kLanes; ++k) out[k] = std::sqrt(a[k]);
  return out;
}

// exp(8 y) for -5/8 <= y <= 0, to 2e-6: the Taylor polynomial of exp(y), to the eighth power.
MOLTACT_INLINE V8 exponentialOfEight(V8 y) {
  // In pairs of terms (Estrin's scheme), which wait less for one another than Horner's.
  const V8 y2 = y * y;
  const V8 low = (y + 1.0f) + y2 * (y * (1.0f / 6) + 0.5f),
           high = (y * (1.0f / 120) + 1.0f / 24) + y2 * (y * (1.0f / 5040) + 1.0f / 720);
  V8 p = low + y2 * y2 * high;
  p *= p;
  p *= p;
  return p * p;
}

// e ((R / r)^12 - 2 (R / r)^6)
MOLTACT_INLINE Curve lennardJones(V8 inverse_t, V8 minimum, V8 depth) {
  const V8 s2 = minimum * minimum * inverse_t, s6 = s2 * s2 * s2, a = depth * s6;
  return {a * (s6 - 2.0f), a * (1.0f - s6) * inverse_t * 6.0f, a * (s6 * 42.0f - 24.0f) * inverse_t * inverse_t};
}

template <Dielectric kind>
MOLTACT_INLINE Curve coulomb(V8 t, V8 inverse_t, V8 strength) {
  if constexpr (kind == Dielectric::Distance) {
    const V8 value = strength * inverse_t, first = -value * inverse_t;
    return {value, first, first * inverse_t * -2.0f};
  } else {
    const V8 r = squareRoot(t), inverse_r = r * inverse_t;
    if constexpr (kind == Dielectric::Constant) {
      const V8 value = strength * inverse_r, first = value * inverse_t * -0.5f;
      return {value, first, first * inverse_t * -1.5f};
    } else {
      // eps = A + B w, w = 1 / q, q = 1 + k exp(-lambda B r); with one division for w and 1 / eps = q / (A q + B).
      constexpr float kB = 86.9525f, kA = 78.4f - kB, kK = 7.7839f, kRate = 0.003627f * kB;
      // Beyond the largest cut-off, as in empty lanes, q stays that of 15.8 A: it must not overflow.
      const V8 q = exponentialOfEight(greater(r * (-kRate / 8), all(-5.0f / 8))) * kK + 1.0f, mixed = q * kA + kB,
               both = 1.0f / (q * mixed);
      // The result waits for the division; what does not depend on it is grouped apart, to be computed meanwhile.
      const V8 w = mixed * both, f = (inverse_r * (q * q)) * both, rise = r * (kB * kRate);
      // f = 1 / (r eps), by r; then by t = r^2.
      const V8 slope = ((rise + kB) - rise * w) * w + kA, f_squared = f * f;  // slope: of r eps
      const V8 first = (strength * (inverse_r * -0.5f)) * f_squared * slope;
      const V8 eps1 = w * (1.0f - w) * (kB * kRate), eps2 = eps1 * (1.0f - w * 2.0f) * kRate;
      const V8 f2 = (slope * slope * f * 2.0f - (eps1 * 2.0f + r * eps2)) * f_squared;
      return {strength * f, first, (strength * f2 * 0.25f - first * 0.5f) * inverse_t};
    }
  }
}

// The product with the switch: 1 up to from2, 0 from cut2, u^2 (3 - 2 u) in between.
MOLTACT_INLINE Curve switched(const Curve& g, V8 s, V8 s1, V8 s2) {
  return {s * g.value, s1 * g.value + s * g.first, s2 * g.value + s1 * g.first * 2.0f + s * g.second};
}

// The pairs of one block.
struct PairLanes {
  V8 dx, dy, dz;
  V8 energy[kEnergyParts];
  V8 first, second;  // the derivatives by t
};

// `unswitched`: each atom is at least kMinPair_A away and nearer than the switch, which therefore is 1 (the same bits).
template <Dielectric kind, bool unswitched>
MOLTACT_INLINE PairLanes pairs(const PairBlock& block, const PairConstants& c, const PairOwn& own) {
  PairLanes out;
  out.dx = own.x - load(block.x), out.dy = own.y - load(block.y), out.dz = own.z - load(block.z);
  const V8 far = out.dx * out.dx + out.dy * out.dy + out.dz * out.dz;
  const V8 t = unswitched ? far : greater(far, all(kMinPair_A * kMinPair_A)), inverse_t = 1.0f / t;
  // One curve for each EnergyPart, in its order.
  const Curve parts[] = {
      lennardJones(inverse_t, own.half_minimum_A + load(block.half_minimum_A), own.root_depth * load(block.root_depth)),
      coulomb<kind>(t, inverse_t, (c.coulomb * own.charge_e) * load(block.charge_e))};
  static_assert(sizeof parts == kEnergyParts * sizeof(Curve), "one curve for each EnergyPart");
  out.first = out.second = all(0.0f);
  if constexpr (unswitched) {
    for (std::size_t k = 0; k < kEnergyParts; ++k) {
      out.energy[k] = parts[k].value;
      out.first += parts[k].first;
      out.second += parts[k].second;
    }
    return out;
  }
  const V8 u = smaller(greater((c.cut2 - t) * c.inverse_width, all(0.0f)), all(1.0f));
  const V8 s = u * u * (3.0f - u * 2.0f), s1 = u * (1.0f - u) * (-6.0f * c.inverse_width);
  const M8 between = (t > c.from2) & (t < c.cut2);
  const V8 s2 = between ? (6.0f - u * 12.0f) * (c.inverse_width * c.inverse_width) : all(0.0f);
  // Nearer than kMinPair_A the energy continues with the slope at that distance.
  const V8 inside = far - t;
  for (std::size_t k = 0; k < kEnergyParts; ++k) {
    const Curve part = switched(parts[k], s, s1, s2);
    out.energy[k] = part.value + part.first * inside;
    out.first += part.first;
    out.second += part.second;
  }
  out.second = inside < 0.0f ? all(0.0f) : out.second;
  return out;
}

MOLTACT_INLINE double total(V8 v) {
  using V4d = double __attribute__((vector_size(32)));
  const V4d four = __builtin_convertvector(__builtin_shufflevector(v, v, 0, 1, 2, 3), V4d) +
                   __builtin_convertvector(__builtin_shufflevector(v, v, 4, 5, 6, 7), V4d);
  return (four[0] + four[2]) + (four[1] + four[3]);
}

// Sums over the pairs of several blocks, lane by lane.
template <bool curved>
struct LaneSums {
  V8 energy[kEnergyParts]{}, gx{}, gy{}, gz{}, xx{}, yy{}, zz{}, xy{}, xz{}, yz{};

  MOLTACT_INLINE void add(const PairLanes& p) {
    for (std::size_t k = 0; k < kEnergyParts; ++k) energy[k] += p.energy[k];
    gx += p.first * p.dx;
    gy += p.first * p.dy;
    gz += p.first * p.dz;
    if constexpr (!curved) return;
    const V8 steep = p.second * 2.0f, ax = steep * p.dx, ay = steep * p.dy;
    xx += p.first + ax * p.dx;
    yy += p.first + ay * p.dy;
    zz += p.first + steep * p.dz * p.dz;
    xy += ax * p.dy;
    xz += ax * p.dz;
    yz += ay * p.dz;
  }

  MOLTACT_INLINE void addTo(PairTerms& terms) const {
    for (std::size_t k = 0; k < kEnergyParts; ++k) terms.energy.values[k] += total(energy[k]);
    // By the place: t's derivative is 2 (dx, dy, dz).
    terms.gradient += 2.0 * Vec3(total(gx), total(gy), total(gz));
    if constexpr (!curved) return;
    const V8* const curvature[] = {&xx, &yy, &zz, &xy, &xz, &yz};
    for (int k = 0; k < 6; ++k) terms.curvature[std::size_t(k)] += 2.0 * total(*curvature[k]);
  }
};

template <Dielectric kind, bool curved>
MOLTACT_INLINE void add(const PairRun* runs, int count, const PairConstants& c, const PairOwn& own,
                        PairTerms& terms) noexcept {
  // The atom is at most this far from the centre of the blocks, with room for rounding.
  const float off_A = std::sqrt(own.x * own.x + own.y * own.y + own.z * own.z) + 1e-3f;
  const float beyond_A = c.cut_A + off_A, outside_A = float(kMinPair_A) + off_A, within_A = c.from_A - off_A;
  LaneSums<curved> sums;
  for (int r = 0; r < count; ++r)
    for (int b = 0; b < runs[r].count; ++b) {
      const PairBlock& block = runs[r].blocks[b];
      if (block.nearest_A >= beyond_A) continue;
      if (block.farthest_A < within_A && block.nearest_A > outside_A)
        sums.add(pairs<kind, true>(block, c, own));
      else
        sums.add(pairs<kind, false>(block, c, own));
    }
  sums.addTo(terms);
}

template <Dielectric kind>
void eachPair(const PairBlock& block, const PairConstants& c, const PairOwn& own, PairGradients& out) noexcept {
  const PairLanes p = pairs<kind, false>(block, c, own);
  const V8 slope = p.first * 2.0f, x = slope * p.dx, y = slope * p.dy, z = slope * p.dz;
  for (int k = 0; k < PairBlock::kLanes; ++k) out[std::size_t(k)] = Vec3(double(x[k]), double(y[k]), double(z[k]));
}

template <Dielectric kind, bool curved>
void addPlain(const PairRun* runs, int count, const PairConstants& c, const PairOwn& own, PairTerms& terms) noexcept {
  add<kind, curved>(runs, count, c, own, terms);
}

#ifdef MOLTACT_HAS_AVX2_LOOP
template <Dielectric kind, bool curved>
__attribute__((target("avx2"))) void addAvx2(const PairRun* runs, int count, const PairConstants& c, const PairOwn& own,
                                             PairTerms& terms) noexcept {
  add<kind, curved>(runs, count, c, own, terms);
}
#endif

template <Dielectric kind>
PairKernel plain() noexcept {
  return {&addPlain<kind, false>, &addPlain<kind, true>, &eachPair<kind>};
}

template <Dielectric kind>
PairKernel fastest() noexcept {
#ifdef MOLTACT_HAS_AVX2_LOOP
  if (__builtin_cpu_supports("avx2")) return {&addAvx2<kind, false>, &addAvx2<kind, true>, &eachPair<kind>};
#endif
  return plain<kind>();
}

PairKernel kernelOf(Dielectric kind, bool for_every_processor) noexcept {
  switch (kind) {
    case Dielectric::Constant:
      return for_every_processor ? plain<Dielectric::Constant>() : fastest<Dielectric::Constant>();
    case Dielectric::Distance:
      return for_every_processor ? plain<Dielectric::Distance>() : fastest<Dielectric::Distance>();
    case Dielectric::MehlerSolmajer:
      break;
  }
  return for_every_processor ? plain<Dielectric::MehlerSolmajer>() : fastest<Dielectric::MehlerSolmajer>();
}

}  // namespace

PairConstants::PairConstants(const PairModel& model)
    : coulomb(float(kCoulomb_kcal_A / (model.kind == Dielectric::MehlerSolmajer ? 1.0 : model.dielectric))),
      cut_A(float(model.cutoff_A)),
      from_A(float(model.switch_from_A)),
      cut2(float(model.cutoff_A * model.cutoff_A)),
      from2(float(model.switch_from_A * model.switch_from_A)),
      inverse_width(1.0f / (cut2 - from2)) {}

PairKernel pairKernel(Dielectric kind) noexcept { return kernelOf(kind, false); }

PairKernel plainPairKernel(Dielectric kind) noexcept { return kernelOf(kind, true); }

}  // namespace moltact
