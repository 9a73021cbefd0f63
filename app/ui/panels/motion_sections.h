// The sections of the tab Motion, one for each mover of atoms: draw<Class>Section for each row of MOLTACT_ATOM_MOVERS. A
// section draws nothing where its mover has nothing to offer. Window's thread.
#pragma once

#include "app/ui/extensions/atom_movers.h"

namespace moltact {

class Application;

/// Draws the section. Returns true if its mover moves the atoms, so that no section follows.
#define MOLTACT_SECTION(Mover) bool draw##Mover##Section(Application& app);
MOLTACT_ATOM_MOVERS(MOLTACT_SECTION)
#undef MOLTACT_SECTION

}  // namespace moltact
