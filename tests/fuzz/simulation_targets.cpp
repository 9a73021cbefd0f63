// Kept modes of an elastic network, and the rows of numbers between a page and its worker. A row whose count does not
// fit is rejected. Any other is read, has as many atoms as its count says, and reads the same when it is written again.
// The first byte chooses the kind of the row.
// Accepted modes are finite, ascending and as many as the network has nodes, and read the same when written again.
#include <cmath>
#include <cstring>
#include <vector>

#include "engine/core/content_hash.h"
#include "engine/dynamics/network_solution.h"
#include "engine/dynamics/simulation_message.h"
#include "engine/molecule/reader.h"
#include "tests/fuzz/target.h"

namespace moltact::fuzz {
namespace {

// To the last bit, but for numbers that are none.
bool sameRow(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t k = 0; k < a.size(); ++k)
    if (a[k] != b[k] && !(std::isnan(a[k]) && std::isnan(b[k]))) return false;
  return true;
}

template <class Read>
auto readTwice(const std::vector<double>& row, std::size_t head, std::size_t each, Read read) {
  const auto got = read(row);
  mustBe(got.has_value() == (row.size() >= head && (row.size() - head) % each == 0), "a row whose count fits");
  if (got) {
    const std::vector<double> written = numbersOf(*got);
    const auto again = read(written);
    mustBe(again && written.size() == row.size() && sameRow(numbersOf(*again), written), "the same when written again");
  }
  return got;
}

}  // namespace

void simulationMessage(std::string_view bytes) {
  const int kind = bytes.empty() ? 0 : static_cast<unsigned char>(bytes.front()) % 3;
  if (!bytes.empty()) bytes.remove_prefix(1);
  std::vector<double> row(bytes.size() / sizeof(double));
  if (!row.empty()) std::memcpy(row.data(), bytes.data(), row.size() * sizeof(double));
  if (kind == 0) {
    const auto command = readTwice(row, 7, 8, commandOf);
    mustBe(!command || command->command.pushes.size() == (row.size() - 7) / 8, "eight numbers for each push");
  } else if (kind == 1) {
    const auto frame = readTwice(row, 9, 3, frameOf);
    mustBe(!frame || frame->positions_A.size() == (row.size() - 9) / 3, "three numbers for each atom of a frame");
  } else {
    const auto start = readTwice(row, 5, 3, startOf);
    mustBe(!start || start->positions_A.size() == (row.size() - 5) / 3, "three numbers for each atom of a start");
  }
}

// A tetrahedron; the seeds belong to it.
const ElasticNetwork& tetrahedron() {
  static const ElasticNetwork network = [] {
    const auto molecule = readMoleculeBytes(
        "ATOM      1  CA  ALA A   1       5.000   5.000   5.000  1.00 10.00           C\n"
        "ATOM      2  CA  ALA A   2       5.000  -5.000  -5.000  1.00 10.00           C\n"
        "ATOM      3  CA  ALA A   3      -5.000   5.000  -5.000  1.00 10.00           C\n"
        "ATOM      4  CA  ALA A   4      -5.000  -5.000   5.000  1.00 10.00           C\nEND\n",
        "four.pdb");
    return *ElasticNetwork::make(*molecule);
  }();
  return network;
}

// The check number at the end is made here, so that changed bytes get past it.
void modes(std::string_view bytes) {
  std::string whole(bytes);
  const std::uint64_t check = hash64(bytes);
  for (int k = 0; k < 8; ++k) whole += static_cast<char>(check >> (8 * k) & 0xff);
  const auto solution = solutionIn(whole, tetrahedron(), 6);
  mustBe(!solutionIn(bytes, tetrahedron(), 6) || bytes.size() > 8, "no solution without a check number");
  if (!solution) return;
  mustBe(solution->modes.nodes == 4 && solution->compliances.size() == 4, "four nodes");
  mustBe(solution->modes.vectors.size() == 4 * solution->modes.count(), "a vector of each node in each mode");
  double before = 0.0;
  for (const double e : solution->modes.eigenvalues) {
    mustBe(std::isfinite(e) && e > 0.0 && e >= before, "eigenvalues in order");
    before = e;
  }
  for (const Vec3& v : solution->modes.vectors)
    for (int c = 0; c < 3; ++c) mustBe(std::isfinite(v[c]), "finite modes");
  mustBe(bytesOf(*solution, tetrahedron(), 6) == whole, "the same when written again");
}

}  // namespace moltact::fuzz
