#include "engine/lesson/pose_text.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "engine/haptics/contact.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/lesson/quantity.h"
#include "engine/lesson/value_parts.h"

namespace moltact {

using values::at;

Expected<WrittenPose> parsePose(std::string_view text) {
  const std::vector<std::string_view> fields = values::unquotedParts(text, ",");
  const std::string remedy = tr("write X, Y, Z in angstroms, or X, Y, Z, QW, QX, QY, QZ with a quaternion");
  if (fields.size() != 3 && fields.size() != 7)
    return at(text, text, trf("a pose has 3 or 7 numbers, here are {0}", fields.size()), remedy);
  std::array<double, 7> numbers{};
  for (std::size_t k = 0; k < fields.size(); ++k) {
    const auto number = parseNumber(fields[k]);
    if (!number) return at(text, fields[k], trf("'{0}' is no number", fields[k]), remedy);
    if (k < 3 && std::abs(*number) > kMaxPosition_A)
      return at(text, fields[k], tr("this number is too large or too small for a coordinate"),
                trf("keep coordinates within {0}", quantityText(kMaxPosition_A, Dimension::Length, plain())));
    numbers[k] = *number;
  }
  WrittenPose pose{{{numbers[0], numbers[1], numbers[2]}}, {}};
  if (fields.size() == 3) return pose;
  const Quat q(numbers[3], numbers[4], numbers[5], numbers[6]);
  constexpr double kOff = 0.05;  // of the length of a quaternion that a person has written
  if (!(std::abs(glm::length(q) - 1.0) <= kOff))
    return at(text, fields[3], tr("these four numbers are no rotation"),
              tr("write a quaternion of length 1; without a rotation it is 1, 0, 0, 0"));
  pose.orientation = glm::normalize(q);
  return pose;
}

}  // namespace moltact
