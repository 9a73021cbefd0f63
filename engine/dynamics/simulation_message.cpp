#include "engine/dynamics/simulation_message.h"

#include "engine/core/saturated.h"

namespace moltact {
namespace {

constexpr std::size_t kPushNumbers = 8;

void appendPoint(std::vector<double>& to, const Vec3& v) { to.insert(to.end(), {v.x, v.y, v.z}); }

// Reads numbers in the order in which they were written.
class NumberRow {
 public:
  explicit NumberRow(std::span<const double> numbers) : numbers_(numbers) {}
  std::size_t left() const { return numbers_.size() - at_; }
  double number() { return at_ < numbers_.size() ? numbers_[at_++] : 0.0; }
  bool yes() { return number() != 0.0; }
  std::uint32_t count() { return saturateToInteger<std::uint32_t>(number()); }
  Vec3 point() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }
  std::vector<Vec3> points() {
    std::vector<Vec3> out;
    for (std::size_t k = left() / 3; k > 0; --k) out.push_back(point());
    return out;
  }

 private:
  std::span<const double> numbers_;
  std::size_t at_ = 0;
};

constexpr std::size_t kCommandHead = 7, kFrameHead = 9, kStartHead = 5;

bool rowFits(std::span<const double> numbers, std::size_t head, std::size_t each) {
  return numbers.size() >= head && (numbers.size() - head) % each == 0;
}

}  // namespace

std::vector<double> numbersOf(const TimedCommand& timed) {
  const SimulationCommand& c = timed.command;
  std::vector<double> out{timed.elapsed_s,   double(c.running),     c.ps_per_s,        c.temperature_K,
                          double(c.singles), double(c.relaxations), double(c.restarts)};
  for (const AtomPush& p : c.pushes) {
    out.push_back(p.atom);
    appendPoint(out, p.to_A);
    appendPoint(out, p.direction);
    out.push_back(p.stiffness_kcal_mol_A2);
  }
  return out;
}

std::optional<TimedCommand> commandOf(std::span<const double> numbers) {
  if (!rowFits(numbers, kCommandHead, kPushNumbers)) return std::nullopt;
  NumberRow row(numbers);
  TimedCommand out;
  SimulationCommand& c = out.command;
  out.elapsed_s = row.number();
  c.running = row.yes();
  c.ps_per_s = row.number();
  c.temperature_K = row.number();
  c.singles = row.count();
  c.relaxations = row.count();
  c.restarts = row.count();
  while (row.left() > 0) {
    AtomPush p;
    p.atom = row.count();
    p.to_A = row.point();
    p.direction = row.point();
    p.stiffness_kcal_mol_A2 = row.number();
    c.pushes.push_back(p);
  }
  return out;
}

std::vector<double> numbersOf(const SimulationFrame& f) {
  const MdEnergies& e = f.energies;
  std::vector<double> out{double(f.serial), f.time_ps,        e.potential_kcal_mol, e.kinetic_kcal_mol, e.temperature_K,
                          f.ps_per_s,       double(f.starts), double(f.blow_ups),   double(f.dead)};
  out.reserve(out.size() + 3 * f.positions_A.size());
  for (const Vec3& v : f.positions_A) appendPoint(out, v);
  return out;
}

std::optional<SimulationFrame> frameOf(std::span<const double> numbers) {
  if (!rowFits(numbers, kFrameHead, 3)) return std::nullopt;
  NumberRow row(numbers);
  SimulationFrame out;
  out.serial = saturateToInteger<std::uint64_t>(row.number());
  out.time_ps = row.number();
  out.energies.potential_kcal_mol = row.number();
  out.energies.kinetic_kcal_mol = row.number();
  out.energies.temperature_K = row.number();
  out.ps_per_s = row.number();
  out.starts = row.count();
  out.blow_ups = row.count();
  out.dead = row.yes();
  out.positions_A = row.points();
  return out;
}

std::vector<double> numbersOf(const MdStart& s) {
  std::vector<double> out{s.temperature_K, s.friction_per_ps, s.hold_kcal_mol_A2, double(s.seed), s.step_ps};
  for (const Vec3& v : s.positions_A) appendPoint(out, v);
  return out;
}

std::optional<MdStart> startOf(std::span<const double> numbers) {
  if (!rowFits(numbers, kStartHead, 3)) return std::nullopt;
  NumberRow row(numbers);
  MdStart out;
  out.temperature_K = row.number();
  out.friction_per_ps = row.number();
  out.hold_kcal_mol_A2 = row.number();
  out.seed = row.count();
  out.step_ps = row.number();
  out.positions_A = row.points();
  return out;
}

}  // namespace moltact
