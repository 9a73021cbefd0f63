// The browser edition's entry: the window, opened by app/web/page.js with what its address asks for.
#include "app/ui/shell/window.h"

int main(int argc, char** argv) {
  return moltact::runWindow(
      {.file = argc > 1 ? argv[1] : "", .frame_stats = false, .language = argc > 2 ? argv[2] : "", .state_text = {}});
}
