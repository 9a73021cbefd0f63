// Thresholds of the hand's perception from the literature; docs/hands.md names the sources and their limitations.
// "Felt" on the pages refers to these thresholds. Units: degree, newton, angstrom, millimetre.
#pragma once

#include <numbers>

namespace moltact::bench {

/// Directions of force closer than this are not distinguished. Barbagli, Salisbury, Ho, Spence & Tan (2006) found 18.4
/// degrees with consistent visual feedback, 25.6 without, 31.9 with inconsistent feedback.
inline constexpr double kDirectionSeen_deg = 18.4, kDirectionBlind_deg = 25.6, kDirectionMisled_deg = 31.9;

/// Sizes of a force that differ by less than this fraction are not distinguished. Pang, Tan & Durlach (1991): about
/// 7 % between 2.5 and 10 N; about 7 to 10 % over many studies.
inline constexpr double kForceWeber = 0.07, kForceWeberWide = 0.10;

/// The usual press, 0.6 A deep; it converts fractions of a force to newtons and angstroms.
inline constexpr double kUsualDepth_A = 0.6;

/// A smaller error of position cannot be felt: the force of the usual press then differs by 8 %.
inline constexpr double kPlaceFelt_A = 0.05;

/// Perceptible step of the force: 7 % of the usual press with 0.3 N/mm at 0.25 A/mm (0.72 N).
inline constexpr double kStepFelt_N = 0.05;

}  // namespace moltact::bench
