#include "engine/language/figure_title.h"

#include "engine/language/catalogue.h"

namespace moltact {

std::string figureTitle(const std::string& name) { return name == "way" ? tr("path length") : tr(name.c_str()); }

}  // namespace moltact
