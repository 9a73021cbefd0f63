// moltact scan MOLECULE: the picture of a tip that scans the molecule.
#include <algorithm>
#include <filesystem>
#include <memory>

#include "app/commands/atoms_option.h"
#include "app/commands/command.h"
#include "app/commands/molecule_argument.h"
#include "app/commands/number_range.h"
#include "app/commands/outputs.h"
#include "app/commands/scene_options.h"
#include "app/commands/value_types.h"
#include "app/ui/lesson/lesson_guide.h"
#include "engine/fonts/font_files.h"
#include "engine/haptics/height_field/scanning_tip.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/platform/interrupt.h"
#include "engine/platform/terminal.h"
#include "engine/platform/write_file.h"
#include "engine/render/height_picture.h"
#include "engine/structure/scan_file.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

struct ScanArguments {
  MoleculeArgument molecule;
  SceneOptions says;
  ExcludedAtoms left_out;
  ScanSetup setup;
  std::vector<std::string> out;
  double margin_A = -1.0;  // below 0: the tip's radius
};

// Endings in any case: Gwyddion and Windows write .GSF.
std::string scanEnding(const fs::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return ending;
}

void writeScan(const fs::path& file, const HeightField& field, const std::string& title) {
  const std::string ending = scanEnding(file);
  if (ending == ".png") {
    const Picture picture = paintedScan(field);
    if (picture.rgb.empty())
      throw CommandError{"names cannot be written: there is no font " + interFile("Inter-Regular.otf").string()};
    if (const auto problem = writePng(file, picture)) throw CommandError{problem->text()};
    return;
  }
  const std::string text = ending == ".csv" ? scanTable(field) : gwyddionField(field, title);
  if (const auto problem = writeWhole(file, text)) throw CommandError{problem->text()};
}

void runScan(ScanArguments& a) {
  std::vector<NamedOutput> outputs;
  for (const std::string& name : a.out) {
    const std::string ending = scanEnding(name);
    if (ending != ".png" && ending != ".csv" && ending != ".gsf")
      throw CLI::ValidationError(
          "--out", "'" + name + "' does not end in .png (a picture), .csv (a table) or .gsf (Gwyddion's simple field)");
    outputs.push_back({"--out", name});
  }
  const Molecule molecule = a.molecule.load();
  checkOutputs(outputs);
  a.setup.margin_A = a.margin_A < 0.0 ? a.setup.tip_A : a.margin_A;
  if (!a.says.view.empty()) {
    Camera camera;
    const SceneSpec spec = a.says.scene(molecule);
    faceView(camera, molecule, spec.view, spec);
    a.setup.orientation = camera.orientation;
  }
  auto tip = ScanningTip::over(molecule.spheres, a.setup, a.left_out.notFelt(molecule));
  if (!tip) throw CommandError{tip.problem().text()};
  const InterruptWatch interrupt;
  for (int shown = -1; !tip->done(); tip->scanLine()) {
    if (interrupt.seen()) {
      showStatus({});
      throw CommandError{tr("the calculation was cancelled; nothing is written"), 130};
    }
    const int percent = 100 * tip->linesDone() / tip->field().rows;
    if (percent == shown) continue;
    shown = percent;
    showStatus(trf("scanning: {0} %", percent));
  }
  showStatus({});
  const HeightField& field = tip->field();
  for (const std::string& name : a.out) {
    writeScan(name, field, molecule.id);
    out() << name << ": " << field.columns << " x " << field.rows << " nodes, " << field.spacing_A
          << " A apart, heights up to " << quantityNumber(highest_A(field, field.rows), Dimension::None, decimals(3))
          << " A\n";
  }
}

}  // namespace

void addScan(CLI::App& app) {
  const auto arguments = std::make_shared<ScanArguments>();
  ScanArguments& a = *arguments;
  CLI::App* command =
      app.add_subcommand("scan", "Scan a molecule with the tip of an atomic force microscope, line by line");
  a.molecule.addTo(*command);
  command
      ->add_option("-o,--out", a.out,
                   "The file to write, by its ending: .png (a picture), .csv (a table), .gsf (Gwyddion's simple "
                   "field). May be given several times")
      ->type_name(kFileType)
      ->required();
  command->add_option("--tip", a.setup.tip_A, "Radius of the tip's apex in angstroms")
      ->check(numberFrom(0.0, kMaxTip_A))
      ->capture_default_str();
  command
      ->add_option("--cone", a.setup.cone_deg,
                   "Half the opening angle of the cone above the apex in degrees; 0: a ball alone")
      ->check(numberFrom(0.0, kMaxCone_deg))
      ->capture_default_str();
  command->add_option("--spacing", a.setup.spacing_A, "Distance of the lines, and of the nodes on a line, in angstroms")
      ->check(numberFrom(kMinScanSpacing_A, kMaxScanSpacing_A))
      ->capture_default_str();
  command
      ->add_option("--margin", a.margin_A,
                   "Distance from the atoms to the border of the scan in angstroms; default: the tip's radius")
      ->check(numberFrom(0.0, kMaxScanMargin_A));
  command->add_option("--force", a.setup.force_pN, "Constant force of the tip in piconewtons; 0: contact without force")
      ->check(numberFrom(0.0, kMaxScanForce_pN))
      ->capture_default_str();
  command
      ->add_option("--contact", a.setup.contact_N_per_m,
                   "With --force, the stiffness of an atom's contact in newtons per metre")
      ->check(numberFrom(kMinContact_N_per_m, kMaxContact_N_per_m))
      ->capture_default_str();
  command->add_option(
      "--view", a.says.view,
      "Viewpoint from which the tip comes, as in a scene: 'top', 'left', 'facing residue 35', 'turned 30 10 0'. "
      "Default: from the file's +z, with its +x to the right");
  a.left_out.addTo(*command);
  command->callback([arguments] { runScan(*arguments); });
}

}  // namespace moltact
