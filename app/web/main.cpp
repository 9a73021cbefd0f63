// The browser edition's entry, called by app/web/page.js when the program's files are there. The language is that of the
// settings, else the browser's.
#include "app/ui/shell/window.h"

int main() { return moltact::runWindow({}); }
