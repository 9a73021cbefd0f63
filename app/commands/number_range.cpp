#include "app/commands/number_range.h"

#include <cmath>
#include <cstdio>

namespace moltact {

CLI::Validator numberFrom(double min, double max) {
  char range[80];
  std::snprintf(range, sizeof range, "%g to %g", min, max);
  const std::string named = range;
  return CLI::Validator(
      [=](std::string& text) {
        double value = 0;
        const bool sound =
            CLI::detail::lexical_cast(text, value) && std::isfinite(value) && value >= min && value <= max;
        return sound ? std::string() : "'" + text + "' is not a number from " + named;
      },
      named);
}

}  // namespace moltact
