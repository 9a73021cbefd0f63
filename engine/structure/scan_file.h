// The files of a scan: a table (CSV) and Gwyddion's simple field (.gsf, version 1.0). Any thread except the haptic one.
// Units: angstrom in memory and in the table, metre in the simple field.
#pragma once

#include <string>
#include <string_view>

#include "engine/haptics/height_field/height_field.h"

namespace moltact {

/// A line for each node, from y = 0: x_A,y_A,height_A,atom. `atom` is the index of the atom that stops the tip, counted
/// from 1 in the order of the file; 0: the substrate.
std::string scanTable(const HeightField& field);

/// The bytes of a simple field. Its first line is that of the greatest y, which is at the top of the picture. A pixel is
/// a square of the spacing around its node. Heights are rounded to 24 bits.
std::string gwyddionField(const HeightField& field, std::string_view title);

}  // namespace moltact
