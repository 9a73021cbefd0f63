// The rows of numbers between a page and its worker. A row whose count does not fit is rejected. Any other is read, has as
// many atoms as its count says, and reads the same when it is written again. The first byte chooses the kind of the row.
#include <cmath>
#include <cstring>
#include <vector>

#include "engine/dynamics/simulation_message.h"
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

}  // namespace moltact::fuzz
