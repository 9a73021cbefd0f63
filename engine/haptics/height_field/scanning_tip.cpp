#include "engine/haptics/height_field/scanning_tip.h"

#include <algorithm>
#include <cmath>

#include "engine/language/catalogue.h"

namespace moltact {
namespace {

bool inRange(double value, double low, double high) { return value >= low && value <= high; }

bool usable(const ScanSetup& s) {
  return inRange(s.tip_A, 0.0, kMaxTip_A) && inRange(s.cone_deg, 0.0, kMaxCone_deg) &&
         inRange(s.spacing_A, kMinScanSpacing_A, kMaxScanSpacing_A) && inRange(s.margin_A, 0.0, kMaxScanMargin_A) &&
         inRange(s.below_A, 0.0, kMaxBelow_A) && inRange(s.force_pN, 0.0, kMaxScanForce_pN) &&
         inRange(s.contact_N_per_m, kMinContact_N_per_m, kMaxContact_N_per_m) && rotates(s.orientation);
}

}  // namespace

Expected<ScanningTip> ScanningTip::over(std::span<const Sphere> spheres, const ScanSetup& setup,
                                        std::span<const std::uint32_t> without) {
  if (!usable(setup))
    return Problem{.file = {},
                   .message = tr("a value of the scan is out of its range"),
                   .remedy = tr("choose tip, spacing, margin and force within their limits")};
  ScanningTip out;
  out.setup_ = setup;
  out.setup_.orientation = glm::normalize(setup.orientation);
  const double angle = setup.cone_deg * kTwoPi / 360.0;
  out.sine_ = std::sin(angle);
  out.cosine_ = std::cos(angle);
  const Quat to_scan = glm::conjugate(out.setup_.orientation);
  Vec3 low(1e300), high(-1e300);
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    if (std::binary_search(without.begin(), without.end(), static_cast<std::uint32_t>(i))) continue;
    const Vec3 centre = to_scan * spheres[i].centre_A;
    low = glm::min(low, centre - Vec3(spheres[i].radius_A));
    high = glm::max(high, centre + Vec3(spheres[i].radius_A));
    out.atoms_.push_back({centre, spheres[i].radius_A, 0.0, 0.0, static_cast<std::int32_t>(i)});
  }
  if (out.atoms_.empty())
    return Problem{
        .file = {}, .message = tr("there is no atom to scan"), .remedy = tr("leave at least one atom in the scene")};
  low.x -= setup.margin_A, low.y -= setup.margin_A;
  low.z -= setup.below_A;
  high.x += setup.margin_A, high.y += setup.margin_A;
  const double columns = std::max(2.0, std::ceil((high.x - low.x) / setup.spacing_A) + 1.0),
               rows = std::max(2.0, std::ceil((high.y - low.y) / setup.spacing_A) + 1.0);
  if (!(columns * rows <= static_cast<double>(kMaxScanNodes)))
    return Problem{.file = {},
                   .message = trf("the scan would have more than {0} nodes", std::to_string(kMaxScanNodes)),
                   .remedy = tr("choose a larger spacing")};
  HeightField& field = out.field_;
  field.columns = static_cast<int>(columns);
  field.rows = static_cast<int>(rows);
  field.spacing_A = setup.spacing_A;
  // The raster lies in the middle of what it covers.
  const Vec3 corner(0.5 * (low.x + high.x) - 0.5 * field.width_A(), 0.5 * (low.y + high.y) - 0.5 * field.depth_A(),
                    low.z);
  field.frame = {out.setup_.orientation * corner, out.setup_.orientation};
  field.heights_A.assign(field.index(0, field.rows), 0.0);
  field.atoms.assign(field.heights_A.size(), -1);
  for (Atom& atom : out.atoms_) atom.centre -= corner;
  out.setReach();
  std::sort(out.atoms_.begin(), out.atoms_.end(), [](const Atom& a, const Atom& b) {
    return a.centre.y < b.centre.y || (a.centre.y == b.centre.y && a.index < b.index);
  });
  if (setup.force_pN > 0.0) out.stops_.resize(static_cast<std::size_t>(field.columns));
  return out;
}

void ScanningTip::setReach() noexcept {
  farthest_ = 0.0;
  for (Atom& atom : atoms_) {
    atom.reach = atom.radius + setup_.tip_A;
    // Where the apex reaches the substrate: on the spherical part of the tip, or on the flank of its cone.
    const double down = atom.centre.z - setup_.tip_A;
    if (down + atom.reach * sine_ <= 0.0)
      atom.far = std::sqrt(std::max(0.0, atom.reach * atom.reach - down * down));
    else if (setup_.cone_deg > 0.0)
      atom.far = (atom.reach + down * sine_) / cosine_;
    else
      atom.far = atom.reach;
    farthest_ = std::max(farthest_, atom.far);
  }
}

void ScanningTip::restart(double tip_A) noexcept {
  setup_.tip_A = std::isfinite(tip_A) ? std::clamp(tip_A, 0.0, kMaxTip_A) : setup_.tip_A;
  setReach();
  std::fill(field_.heights_A.begin(), field_.heights_A.end(), 0.0);
  std::fill(field_.atoms.begin(), field_.atoms.end(), -1);
  line_ = 0;
}

// The height of the apex where this atom alone stops the tip, at the squared horizontal distance d2.
double ScanningTip::apexOver(const Atom& atom, double d2) const {
  const double rim = atom.reach * cosine_, down = atom.centre.z - setup_.tip_A;
  if (d2 <= rim * rim) return down + std::sqrt(std::max(0.0, atom.reach * atom.reach - d2));
  return down + (atom.reach - cosine_ * std::sqrt(d2)) / sine_;
}

template <class Visit>
void ScanningTip::eachStop(double y, Visit&& visit) const {
  const auto first = std::lower_bound(atoms_.begin(), atoms_.end(), y - farthest_,
                                      [](const Atom& a, double from) { return a.centre.y < from; });
  const double spacing = field_.spacing_A;
  for (auto atom = first; atom != atoms_.end() && atom->centre.y <= y + farthest_; ++atom) {
    const double dy = y - atom->centre.y, wide2 = atom->far * atom->far - dy * dy;
    if (wide2 < 0.0) continue;
    const double wide = std::sqrt(wide2);
    const int from = std::max(0, static_cast<int>(std::ceil((atom->centre.x - wide) / spacing))),
              to = std::min(field_.columns - 1, static_cast<int>(std::floor((atom->centre.x + wide) / spacing)));
    for (int column = from; column <= to; ++column) {
      const double dx = spacing * column - atom->centre.x;
      visit(column, apexOver(*atom, dx * dx + dy * dy), atom->index);
    }
  }
}

void ScanningTip::scanLine() {
  if (done()) return;
  const double y = field_.spacing_A * line_;
  const std::size_t begin = field_.index(0, line_);
  double* const heights = field_.heights_A.data() + begin;
  std::int32_t* const stopped_by = field_.atoms.data() + begin;
  eachStop(y, [&](int column, double height, std::int32_t atom) {
    if (height > heights[column]) heights[column] = height, stopped_by[column] = atom;
  });
  if (!stops_.empty()) sinkLine(y, heights, stopped_by);
  ++line_;
}

// Lowers the heights of a line in contact until the atoms carry the force.
void ScanningTip::sinkLine(double y, double* heights, std::int32_t* stopped_by) {
  const double sink = setup_.sink_A();
  for (auto& stops : stops_) stops.clear();
  eachStop(y, [&](int column, double height, std::int32_t atom) {
    if (height > heights[column] - sink) stops_[static_cast<std::size_t>(column)].push_back({height, atom});
  });
  for (std::size_t column = 0; column < stops_.size(); ++column) {
    auto& stops = stops_[column];
    if (stops.empty() || stopped_by[column] < 0) continue;
    std::sort(stops.begin(), stops.end(), [](const Stop& a, const Stop& b) { return a.height > b.height; });
    // With the n highest stops under load, sum (stop - height) = sink.
    double sum = 0.0, height = 0.0;
    for (std::size_t n = 1; n <= stops.size(); ++n) {
      sum += stops[n - 1].height;
      height = (sum - sink) / static_cast<double>(n);
      if (n == stops.size() || height >= stops[n].height) break;
    }
    heights[column] = std::max(0.0, height);
    if (height <= 0.0) stopped_by[column] = -1;
  }
}

}  // namespace moltact
