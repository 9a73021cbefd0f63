// Colour distances for normal vision, protanopia, deuteranopia and tritanopia, and shades that can be distinguished with
// each of them. Pure functions; any thread except the haptic one. Colours are sRGB with 8 bits per channel.
#pragma once

#include <span>
#include <vector>

#include "engine/structure/colouring.h"

namespace moltact {

/// The smallest CIEDE2000 distance between two colours among normal vision, protanopia, deuteranopia and tritanopia.
/// The simulation uses the matrices of Machado, Oliveira and Fernandes (2009) for the complete loss of one cone type;
/// for tritanopia also the method of Brettel, Viénot and Mollon (1997).
double minSeenDistance(const Rgb8& a, const Rgb8& b);

/// Colours of two marks, or of a mark and a target, that differ by at least this are easy to distinguish.
inline constexpr double kMarksApart = 15.0;
/// The same for a mark and objects that also differ in shape.
inline constexpr double kBesideApart = 10.0;

/// Returns a lighter or darker shade of each wanted colour, or the colour itself. For each of these four types of vision
/// the results differ by kMarksApart from each other and from `targets`, and by kBesideApart from `beside`. Among all
/// such choices the total change is minimal. If no choice meets the limits, returns the one whose smallest distance is
/// largest. Hues are kept, so that a colour's name remains valid.
std::vector<Rgb8> shadesApart(std::span<const Rgb8> wanted, std::span<const Rgb8> targets,
                              std::span<const Rgb8> beside);

}  // namespace moltact
