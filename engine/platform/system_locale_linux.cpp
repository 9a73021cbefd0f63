#include "engine/platform/use_language.h"

std::string moltact::systemLocale() { return {}; }
