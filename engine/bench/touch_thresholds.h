// The thresholds of a hand's perception, from the literature; docs/hands.md names the sources and says what they did
// not measure. Everything that the pages call felt is measured against these. Units: degree, newton, angstrom,
// millimetre.
#pragma once

#include <numbers>

namespace moltact::bench {

/// Force directions closer than this are not distinguished. Barbagli, Salisbury, Ho, Spence & Tan (2006)
/// found 18.4 degrees with a picture that agrees, 25.6 without one, 31.9 with one that does not.
inline constexpr double kDirectionSeen_deg = 18.4, kDirectionBlind_deg = 25.6, kDirectionMisled_deg = 31.9;

/// Sizes of a force that differ by less than this fraction are not distinguished. Pang, Tan & Durlach (1991): about
/// 7 % between 2.5 and 10 N; about 7 to 10 % over many studies.
inline constexpr double kForceWeber = 0.07, kForceWeberWide = 0.10;

/// The press of the made scenes, for which a fraction of the force becomes newtons and angstroms: 0.6 A deep.
inline constexpr double kUsualDepth_A = 0.6;

/// A place that is off by less cannot be felt: the force of the usual press then differs by 8 %.
inline constexpr double kPlaceFelt_A = 0.05;

/// A step of the force that can be felt, of the usual press with 0.3 N/mm at 0.25 A/mm (0.72 N): 7 %.
inline constexpr double kStepFelt_N = 0.05;

}  // namespace moltact::bench
