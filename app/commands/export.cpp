// moltact export: writes a molecule as a glTF file for slides, web pages and 3-D printing.
#include "app/commands/command.h"
#include "app/commands/look_options.h"
#include "app/commands/molecule_argument.h"
#include "app/commands/number_range.h"
#include "app/commands/outputs.h"
#include "app/commands/scene_options.h"
#include "app/commands/value_types.h"
#include "app/ui/lesson/scene_marks.h"
#include "engine/haptics/tracker.h"
#include "engine/platform/terminal.h"
#include "engine/render/gltf_export.h"

namespace moltact {
namespace {

struct ExportArguments {
  MoleculeArgument molecule;
  std::string out;
  LookOptions look;
  SceneOptions says;
  ExportOptions options;
};

void exportGltf(ExportArguments& a) {
  if (std::filesystem::path(a.out).extension() != ".glb")
    throw CLI::ValidationError(
        "OUT", "'" + a.out + "' does not end in .glb; the scene is written as binary glTF, as in 1ubq.glb");
  const Molecule molecule = a.says.atState(a.molecule.load(), a.molecule);
  checkOutputs({{"OUT", a.out}});
  const SceneSpec spec = a.says.scene(molecule);
  const std::vector<float> fluctuation_A =
      a.look.colour == "fluctuation" ? a.says.fluctuation_A(molecule) : std::vector<float>();
  a.options.look = a.look.look(molecule, {.fluctuation_A = fluctuation_A});
  a.options.look.marks = marksOf(spec, molecule);
  if (spec.highlight.given()) a.options.highlighted = spec.highlight.select(molecule);
  if (auto written = annotationsOf(spec, molecule)) a.options.annotations.push_back(std::move(written));
  // A single molecule has the customary element colours by default.
  a.options.colour_by = a.look.colour.empty() ? ColourBy::Element : a.look.colourBy(molecule);
  const Expected<GltfScene> scene = exportMolecule(molecule, a.options);
  if (!scene) throw CommandError{scene.problem().text()};
  if (const auto problem = writeGlb(a.out, *scene)) throw CommandError{problem->text()};
  std::size_t triangles = 0;
  for (const GltfNode& node : scene->nodes)
    if (node.mesh != GltfNode::kNone)
      for (const GltfPart& part : scene->meshes[node.mesh].parts) triangles += part.indices.size() / 3;
  out() << a.out << ": " << triangles << " triangles, " << scene->materials.size() << " colours, 1 unit is "
        << 1.0 / a.options.units_per_nm << " nm\n";
}

}  // namespace

void addExport(CLI::App& app) {
  auto* command =
      app.add_subcommand("export", "Export a molecule as a glTF file (.glb) for slides, web pages and printing");
  const auto arguments = std::make_shared<ExportArguments>();
  ExportArguments& a = *arguments;
  a.molecule.addTo(*command);
  command->add_option("OUT", a.out, "The .glb file to write")->type_name(kFileType)->required();
  a.look.addTo(*command);
  a.says.addMolecules(*command);
  command->add_flag("--print", a.options.print,
                    "Export one closed surface instead of the styles, as 3-D printing requires");
  command
      ->add_option("--probe", a.options.probe_A,
                   "Inflate spheres, and the surface for printing, by this radius in angstroms; 1.4 is that of a water "
                   "molecule. "
                   "The style 'surface' is the surface that such a probe can reach")
      ->check(numberFrom(0.0, kMaxProbe_A))
      ->capture_default_str();
  command
      ->add_option("--step", a.options.step_A,
                   "Resolution of the surface for printing in angstroms; 0 chooses it by the molecule's size")
      ->check(numberFrom(0.0, 10.0))
      ->capture_default_str();
  command
      ->add_option("--units-per-nm", a.options.units_per_nm,
                   "Units of the file per nanometre; with 0.01 a nanometre is 1 cm if a unit is 1 m")
      ->check(numberFrom(1e-6, 1e6))
      ->capture_default_str();
  command->callback([arguments] { exportGltf(*arguments); });
}

}  // namespace moltact
