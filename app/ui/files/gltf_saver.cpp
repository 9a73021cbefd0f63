#include "app/ui/files/gltf_saver.h"

#include "app/ui/application.h"
#include "app/ui/widgets/theme.h"
#include "engine/language/catalogue.h"
#include "engine/render/gltf_export.h"

namespace moltact {
namespace {

void save(Application& app, const std::filesystem::path& file) {
  if (!app.scene.stage()) return;
  const Expected<GltfScene> scene =
      exportMolecule(*app.scene.stage().molecule, {.colours = elementColoursOf(app.settings)});
  if (!scene) return app.messages.error(scene.problem().text());
  if (const auto problem = writeGlb(file, *scene)) return app.messages.error(problem->text());
  app.messages.notice(trf("Molecule saved as {0}; 1 unit is 1 nm", file.string()));
}

}  // namespace

void askForGltf(Application& app) {
  app.file_dialog.ask({.title = tr("Save the molecule as a 3-D model"),
                       .name = app.scene.file().stem().string() + ".glb",
                       .ending = ".glb",
                       .chosen = &save},
                      app.options().picture_folder);
}

}  // namespace moltact
