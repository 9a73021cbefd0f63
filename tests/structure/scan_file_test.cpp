// Oracle: the bytes of the formats, written by hand from their descriptions.
#include "engine/structure/scan_file.h"

#include <doctest/doctest.h>

#include <cmath>
#include <cstring>

using namespace moltact;

namespace {

HeightField smallField() {
  HeightField field;
  field.columns = 3;
  field.rows = 2;
  field.spacing_A = 0.5;
  field.heights_A = {0, 1.5, 2, 0.25, 0, 4};
  field.atoms = {-1, 0, 1, 0, -1, 7};
  return field;
}

}  // namespace

TEST_CASE("the table of a scan of 3 x 2 nodes has a line for each, with the number of its atom") {
  CHECK(scanTable(smallField()) ==
        "x_A,y_A,height_A,atom\n0,0,0,0\n0.5,0,1.5,1\n1,0,2,2\n0,0.5,0.25,1\n0.5,0.5,0,0\n1,0.5,4,8\n");
}

TEST_CASE(
    "a simple field is a text, 1 to 4 zeros up to a multiple of 4, and the heights in metres, the last line first") {
  for (const std::string title : {"a", "ab", "abc", "abcd", "a\nb"}) {
    CAPTURE(title);
    const std::string bytes = gwyddionField(smallField(), title);
    std::string shown = title;
    if (shown.size() == 3 && shown[1] == '\n') shown[1] = ' ';
    const std::string header =
        "Gwyddion Simple Field 1.0\nXRes = 3\nYRes = 2\nXReal = 1.5e-10\nYReal = 1e-10\nXYUnits = m\nZUnits = m\n"
        "Title = " +
        shown + "\n";
    REQUIRE(bytes.substr(0, header.size()) == header);
    const std::size_t data = bytes.size() - 6 * 4, zeros = data - header.size();
    CHECK(data % 4 == 0);
    CHECK((zeros >= 1 && zeros <= 4));
    CHECK(bytes.substr(header.size(), zeros) == std::string(zeros, '\0'));
    const double expected_A[] = {0.25, 0, 4, 0, 1.5, 2};
    for (std::size_t k = 0; k < 6; ++k) {
      const auto* at = reinterpret_cast<const unsigned char*>(bytes.data() + data + 4 * k);
      const std::uint32_t bits = at[0] | at[1] << 8 | at[2] << 16 | std::uint32_t(at[3]) << 24;
      float value = 0;
      std::memcpy(&value, &bits, 4);
      CHECK(std::abs(value - 1e-10 * expected_A[k]) < 1e-17);
    }
  }
}
