// Titles of quantities that touch tasks measure. Any thread.
#pragma once

#include <string>

namespace moltact {

/// The translated title of a quantity by its name in attempts: "path length" for "way", else the name itself.
std::string figureTitle(const std::string& name);

}  // namespace moltact
