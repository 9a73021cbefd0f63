// Colours as people with every kind of colour vision see them, and shades that all of them can tell apart. Pure functions;
// any thread but the haptic one. Colours are sRGB of 8 bits a channel.
#pragma once

#include <span>
#include <vector>

#include "engine/structure/colouring.h"

namespace moltact {

/// The smallest CIEDE2000 distance between two colours among normal sight, protanopia, deuteranopia and tritanopia. The
/// three are simulated by the matrices of Machado, Oliveira and Fernandes (2009) for the whole loss of one cone, tritanopia
/// also by Brettel, Viénot and Mollon (1997).
double leastSeenDistance(const Rgb8& a, const Rgb8& b);

/// Two colours of marks, or of a mark and a target, that are at least so far apart are easy to tell in a picture.
inline constexpr double kMarksApart = 15.0;
/// The same between a mark and what is drawn beside it, which differs in its form too.
inline constexpr double kBesideApart = 10.0;

/// A lighter or darker shade of each wanted colour, or the colour itself, such that for every kind of sight they keep
/// kMarksApart from one another and from `targets`, and then kBesideApart from `beside`; of all such choices the one that
/// changes the colours least. Where none reaches that, the one with the greatest least distance. Hues stay, so that the
/// name of a colour stays true.
std::vector<Rgb8> shadesApart(std::span<const Rgb8> wanted, std::span<const Rgb8> targets,
                              std::span<const Rgb8> beside);

}  // namespace moltact
