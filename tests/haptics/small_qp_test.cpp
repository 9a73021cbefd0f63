// Quadratic programs in six variables, against all choices of active constraints.
#include "engine/haptics/body/small_qp.h"

#include <doctest/doctest.h>

#include <random>
#include <vector>

using namespace moltact;

namespace {

// The solution by trying every set of at most six active constraints: Gaussian elimination on the optimality conditions.
// False if no set satisfies them.
bool bruteForce(const Matrix6& b, const Six& pull, const std::vector<Six>& rows, const std::vector<double>& bounds,
                Six& best) {
  const std::size_t n = rows.size();
  double least = 1e300;
  bool found = false;
  for (unsigned set = 0; set < 1u << n; ++set) {
    std::vector<std::size_t> in;
    for (std::size_t k = 0; k < n; ++k)
      if (set >> k & 1u) in.push_back(k);
    if (in.size() > 6) continue;
    const std::size_t size = 6 + in.size();
    std::vector<std::vector<long double>> m(size, std::vector<long double>(size + 1, 0.0L));
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j < 6; ++j) m[i][j] = b.row[i][j];
      for (std::size_t k = 0; k < in.size(); ++k) m[i][6 + k] = -rows[in[k]][i], m[6 + k][i] = rows[in[k]][i];
      m[i][size] = pull[i];
    }
    for (std::size_t k = 0; k < in.size(); ++k) m[6 + k][size] = bounds[in[k]];
    bool regular = true;
    for (std::size_t i = 0; i < size && regular; ++i) {
      std::size_t pivot = i;
      for (std::size_t k = i; k < size; ++k)
        if (std::abs(m[k][i]) > std::abs(m[pivot][i])) pivot = k;
      std::swap(m[i], m[pivot]);
      regular = std::abs(m[i][i]) > 1e-12L;
      for (std::size_t k = 0; k < size && regular; ++k) {
        if (k == i) continue;
        const long double by = m[k][i] / m[i][i];
        for (std::size_t j = i; j <= size; ++j) m[k][j] -= by * m[i][j];
      }
    }
    if (!regular) continue;
    Six x;
    for (std::size_t i = 0; i < 6; ++i) x[i] = double(m[i][size] / m[i][i]);
    bool holds = true;
    for (std::size_t k = 0; k < in.size(); ++k) holds = holds && m[6 + k][size] / m[6 + k][6 + k] >= -1e-12L;
    for (std::size_t k = 0; k < n; ++k) holds = holds && dot(rows[k], x) >= bounds[k] - 1e-10;
    if (!holds) continue;
    double value = -dot(pull, x);
    for (std::size_t i = 0; i < 6; ++i) value += 0.5 * x[i] * dot(b.row[i], x);
    if (value < least) least = value, best = x;
    found = true;
  }
  return found;
}

}  // namespace

TEST_CASE("1500 random programs of up to nine constraints are solved as by trying all active sets, to 1e-8") {
  std::mt19937_64 random(20261125);
  CAPTURE("seed 20261125");
  std::normal_distribution<double> any;
  int feasible = 0, active = 0, infeasible = 0;
  double worst = 0.0, worst_balance = 0.0;
  for (int n = 0; n < 1500; ++n) {
    Matrix6 b;
    if (n % 3 == 0) {
      for (std::size_t i = 0; i < 6; ++i) b.row[i][i] = 1.0;
    } else {
      for (int k = 0; k < 9; ++k) {
        Six a;
        for (double& x : a.v) x = any(random);
        b.addOuter(k == 0 ? 10.0 : 0.3, a);
      }
      b.mirror();
    }
    const Factor6 factor = factored(b, 1e-9, 0.05);
    REQUIRE(factor.definite);
    Six pull;
    for (double& x : pull.v) x = 2.0 * any(random);
    std::vector<Six> rows(std::size_t(1 + n % 9));
    std::vector<double> bounds;
    for (Six& row : rows) {
      for (double& x : row.v) x = any(random);
      if (n % 5 == 0 && &row != &rows.front()) {  // nearly parallel
        row = rows.front();
        row[std::size_t(n) % 6] += 1e-4 * any(random);
      }
      bounds.push_back(0.5 * any(random) - 0.3);
    }
    SmallQp qp;
    const QpSolution got = qp.solve(n % 3 == 0 ? nullptr : &factor, pull, rows, bounds, {});
    Six right;
    if (!bruteForce(b, pull, rows, bounds, right)) {
      ++infeasible;
      CHECK_FALSE(got.feasible);
      continue;
    }
    REQUIRE(got.feasible);
    ++feasible;
    active += got.count;
    const double scale = 1.0 + length(right);
    Six off = got.step;
    off.add(-1.0, right);
    worst = std::max(worst, length(off) / scale);
    Six balance = pull;
    for (std::size_t i = 0; i < 6; ++i) balance[i] -= dot(b.row[i], got.step);
    double sum = 1.0;
    for (int k = 0; k < got.count; ++k) {
      CHECK(got.lambda[std::size_t(k)] >= 0.0);
      sum += got.lambda[std::size_t(k)];
      balance.add(got.lambda[std::size_t(k)], rows[std::size_t(got.rows[std::size_t(k)])]);
    }
    worst_balance = std::max(worst_balance, length(balance) / sum);
  }
  CHECK(worst < 1e-8);
  CHECK(worst_balance < 1e-9);
  CHECK(feasible > 1000);
  CHECK(active > 2000);
  CHECK(infeasible > 5);
}

TEST_CASE("opposing constraints that leave no room are not feasible, and equal ones are satisfied once") {
  SmallQp qp;
  const Six up({0, 0, 1}, Vec3(0.0)), down({0, 0, -1}, Vec3(0.0));
  const Six pull({1, 2, -3}, {0, 0, 0.5});
  CHECK_FALSE(qp.solve(nullptr, pull, std::vector{up, down}, std::vector{0.1, 0.1}, {}).feasible);
  const QpSolution same = qp.solve(nullptr, pull, std::vector{up, up, up}, std::vector{-0.5, -0.25, -0.5}, {});
  REQUIRE(same.feasible);
  CHECK(same.count == 1);
  CHECK(same.rows[0] == 1);
  CHECK(same.lambda[0] == doctest::Approx(2.75));
  CHECK(same.step[2] == doctest::Approx(-0.25));
  CHECK(same.step[0] == 1.0);
}

TEST_CASE("six constraints hold to 1e-12 A against a pull of 1e9 A") {
  std::mt19937_64 random(6);
  std::normal_distribution<double> any;
  SmallQp qp;
  double worst = 0.0;
  int in_corners = 0;
  for (int t = 0; t < 500; ++t) {
    std::array<Six, 6> rows;
    std::array<double, 6> bounds{};
    Six pull;
    Matrix6 b;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      for (double& x : rows[k].v) x = any(random);
      bounds[k] = -1e-3 * std::abs(any(random));
      pull.add(-1e9 * std::abs(any(random)), rows[k]);
      b.addOuter(1.0, rows[k]);
      b.row[k][k] += 1.0;
    }
    const Factor6 metric = factored(b, 1e-3, 0.05);
    const QpSolution out = qp.solve(t % 2 ? &metric : nullptr, pull, rows, bounds, {});
    REQUIRE(out.feasible);
    if (out.count < 6) continue;
    ++in_corners;
    for (std::size_t k = 0; k < rows.size(); ++k) worst = std::max(worst, bounds[k] - dot(rows[k], out.step));
  }
  CHECK(in_corners > 450);
  CHECK(worst < 1e-12);
}

TEST_CASE("a definite matrix gets its own factor, another that with half the absolute values of negative eigenvalues") {
  std::mt19937_64 random(3);
  std::normal_distribution<double> any;
  int modified = 0;
  for (int n = 0; n < 300; ++n) {
    Matrix6 b;
    for (int k = 0; k < 8; ++k) {
      Six a;
      for (double& x : a.v) x = any(random);
      b.addOuter(n % 2 ? 1.0 : any(random), a);
    }
    b.mirror();
    const Factor6 factor = factored(b, 1e-3, 0.05);
    modified += !factor.definite;
    Matrix6 product;
    for (std::size_t i = 0; i < 6; ++i)
      for (std::size_t j = 0; j < 6; ++j)
        for (std::size_t k = 0; k < 6; ++k) product.row[i][j] += factor.lower.row[i][k] * factor.lower.row[j][k];
    // B v = mu v becomes mu' v.
    Matrix6 axes;
    const Six values = eigenvalues(b, 6, axes);
    double worst = 0.0;
    for (std::size_t j = 0; j < 6; ++j) {
      const Six& axis = axes.row[j];
      CHECK(length(axis) == doctest::Approx(1.0));
      const double size = factor.definite ? values[j] : std::max(0.05, values[j] < 0.0 ? -0.5 * values[j] : values[j]);
      for (std::size_t i = 0; i < 6; ++i) {
        worst = std::max(worst, std::abs(dot(b.row[i], axis) - values[j] * axis[i]));
        worst = std::max(worst, std::abs(dot(product.row[i], axis) - size * axis[i]));
      }
    }
    CHECK(worst < 1e-9);
    Six along;
    const double least = smallestEigenvalue(b, 6, along);
    CHECK((least > 0.0 || !factor.definite));
  }
  CHECK(modified > 100);
}

TEST_CASE(
    "eigenvectors of 6000 symmetric matrices of 1 to 6 rows are orthonormal to 1e-13, also where values coincide") {
  std::mt19937_64 random(4);
  std::normal_distribution<double> any;
  double orthonormal = 0.0, equation = 0.0;
  for (int t = 0; t < 6000; ++t) {
    const auto n = std::size_t(1 + t % 6);
    const int kind = t / 6 % 6;  // full, diagonal, two equal blocks, multiple of the identity, all ones, of great range
    Matrix6 a;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j <= i; ++j) {
        const double x = any(random);
        a.row[i][j] = kind == 1   ? (i == j ? x : 0.0)
                      : kind == 2 ? (i / 3 == j / 3 ? 1.0 + double(i % 3 == j % 3) : 0.0)
                      : kind == 3 ? (i == j ? 2.0 : 0.0)
                      : kind == 4 ? 1.0
                                  : x;
      }
    if (kind == 5) {
      Six one;
      for (std::size_t i = 0; i < n; ++i) one[i] = any(random);
      a.addOuter(1e6, one);
    }
    a.mirror();
    double size = 0.0;
    for (const Six& row : a.row) size += length(row);
    Matrix6 axes;
    const Six values = eigenvalues(a, n, axes);
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t k = 0; k < n; ++k)
        orthonormal = std::max(orthonormal, std::abs(dot(axes.row[j], axes.row[k]) - double(j == k)));
      for (std::size_t i = 0; i < n; ++i)
        equation = std::max(equation, std::abs(dot(a.row[i], axes.row[j]) - values[j] * axes.row[j][i]) / size);
    }
  }
  CHECK(orthonormal < 1e-13);
  CHECK(equation < 1e-13);
}
