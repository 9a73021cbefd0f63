// Colours of atoms as data: a table of schemes, and for each scheme the colours and the legend of a molecule. Computed
// on request, not in a tick; pure functions, any thread except the haptic one. Colours are sRGB with 8 bits per
// channel.
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

/// The meaning of a picture's colours, translated.
struct Legend {
  struct Entry {
    std::string name;  ///< "helix"; for a gradient the value with its unit
    Rgb8 colour{};
    friend bool operator==(const Entry&, const Entry&) = default;
  };
  std::string title;           ///< "Secondary structure"
  std::vector<Entry> parts;    ///< parts with colours of their own, in order; shown first
  std::vector<Entry> entries;  ///< entries that occur in the molecule; for a gradient from its low to its high end
  bool gradient = false;       ///< colours are interpolated linearly between the entries
};

/// The colours of a molecule's atoms.
struct Colouring {
  std::string_view scheme;    ///< name of the ColouringScheme
  std::vector<Rgb8> of_atom;  ///< one per atom
  Legend legend;
  bool pending = false;  ///< the colours are not known yet (ColouringInput::later)
};

/// What a scheme may depend on besides the molecule.
struct ColouringInput {
  std::string_view dielectric = "water";      ///< as in dielectricChoices (engine/haptics/field/force_choices.h)
  std::span<const std::uint32_t> held = {};   ///< atoms in the hand, ascending, which are apart from the others
  std::span<const float> fluctuation_A = {};  ///< of each atom in a trajectory (TrajectorySurvey); empty: not known
  bool later =
      false;  ///< a scheme that takes long returns a grey placeholder, whose legend says so, with `pending` set
};

/// A colour scheme; a row of the table in colouring.cpp.
struct ColouringScheme {
  std::string_view name;  ///< as in a scene's `colour: residue-type` and in `--colour`
  const char* label;      ///< in menus and legends; untranslated (N_)
  const char* sentence;   ///< description for tool tips, `--help` and the authors' reference; untranslated (N_)
  /// Fills `of_atom`, which already has one element per atom, and `legend`.
  void (*colour)(const Molecule& molecule, const ColouringInput& input, Colouring& out);

  /// The translated label.
  const char* shownLabel() const;
};

/// The colouring `potential` of potentials computed by SurfacePotential, one for each atom.
Colouring potentialColouring(std::span<const float> potential);

/// All schemes in menu order; the first is the default of a scene.
std::span<const ColouringScheme> colouringSchemes();

/// Finds a scheme by name; otherwise returns a Problem that lists the names.
Expected<const ColouringScheme*> findColouringScheme(std::string_view name);

Colouring colourMolecule(const Molecule& molecule, const ColouringScheme& scheme, const ColouringInput& input = {});

/// A part of the molecule with a colour of its own.
struct OwnColour {
  std::vector<std::uint32_t> atoms;  ///< indices; those out of range are ignored
  Rgb8 colour{};
  std::string name;  ///< in the legend; empty: no entry
};
/// Overrides the colours of a scheme. Later parts override earlier ones. Their names become Legend::parts.
void colourParts(Colouring& colouring, std::span<const OwnColour> parts);

/// Parses a name of the table of own colours ("red") or "#1f77b4"; otherwise returns a Problem that lists the names.
Expected<Rgb8> parseColour(std::string_view text);
/// A named colour, for parts with colours of their own.
struct NamedColour {
  std::string_view name;
  Rgb8 colour;
};
std::span<const NamedColour> namedColours();

/// The perceived difference between two colours: the distance in CIE L*a*b* (1976) with white point D65. Less than 10
/// is hard to distinguish across a picture.
double colourDistance(const Rgb8& a, const Rgb8& b);
/// Linear channels of an sRGB colour, 0 to 1; and a linear colour converted to L*, a*, b*.
std::array<double, 3> linearRgb(const Rgb8& colour);
std::array<double, 3> labOfLinear(const std::array<double, 3>& rgb);

}  // namespace moltact
