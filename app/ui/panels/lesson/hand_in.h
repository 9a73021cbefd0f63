// What a student hands in: the file of the attempt that is open, as it is kept (docs/results.md). Window's thread.
#pragma once

namespace moltact {

class Application;

/// Whether there is anything to hand in.
bool canHandIn(const Application& app);

/// Asks where a copy of the attempt is to go; in a page it is downloaded.
void handIn(Application& app);

}  // namespace moltact
