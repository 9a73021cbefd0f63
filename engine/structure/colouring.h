// Colours of atoms as data: a table of schemes, and what each makes of a molecule with the legend that says what its
// colours mean. Nothing is drawn here. Worked out when it is asked for, at a person's pace; pure functions, any thread but
// the haptic one. Colours are sRGB of 8 bits a channel.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/problem.h"
#include "engine/molecule/molecule.h"

namespace moltact {

using Rgb8 = std::array<std::uint8_t, 3>;

/// What the colours of a picture mean, in the language in use.
struct Legend {
  struct Entry {
    std::string name;  ///< "helix"; of a gradient the value there, with its unit
    Rgb8 colour{};
    friend bool operator==(const Entry&, const Entry&) = default;
  };
  std::string title;           ///< "Secondary structure"
  std::vector<Entry> parts;    ///< parts with colours of their own, in their order; shown first
  std::vector<Entry> entries;  ///< what the molecule has of it; of a gradient from its low end to its high end
  bool gradient = false;       ///< between the entries the colours go evenly from one to the next
};

struct Colouring {
  std::string_view scheme;    ///< the name of its ColouringScheme
  std::vector<Rgb8> of_atom;  ///< one for each of Molecule::atoms
  Legend legend;
};

/// One way of colouring; a row of the table in colouring.cpp.
struct ColouringScheme {
  std::string_view name;  ///< as in a scene's `colour: residue-type` and in `--colour`
  const char* label;      ///< of menus and legends, in English
  const char* sentence;   ///< what its colours mean, for a tool tip, `--help` and the authors' reference, in English
  void (*colour)(const Molecule& molecule,
                 Colouring& out);  ///< fills `of_atom`, made as long as the atoms, and `legend`

  /// The label in the language in use.
  const char* shownLabel() const;
};

/// All of them in the order in which they are offered; the first is that of a scene that asks for none.
std::span<const ColouringScheme> colouringSchemes();

/// The scheme of that name; a Problem that lists the names where there is none.
Expected<const ColouringScheme*> findColouringScheme(std::string_view name);

Colouring colourMolecule(const Molecule& molecule, const ColouringScheme& scheme);

/// A part of the molecule in a colour of its own.
struct OwnColour {
  std::vector<std::uint32_t> atoms;  ///< indices; out-of-range ones are ignored
  Rgb8 colour{};
  std::string name;  ///< for the legend; none where it is empty
};
/// Over the colours of a scheme; of two parts with an atom in common the later has it. Their names become the legend's
/// parts.
void colourParts(Colouring& colouring, std::span<const OwnColour> parts);

/// "red", a name of the table of own colours, or "#1f77b4"; a Problem that lists the names where it is neither.
Expected<Rgb8> parseColour(std::string_view text);
/// The names of own colours, in the order in which they are offered.
struct NamedColour {
  std::string_view name;
  Rgb8 colour;
};
std::span<const NamedColour> namedColours();

/// How far apart two colours look: the distance in the space CIE L*a*b* (1976) under the white of D65. Less than 10 is
/// hard to tell across a picture.
double colourDistance(const Rgb8& a, const Rgb8& b);
/// The channels of sRGB without its gamma, 0 to 1, and such a colour in that space: L*, a*, b*.
std::array<double, 3> linearRgb(const Rgb8& colour);
std::array<double, 3> labOfLinear(const std::array<double, 3>& rgb);

}  // namespace moltact
