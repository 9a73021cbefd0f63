// Handing in: a copy of the open attempt's file (docs/results.md). Window's thread.
#pragma once

namespace moltact {

class Application;

/// Whether an attempt is open.
bool canHandIn(const Application& app);

/// Asks where to save a copy of the attempt. A browser downloads it.
void handIn(Application& app);

}  // namespace moltact
