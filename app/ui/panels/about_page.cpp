// Help > About: the program's purpose and version, its method, its licence and the libraries that it uses.
#include "app/ui/application/application.h"
#include "app/ui/widgets/controls.h"
#include "app/ui/widgets/theme.h"
#include "engine/language/catalogue.h"

namespace moltact {

void drawAboutPage(Application& app) {
  if (!beginPage("about", "Moltact " MOLTACT_VERSION, app.panels.pages.about, 520, 380)) return;
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextUnformatted(
      tr("Learn structural biology by touching molecules with a haptic probe, or with the mouse standing in for one."));
  ImGui::Spacing();
  ImGui::TextUnformatted(
      tr("It follows the surface of a molecule a thousand times a second, after M. J. Stocks and S. D. Laycock, "
         "“A Haptic Rendering Algorithm for Molecular Interaction” (2008): the atoms are spheres grown by the probe's "
         "radius, and your "
         "probe stays on their outside, on a sphere, in the crease between two, or in the pit between three."));
  ImGui::Spacing();
  ImGui::TextUnformatted(
      tr("MIT licence. Built on Dear ImGui, GLFW, GLM, gemmi, libepoxy, stb, FreeType, nlohmann-json and CLI11; set in "
         "Inter."));
  ImGui::PopTextWrapPos();
  endPage();
}

}  // namespace moltact
