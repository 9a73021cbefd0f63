// The entry point of the browser edition. app/web/page.js calls it after loading the program's files. The language is
// that of the settings, else the browser's.
#include "app/ui/shell/window.h"

int main() { return moltact::runWindow({}); }
