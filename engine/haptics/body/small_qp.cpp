#include "engine/haptics/body/small_qp.h"

#include <limits>

namespace moltact {
namespace {

constexpr double kTolerance = 1e-13;     // violation that counts as none
constexpr double kIndependent2 = 1e-18;  // squared share of a normal outside the basis, above which it is independent
constexpr int kMaxCorrections = 3;
constexpr double kNever = std::numeric_limits<double>::infinity();

}  // namespace

SmallQp::Entering SmallQp::entering(const Six& normal) const noexcept {
  Entering out;
  out.along = normal;
  for (int pass = 0; pass < 2; ++pass)
    for (int i = 0; i < count_; ++i) {
      const double c = dot(basis_[std::size_t(i)], out.along);
      out.in_basis[std::size_t(i)] += c;
      out.along.add(-c, basis_[std::size_t(i)]);
    }
  out.along2 = dot(out.along, out.along);
  out.independent = count_ < 6 && out.along2 > kIndependent2 * dot(normal, normal);
  for (int i = count_; i-- > 0;) {
    double sum = out.in_basis[std::size_t(i)];
    for (int j = i + 1; j < count_; ++j) sum -= triangle_[std::size_t(i)][std::size_t(j)] * out.shares[std::size_t(j)];
    out.shares[std::size_t(i)] = sum / triangle_[std::size_t(i)][std::size_t(i)];
  }
  return out;
}

void SmallQp::append(const Entering& with, const Six& normal) noexcept {
  const auto at = std::size_t(count_);
  const double size = std::sqrt(with.along2);
  normals_[at] = normal;
  basis_[at] = with.along;
  basis_[at].scale(1.0 / size);
  for (std::size_t i = 0; i < at; ++i) triangle_[i][at] = with.in_basis[i];
  triangle_[at][at] = size;
  ++count_;
}

// Removes an active constraint and orthogonalizes those behind it anew.
void SmallQp::remove(int at) noexcept {
  const int last = count_;
  count_ = at;
  for (int k = at + 1; k < last; ++k) {
    const Six normal = normals_[std::size_t(k)];
    append(entering(normal), normal);
  }
}

// Moves the solution by the least way onto the active constraints, from which the rounding of a far greater pull has
// taken it; false if it is there.
bool SmallQp::closed(QpSolution& out, const Factor6* metric) const noexcept {
  bool open = false;
  for (int i = 0; i < out.count; ++i) open = open || slack_[std::size_t(out.rows[std::size_t(i)])] < -kTolerance;
  if (!open) return false;
  Six way;
  std::array<double, 6> along{};
  for (std::size_t i = 0; i < std::size_t(out.count); ++i) {
    double sum = -slack_[std::size_t(out.rows[i])];
    for (std::size_t j = 0; j < i; ++j) sum -= triangle_[j][i] * along[j];
    along[i] = sum / triangle_[i][i];
    way.add(along[i], basis_[i]);
  }
  out.step.add(1.0, metric ? metric->backward(way) : way);
  return true;
}

QpSolution SmallQp::solve(const Factor6* metric, const Six& pull, std::span<const Six> rows,
                          std::span<const double> bounds, std::span<const int> preferred, int max_changes) noexcept {
  QpSolution out;
  count_ = 0;
  out.step = metric ? metric->backward(metric->forward(pull)) : pull;
  const auto n = int(rows.size());
  int corrections = 0;
  const auto active = [&](int k) {
    for (int i = 0; i < out.count; ++i)
      if (out.rows[std::size_t(i)] == k) return true;
    return false;
  };
  for (;;) {
    for (int k = 0; k < n; ++k) slack_[std::size_t(k)] = dot(rows[std::size_t(k)], out.step) - bounds[std::size_t(k)];
    int worst = -1;
    for (const int k : preferred)
      if (k < n && slack_[std::size_t(k)] < -kTolerance && !active(k)) {
        worst = k;
        break;
      }
    if (worst < 0) {
      double least = -kTolerance;
      for (int k = 0; k < n; ++k)
        if (slack_[std::size_t(k)] < least && !active(k)) least = slack_[std::size_t(k)], worst = k;
    }
    if (worst < 0) {
      if (corrections < kMaxCorrections && closed(out, metric)) {
        ++corrections;
        continue;
      }
      out.feasible = true;
      return out;
    }
    const Six normal = metric ? metric->forward(rows[std::size_t(worst)]) : rows[std::size_t(worst)];
    double lambda = 0.0, missing = -slack_[std::size_t(worst)];
    for (;;) {
      if (++out.changes > std::min(max_changes, kMaxChanges)) return out;
      const Entering with = entering(normal);
      double partial = kNever;
      int leaves = -1;
      for (int i = 0; i < out.count; ++i) {
        const double share = with.shares[std::size_t(i)];
        if (share > 0.0 && out.lambda[std::size_t(i)] < partial * share)
          partial = out.lambda[std::size_t(i)] / share, leaves = i;
      }
      const double full = with.independent ? missing / with.along2 : kNever;
      const double by = std::min(partial, full);
      if (by == kNever) return out;  // no direction satisfies the constraint together with the active ones
      for (int i = 0; i < out.count; ++i)
        out.lambda[std::size_t(i)] = std::max(0.0, out.lambda[std::size_t(i)] - by * with.shares[std::size_t(i)]);
      lambda += by;
      if (with.independent) {
        out.step.add(by, metric ? metric->backward(with.along) : with.along);
        missing -= by * with.along2;
      }
      if (full <= partial) {
        append(with, normal);
        out.rows[std::size_t(out.count)] = worst;
        out.lambda[std::size_t(out.count)] = lambda;
        ++out.count;
        break;
      }
      remove(leaves);
      for (int i = leaves + 1; i < out.count; ++i) {
        out.rows[std::size_t(i - 1)] = out.rows[std::size_t(i)];
        out.lambda[std::size_t(i - 1)] = out.lambda[std::size_t(i)];
      }
      --out.count;
    }
  }
}

}  // namespace moltact
