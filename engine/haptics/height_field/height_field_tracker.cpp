#include "engine/haptics/height_field/height_field_tracker.h"

#include <algorithm>
#include <cmath>

#include "engine/haptics/hip_input.h"

namespace moltact {
namespace {

constexpr double kFieldCorner_A = 1e-9;  // a point within this distance of a corner lies on it
constexpr double kFieldMoved_A = 1e-12;
constexpr double kFieldInto = 1e-10;    // sine above which a path crosses a border instead of running along it
constexpr double kFieldSkin_A = 1e-10;  // a path that ends this far under a triangle grazes it
constexpr int kFieldStuck = 24;
constexpr int kFieldChanges = 16;  // changes between flight and sliding per tick

}  // namespace

HeightFieldTracker::HeightFieldTracker(std::shared_ptr<const HeightField> field, double lift_A)
    : field_(std::move(field)) {
  if (field_ && (field_->columns < 2 || field_->rows < 2)) field_ = nullptr;
  surfaceChanged(lift_A);
}

void HeightFieldTracker::reset() noexcept {
  has_been_outside_ = false;
  on_ = On::Nothing;
}

MemoryUsage HeightFieldTracker::memoryUsage() const noexcept {
  MemoryUsage out{0, sizeof(*this)};
  if (field_)
    out.bytes +=
        sizeof(*field_) + field_->heights_A.size() * sizeof(double) + field_->atoms.size() * sizeof(std::int32_t);
  return out;
}

// The raster has one more column and row of cells on each side, which reach kBeyond_A outward.
double HeightFieldTracker::nodeX(int column) const noexcept {
  return column < 0                 ? -kBeyond_A
         : column < field_->columns ? field_->spacing_A * column
                                    : field_->width_A() + kBeyond_A;
}

double HeightFieldTracker::nodeY(int row) const noexcept {
  return row < 0 ? -kBeyond_A : row < field_->rows ? field_->spacing_A * row : field_->depth_A() + kBeyond_A;
}

double HeightFieldTracker::nodeHeight(int column, int row) const noexcept {
  return field_->at(std::clamp(column, 0, field_->columns - 1), std::clamp(row, 0, field_->rows - 1));
}

int HeightFieldTracker::columnOf(double x) const noexcept {
  return static_cast<int>(std::clamp(std::floor(x / field_->spacing_A), -1.0, double(field_->columns - 1)));
}

int HeightFieldTracker::rowOf(double y) const noexcept {
  return static_cast<int>(std::clamp(std::floor(y / field_->spacing_A), -1.0, double(field_->rows - 1)));
}

HeightFieldTracker::Triangle HeightFieldTracker::triangleAt(double x, double y) const noexcept {
  const int column = columnOf(x), row = rowOf(y);
  const double u = (x - nodeX(column)) / (nodeX(column + 1) - nodeX(column)),
               v = (y - nodeY(row)) / (nodeY(row + 1) - nodeY(row));
  return {column, row, u >= v ? 0 : 1};
}

// Half 0 has the corners (c, r), (c + 1, r), (c + 1, r + 1); half 1 has (c, r), (c + 1, r + 1), (c, r + 1).
std::array<int, 2> HeightFieldTracker::cornerOf(const Triangle& t, int corner) const noexcept {
  const int right = corner == 1 || (corner == 2 && t.half == 0), up = corner == 2 || (corner == 1 && t.half == 1);
  return {t.column + right, t.row + up};
}

// Edge k leads from corner k to the next.
HeightFieldTracker::Triangle HeightFieldTracker::across(const Triangle& t, int edge) noexcept {
  if (t.half == 0)
    return edge == 0   ? Triangle{t.column, t.row - 1, 1}
           : edge == 1 ? Triangle{t.column + 1, t.row, 1}
                       : Triangle{t.column, t.row, 1};
  return edge == 0   ? Triangle{t.column, t.row, 0}
         : edge == 1 ? Triangle{t.column, t.row + 1, 0}
                     : Triangle{t.column - 1, t.row, 0};
}

bool HeightFieldTracker::exists(const Triangle& t) const noexcept {
  return t.column >= -1 && t.column < field_->columns && t.row >= -1 && t.row < field_->rows;
}

HeightFieldTracker::Plane HeightFieldTracker::planeOf(const Triangle& t) const noexcept {
  Plane out;
  for (int k = 0; k < 3; ++k) {
    const auto [column, row] = cornerOf(t, k);
    out.corners[std::size_t(k)] = node(column, row);
  }
  out.normal = glm::normalize(glm::cross(out.corners[1] - out.corners[0], out.corners[2] - out.corners[0]));
  out.height = glm::dot(out.normal, out.corners[0]);
  for (std::size_t k = 0; k < 3; ++k) {
    out.out[k] = glm::cross(glm::normalize(out.corners[(k + 1) % 3] - out.corners[k]), out.normal);
    out.reach[k] = glm::dot(out.out[k], out.corners[k]);
  }
  return out;
}

bool HeightFieldTracker::reaches(const Vec3& place) const noexcept {
  constexpr double kNear_A = kBeyond_A - 1.0;
  return place.x > -kNear_A && place.x < field_->width_A() + kNear_A && place.y > -kNear_A &&
         place.y < field_->depth_A() + kNear_A;
}

double HeightFieldTracker::heightAt(double x_A, double y_A) const noexcept {
  const Plane plane = planeOf(triangleAt(x_A, y_A));
  return (plane.height - plane.normal.x * x_A - plane.normal.y * y_A) / plane.normal.z;
}

void HeightFieldTracker::surfaceChanged(double lift_A) noexcept {
  lift_ = Vec3(0.0, 0.0, lift_A);
  if (!field_) return;
  top_ = *std::max_element(field_->heights_A.begin(), field_->heights_A.end());
  if (!has_been_outside_) return;
  const double height = heightAt(scp_.x, scp_.y);
  if (on_ == On::Nothing && scp_.z >= height) return;
  scp_.z = std::max(scp_.z, height);
  goToTriangle(triangleAt(scp_.x, scp_.y));
}

Contact HeightFieldTracker::step(PointA hip) noexcept {
  const auto placeOf = [&](const Vec3& local) { return PointA{field_->frame.toMolecule(local + lift_)}; };
  if (!usableHip(hip.A)) return refusedHip(hip, field_ ? placeOf(scp_).A : Vec3(0.0));
  if (!field_) return {.scp = hip};
  const Vec3 h = field_->frame.toScan(hip.A) - lift_;
  if (!reaches(h)) {
    reset();
    scp_ = h;
    return {.scp = hip};
  }
  if (!has_been_outside_) {
    scp_ = h;
    if (h.z < heightAt(h.x, h.y)) return {.scp = hip, .fault = Fault::StartedInside};
    has_been_outside_ = true;
    return {.scp = hip};
  }
  SlideResult result = SlideResult::Short;
  for (int i = 0; i < kFieldChanges; ++i) {
    if (on_ != On::Nothing) {
      result = walk(h);
      if (result == SlideResult::Leaves) on_ = On::Nothing;
    } else {
      result = fly(h);
    }
    if (result == SlideResult::Arrived || result == SlideResult::Rests || result == SlideResult::Short) break;
  }
  if (result == SlideResult::Arrived) return {.scp = hip};
  if (result != SlideResult::Rests) ++cut_short_;
  Contact out{.scp = placeOf(scp_), .feature = Feature::Sphere};
  stretchToScp(out, hip);
  if (on_ == On::Nothing) return out;
  out.atoms[0] = nearestAtom();
  if (out.atoms[0] >= 0) out.normals[0] = field_->frame.orientation * outward();
  return out;
}

// The triangle's normal; on an edge or a corner the mean of the adjacent normals.
Vec3 HeightFieldTracker::outward() const noexcept {
  const Vec3 sum = on_ == On::Edge     ? plane_.normal + beyond_.normal
                   : on_ == On::Corner ? corner_normal_
                                       : plane_.normal;
  const double far = glm::length(sum);
  return far > 0.0 ? sum / far : plane_.normal;
}

// The atom of the corner nearest to the SCP that has one.
std::int32_t HeightFieldTracker::nearestAtom() const noexcept {
  std::int32_t atom = -1;
  double nearest = 1e300;
  for (int k = 0; k < 3; ++k) {
    const auto [column, row] = cornerOf(triangle_, k);
    const std::int32_t here =
        field_->atoms[field_->index(std::clamp(column, 0, field_->columns - 1), std::clamp(row, 0, field_->rows - 1))];
    const Vec3 apart = plane_.corners[std::size_t(k)] - scp_;
    if (const double d2 = glm::dot(apart, apart); here >= 0 && d2 < nearest) nearest = d2, atom = here;
  }
  return atom;
}

// The first triangle that the path enters from above, from cell to cell. Within a cell the height over each of its
// triangles is a linear function of the way.
HeightFieldTracker::Meeting HeightFieldTracker::cast(const Vec3& from, const Vec3& path) const noexcept {
  Meeting none;
  double t = 0.0;
  if (from.z > top_) {
    if (from.z + path.z > top_) return none;
    t = (top_ - from.z) / path.z;
  }
  const Vec3 start = from + path * t;
  int column = columnOf(start.x), row = rowOf(start.y);
  // A path that starts on a line between cells and leads back begins in the cell before it.
  if (path.x < 0.0 && column > -1 && start.x <= nodeX(column)) --column;
  if (path.y < 0.0 && row > -1 && start.y <= nodeY(row)) --row;
  const int step_x = path.x > 0.0 ? 1 : -1, step_y = path.y > 0.0 ? 1 : -1;
  while (column >= -1 && column < field_->columns && row >= -1 && row < field_->rows) {
    const double x0 = nodeX(column), x1 = nodeX(column + 1), y0 = nodeY(row), y1 = nodeY(row + 1);
    const double tx = path.x != 0.0 ? ((step_x > 0 ? x1 : x0) - from.x) / path.x : 2.0,
                 ty = path.y != 0.0 ? ((step_y > 0 ? y1 : y0) - from.y) / path.y : 2.0;
    const double end = std::max(t, std::min({1.0, tx, ty}));
    // The cell's diagonal divides the way: below it is half 0.
    const auto side = [&](double at) {
      return (from.x + path.x * at - x0) / (x1 - x0) - (from.y + path.y * at - y0) / (y1 - y0);
    };
    const double a = side(t), b = side(end);
    const double turn = (a > 0.0) != (b > 0.0) && a != b ? t + (end - t) * std::clamp(a / (a - b), 0.0, 1.0) : end;
    for (int piece = 0; piece < 2; ++piece) {
      const double begin = piece == 0 ? t : turn, until = piece == 0 ? turn : end;
      if (piece == 1 && !(until > begin)) break;
      const Triangle triangle{column, row, side(0.5 * (begin + until)) >= 0.0 ? 0 : 1};
      const Vec3 p = node(column, row), q = node(column + 1, row + 1),
                 r = triangle.half == 0 ? node(column + 1, row) : node(column, row + 1);
      const Vec3 across = triangle.half == 0 ? glm::cross(r - p, q - p) : glm::cross(q - p, r - p);
      const double per = 1.0 / glm::length(across);
      const double under = glm::dot(across, from + path * until - p) * per;
      if (!(under < -kFieldSkin_A)) continue;
      const double over = glm::dot(across, from + path * begin - p) * per;
      return {over > 0.0 ? begin + (until - begin) * (over / (over - under)) : begin, triangle};
    }
    if (end >= 1.0) break;
    t = end;
    if (tx <= ty) column += step_x;
    if (ty <= tx) row += step_y;
  }
  return none;
}

HeightFieldTracker::SlideResult HeightFieldTracker::fly(const Vec3& h) noexcept {
  const Vec3 path = h - scp_;
  const Meeting hit = cast(scp_, path);
  if (hit.t > 1.0) {
    scp_ = h;
    return SlideResult::Arrived;
  }
  scp_ += path * hit.t;
  goToTriangle(hit.triangle);
  scp_ -= plane_.normal * (glm::dot(plane_.normal, scp_) - plane_.height);
  return SlideResult::Meets;
}

void HeightFieldTracker::goToTriangle(const Triangle& triangle) noexcept {
  on_ = On::Triangle;
  triangle_ = triangle;
  plane_ = planeOf(triangle);
}

// Returns false at the end of the surface.
bool HeightFieldTracker::goToEdge(const Triangle& triangle, int edge) noexcept {
  const Triangle other = across(triangle, edge);
  if (!exists(other)) return false;
  if (!(triangle == triangle_)) plane_ = planeOf(triangle);
  on_ = On::Edge;
  triangle_ = triangle;
  edge_ = edge;
  other_ = other;
  beyond_ = planeOf(other);
  for (other_edge_ = 0; other_edge_ < 2 && !(across(other, other_edge_) == triangle);) ++other_edge_;
  edge_from_ = plane_.corners[std::size_t(edge)];
  const Vec3 whole = plane_.corners[std::size_t((edge + 1) % 3)] - edge_from_;
  edge_length_ = glm::length(whole);
  edge_along_ = whole / edge_length_;
  return true;
}

// Collects the triangles around the corner in turn, and computes the normal that distinguishes outside from inside
// there (Baerentzen & Aanaes 2005: the triangles' normals, weighted by their angles).
bool HeightFieldTracker::goToCorner(const Triangle& triangle, int corner) noexcept {
  const std::array<int, 2> vertex = cornerOf(triangle, corner);
  scp_ = node(vertex[0], vertex[1]);
  corner_normal_ = Vec3(0.0);
  round_count_ = 0;
  Triangle at = triangle;
  do {
    int k = 0;
    while (k < 2 && cornerOf(at, k) != vertex) ++k;
    const auto rightmost = cornerOf(at, (k + 1) % 3), leftmost = cornerOf(at, (k + 2) % 3);
    const Vec3 right = node(rightmost[0], rightmost[1]) - scp_, left = node(leftmost[0], leftmost[1]) - scp_,
               normal = glm::cross(right, left);
    const double sine = glm::length(normal);
    Wedge& w = round_[round_count_++];
    w = {at, k, normal / sine, glm::normalize(right), Vec3(0.0), Vec3(0.0)};
    w.in_right = glm::cross(w.normal, w.along);
    w.in_left = glm::cross(glm::normalize(left), w.normal);
    corner_normal_ += w.normal * std::atan2(sine, glm::dot(right, left));
    at = across(at, (k + 2) % 3);
    if (!exists(at)) return false;
  } while (!(at == triangle) && round_count_ < round_.size());
  on_ = On::Corner;
  triangle_ = triangle;
  plane_ = planeOf(triangle);
  return true;
}

HeightFieldTracker::SlideResult HeightFieldTracker::walk(const Vec3& h) noexcept {
  int stuck = 0;
  for (int piece = 0; piece < kMaxPieces && stuck < kFieldStuck; ++piece) {
    const SlideResult result = on_ == On::Triangle ? overTriangle(h, stuck)
                               : on_ == On::Edge   ? alongEdge(h, stuck)
                                                   : fromCorner(h, stuck);
    if (result != SlideResult::Meets) return result;
  }
  return SlideResult::Short;
}

HeightFieldTracker::SlideResult HeightFieldTracker::overTriangle(const Vec3& h, int& stuck) noexcept {
  const double height = glm::dot(plane_.normal, h) - plane_.height;
  if (height >= 0.0) return SlideResult::Leaves;
  const Vec3 foot = h - plane_.normal * height;
  double t = 1.0;
  int over = -1;
  for (int k = 0; k < 3; ++k) {
    const double beyond = glm::dot(plane_.out[std::size_t(k)], foot) - plane_.reach[std::size_t(k)];
    if (beyond <= 0.0) continue;
    const double before = std::max(0.0, plane_.reach[std::size_t(k)] - glm::dot(plane_.out[std::size_t(k)], scp_));
    if (const double at = before / (before + beyond); at < t || over < 0) t = at, over = k;
  }
  if (over < 0) {
    scp_ = foot;
    return SlideResult::Rests;
  }
  const Vec3 path = foot - scp_;
  stuck = t * glm::length(path) > kFieldMoved_A ? 0 : stuck + 1;
  scp_ += path * t;
  if (!goToEdge(triangle_, over)) return SlideResult::Short;
  const double along = glm::dot(scp_ - edge_from_, edge_along_);
  if (along <= kFieldCorner_A) return goToCorner(triangle_, over) ? SlideResult::Meets : SlideResult::Short;
  if (along >= edge_length_ - kFieldCorner_A)
    return goToCorner(triangle_, (over + 1) % 3) ? SlideResult::Meets : SlideResult::Short;
  scp_ = edge_from_ + edge_along_ * along;
  return SlideResult::Meets;
}

// Selects, among the directions that leave an edge, the steepest descent of |x - h|^2.
HeightFieldTracker::SlideResult HeightFieldTracker::alongEdge(const Vec3& h, int& stuck) noexcept {
  const Vec3 displacement = h - scp_;
  const double smallest = kFieldInto * glm::length(displacement);
  const double up = glm::dot(displacement, plane_.normal), up_beyond = glm::dot(displacement, beyond_.normal),
               along = glm::dot(displacement, edge_along_);
  const bool here = glm::dot(displacement, plane_.out[std::size_t(edge_)]) < -smallest,
             there = glm::dot(displacement, beyond_.out[std::size_t(other_edge_)]) < -smallest;
  const double pull2 = glm::dot(displacement, displacement), gain = pull2 - up * up,
               gain_beyond = pull2 - up_beyond * up_beyond;
  if (here && (!there || gain >= gain_beyond)) {
    if (up > 0.0) return SlideResult::Leaves;
    ++stuck;
    on_ = On::Triangle;
    return SlideResult::Meets;
  }
  if (there) {
    if (up_beyond > 0.0) return SlideResult::Leaves;
    ++stuck;
    on_ = On::Triangle;
    triangle_ = other_;
    plane_ = beyond_;
    return SlideResult::Meets;
  }
  if (up + up_beyond > 0.0) return SlideResult::Leaves;
  const double at = glm::dot(scp_ - edge_from_, edge_along_), to = at + along;
  if (to > kFieldCorner_A && to < edge_length_ - kFieldCorner_A) {
    scp_ = edge_from_ + edge_along_ * to;
    return SlideResult::Rests;
  }
  stuck = std::abs(along) > kFieldMoved_A ? 0 : stuck + 1;
  return goToCorner(triangle_, to <= kFieldCorner_A ? edge_ : (edge_ + 1) % 3) ? SlideResult::Meets
                                                                               : SlideResult::Short;
}

HeightFieldTracker::SlideResult HeightFieldTracker::fromCorner(const Vec3& h, int& stuck) noexcept {
  const Vec3 displacement = h - scp_;
  const double pull2 = glm::dot(displacement, displacement), smallest = kFieldInto * std::sqrt(pull2);
  double best = 0.0;
  std::size_t by = 0;
  bool on_edge = false;
  for (std::size_t k = 0; k < round_count_; ++k) {
    const Wedge& w = round_[k];
    const double along = glm::dot(displacement, w.along);
    if (along > smallest && along * along > best) best = along * along, by = k, on_edge = true;
    if (glm::dot(displacement, w.in_right) <= smallest || glm::dot(displacement, w.in_left) <= smallest) continue;
    const double up = glm::dot(displacement, w.normal);
    if (pull2 - up * up > best) best = pull2 - up * up, by = k, on_edge = false;
  }
  if (best == 0.0) return glm::dot(displacement, corner_normal_) > 0.0 ? SlideResult::Leaves : SlideResult::Rests;
  const Wedge& w = round_[by];
  const Vec3 side = on_edge ? w.normal + round_[(by + round_count_ - 1) % round_count_].normal : w.normal;
  if (glm::dot(displacement, side) > 0.0) return SlideResult::Leaves;
  ++stuck;
  const Triangle triangle = w.triangle;
  const int edge = w.edge;
  if (on_edge) return goToEdge(triangle, edge) ? SlideResult::Meets : SlideResult::Short;
  goToTriangle(triangle);
  return SlideResult::Meets;
}

}  // namespace moltact
