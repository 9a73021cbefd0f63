// Displacements as attempts store them: whole multiples of kRecorded_A, separated by spaces. Any thread.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/units.h"

namespace moltact {

inline constexpr double kRecorded_A = 0.01;

std::string textOfDisplacements(std::span<const Vec3> displacements_A);
/// Empty if the text is not one of textOfDisplacements.
std::vector<Vec3> displacementsOfText(std::string_view text);

}  // namespace moltact
