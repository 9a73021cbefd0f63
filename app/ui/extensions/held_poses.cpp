#include "app/ui/extensions/held_poses.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>

#include "app/ui/application/opener.h"
#include "app/ui/lesson/lesson_guide.h"
#include "engine/core/printable.h"
#include "engine/haptics/field/force_choices.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/lesson/pose_text.h"
#include "engine/lesson/tasks/held_way.h"
#include "engine/molecule/write_pose.h"
#include "engine/molecule/write_sdf.h"
#include "engine/structure/lewis_structure.h"

namespace moltact {
namespace {

constexpr std::size_t kMinimisedPairsOfFrame = 400'000;  // of a minimisation: about two milliseconds
constexpr int kMaxStepsOfFrame = 20;

const TaskSpec* taskWithPose(const LessonGuide& lesson) {
  const LessonSession* session = lesson.session();
  if (!session || !lesson.onStage()) return nullptr;
  for (const TaskSpec& task : session->step().tasks)
    if (task.kind == "dock" && parsePose(task.values["dock"].text)) return &task;
  return nullptr;
}

}  // namespace

double rmsdBetween_A(const HeldBody& body, const PoseA& one, const PoseA& other) {
  double sum = 0.0;
  for (const Sphere& s : body.spheres) {
    const Vec3 off = one.place.A + one.orientation * s.centre_A - (other.place.A + other.orientation * s.centre_A);
    sum += glm::dot(off, off);
  }
  return body.spheres.empty() ? 0.0 : std::sqrt(sum / double(body.spheres.size()));
}

bool HeldPoses::on() const { return scene_.stage().body && scene_.forces().field() && !scene_.playedHand().on(); }

// Energies of other forces cannot be compared.
std::string HeldPoses::forces() const {
  const TouchSetup touch = scene_.touch();
  return touch.forces + ' ' + touch.dielectric + ' ' + touch.charges;
}

const std::vector<HeldPose>& HeldPoses::list() const {
  static const std::vector<HeldPose> kNone;
  const auto found = on() ? lists_.find(forces()) : lists_.end();
  return found == lists_.end() ? kNone : found->second;
}

bool HeldPoses::taskOpen() const {
  const LessonSession* session = lesson_.session();
  return session && lesson_.onStage() && !session->stepDone();
}

std::optional<PoseA> HeldPoses::marked() const {
  if (selected_ && *selected_ < list().size()) return list()[*selected_].pose;
  return on() && minimum_ ? std::optional(minimum_->to.pose) : std::nullopt;
}

double HeldPoses::movedByMinimum_A() const {
  return minimum_ && body_ ? rmsdBetween_A(*body_, minimum_->from.pose, minimum_->to.pose) : 0.0;
}

bool HeldPoses::taskNamesPose() const { return taskWithPose(lesson_) != nullptr; }

double HeldPoses::offKnown_A(const HeldPose& pose) const {
  const HeldBody& body = *scene_.stage().body;
  const TaskSpec* task = taskWithPose(lesson_);
  return rmsdBetween_A(body, pose.pose, task ? writtenGoal(task->values["dock"].text, body) : PoseA{body.middle});
}

void HeldPoses::sceneChanged() {
  quiet_ticks_ = 0;
  const TouchableModel& stage = scene_.stage();
  if (stage.body == body_ && stage.spheres == spheres_) return;
  body_ = stage.body;
  spheres_ = stage.spheres;
  began_s_ = time_.now_s;
  taken_ = false;
  lists_.clear();
  selected_.reset();
  minimum_.reset();
  computing_.reset();
}

void HeldPoses::beforeTicks() {
  const bool held = on();
  std::string key = held ? forces() : std::string();
  if (key != key_ || taskOpen()) {
    key_ = std::move(key);
    selected_.reset();
    minimum_.reset();
    computing_.reset();
    quiet_ticks_ = 0;
  }
  if (taken_ && taskOpen()) {
    taken_ = false;
    opener_.beginSceneAgain();
  }
  if (!computing_) return;
  PoseMinimiser& run = computing_->minimiser;
  const std::size_t pairs = std::max<std::size_t>(1, computing_->sum.listedPairs());
  const int steps = std::clamp(int(kMinimisedPairsOfFrame / pairs), 1, kMaxStepsOfFrame);
  for (int k = 0; k < steps && !run.converged() && run.steps() < kMaxSteps; ++k) run.step();
  minimum_->to.pose = run.pose();
  minimum_->to.energy = run.energy().energy;
  minimum_->steps = run.steps();
  minimum_->converged = run.converged();
  minimum_->done = run.converged() || run.steps() >= kMaxSteps;
  if (minimum_->done) computing_.reset();
}

void HeldPoses::ticks(const FeltTicks& felt) {
  if (!on() || !(scene_.controls.hasPressed() || scene_.servo().deviceLeads())) return;
  for (const FeltTick& tick : felt.ticks) {
    const ServoSample& now = tick.sample;
    if (!now.holds_body || !now.molecular_energy || now.contact.fault != Fault::None || now.contact_reset) {
      quiet_ticks_ = 0;
      continue;
    }
    const PoseA pose = now.shownBody();
    if (quiet_ticks_ == 0 || !now.at_rest || rmsdBetween_A(*scene_.stage().body, pose, quiet_at_) > kMoved_A) {
      quiet_at_ = pose;
      quiet_ticks_ = 1;
    } else if (++quiet_ticks_ == kQuiet_ticks) {
      record(now);
      quiet_ticks_ = 0;
    }
  }
}

void HeldPoses::record(const ServoSample& sample) {
  const HeldPose found{sample.shownBody(), *sample.molecular_energy, time_.now_s - began_s_};
  const double energy = found.energy.total_kcal_mol();
  std::vector<HeldPose>& all = lists_[forces()];
  HeldPose* last = nullptr;
  std::size_t of_hand = 0;
  for (HeldPose& one : all)
    if (!one.minimised) last = &one, ++of_hand;
  if (!std::isfinite(energy) || energy > (last ? last->energy.total_kcal_mol() : 0.0) - kGain_kcal_mol) return;
  if (last && rmsdBetween_A(*scene_.stage().body, last->pose, found.pose) <= kSame_A) {
    *last = found;
    return;
  }
  if (of_hand >= kMaxPoses) {
    const auto oldest = std::find_if(all.begin(), all.end(), [](const HeldPose& p) { return !p.minimised; });
    const auto index = std::size_t(oldest - all.begin());
    all.erase(oldest);
    if (selected_ == index)
      selected_.reset();
    else if (selected_ && *selected_ > index)
      --*selected_;
  }
  all.push_back(found);
}

void HeldPoses::minimise() {
  const ServoSample& now = scene_.log().latest();
  if (!on() || taskOpen() || !now.molecular_energy) return;
  const PairField& field = *scene_.forces().field();
  PairModel whole = field.model;
  whole.wall_kcal_mol = std::numeric_limits<double>::infinity();
  computing_ = std::make_unique<Computation>(field, whole);
  const bool chosen = selected_ && *selected_ < list().size();
  const PoseA start = chosen ? list()[*selected_].pose : now.shownBody();
  computing_->minimiser.start(start);
  const HeldPose from{start, computing_->minimiser.energy().energy, time_.now_s - began_s_};
  minimum_ = Minimum{.from = from, .to = from};
  minimum_->to.minimised = true;
  selected_.reset();
}

void HeldPoses::addMinimum() {
  if (!on() || taskOpen() || !minimum_ || !minimum_->done || minimum_->listed) return;
  std::vector<HeldPose>& all = lists_[forces()];
  const auto of_minima = std::count_if(all.begin(), all.end(), [](const HeldPose& p) { return p.minimised; });
  if (std::size_t(of_minima) >= kMaxPoses)
    all.erase(std::find_if(all.begin(), all.end(), [](const HeldPose& p) { return p.minimised; }));
  all.push_back(minimum_->to);
  minimum_->listed = true;
  selected_ = all.size() - 1;
}

bool HeldPoses::canTake() const {
  return selected_ && *selected_ < list().size() && !list()[*selected_].minimised && !taskOpen() &&
         !scene_.force().trying();
}

void HeldPoses::take() {
  if (!canTake()) return;
  quiet_ticks_ = 0;
  scene_.view().holdAt(list()[*selected_].pose);
  taken_ = true;
}

namespace {

std::string poseNumber(double value, int digits) { return quantityNumber(value, Dimension::None, decimals(digits)); }

// Files are English in every language, as those of other programs.
std::string posePart(std::string_view name, char between, bool capitals) {
  std::string out;
  for (const char c : name)
    out += c == '-' ? between : capitals ? char(std::toupper(static_cast<unsigned char>(c))) : c;
  return out;
}

constexpr const char* kForcesOfPoses = "CUT-OFF 10 A, SWITCHED OFF FROM 8 A";

std::string parametersOfPoses(const Molecule& molecule) {
  return "AMBER FF14SB, OL15, OL3; OF LIGANDS GAFF, WITH " +
         std::string(molecule.charges_e.empty() ? "GASTEIGER CHARGES" : "THE CHARGES OF THE FILE");
}

}  // namespace

Expected<std::string> HeldPoses::saved(const std::string& ending) const {
  if (!selected_ || *selected_ >= list().size())
    return Problem{"", 0, 0, tr("no pose is selected"), tr("select a pose")};
  const HeldPose& chosen = list()[*selected_];
  std::vector<Vec3> places;
  for (const Sphere& s : scene_.stage().body->spheres)
    places.push_back(chosen.pose.place.A + chosen.pose.orientation * s.centre_A);
  if (ending == ".pdb") return pdb(chosen, places);
  if (ending == ".sdf") return sdf(chosen, places);
  return Problem{"", 0, 0,
                 ending.empty() ? std::string(tr("the name of the file has no ending"))
                                : trf("a pose cannot be saved as a file that ends in {0}", oneLine(ending)),
                 tr("give the file a name that ends in .pdb or .sdf")};
}

Expected<std::string> HeldPoses::pdb(const HeldPose& chosen, std::span<const Vec3> places_A) const {
  const Molecule& molecule = *scene_.stage().molecule;
  const HeldBody& body = *scene_.stage().body;
  const TouchSetup touch = scene_.touch();
  const MolecularEnergy& e = chosen.energy;
  std::string parts;
  for (const EnergyPartInfo& part : energyParts())
    parts += (parts.empty() ? "" : ", ") + posePart(part.name, ' ', true) + " " + poseNumber(e.parts[part.part], 3);
  const std::vector<std::string> remarks = {
      "ENERGY WITH " + molecule.id + ": " + poseNumber(e.total_kcal_mol(), 3) + " KCAL/MOL",
      parts + " KCAL/MOL",
      "FORCES " + touch.forces + ", DIELECTRIC " + touch.dielectric + ", " + kForcesOfPoses,
      "PARAMETERS: " + parametersOfPoses(molecule),
      "BOTH MOLECULES RIGID; NO WATER, NO IONS, NO ENTROPY: NOT A FREE ENERGY OF BINDING",
      std::string(chosen.minimised ? "POSE COMPUTED BY ENERGY MINIMISATION" : "POSE REACHED BY HAND") + ", " +
          poseNumber(rmsdBetween_A(body, chosen.pose, PoseA{body.middle}), 3) + " A RMSD FROM THE POSE OF THE FILE"};
  return posedPdb(molecule, body.atoms, places_A, "POSE OF A LIGAND IN " + molecule.id, remarks);
}

Expected<std::string> HeldPoses::sdf(const HeldPose& chosen, std::span<const Vec3> places_A) const {
  const Molecule& molecule = *scene_.stage().molecule;
  const HeldBody& body = *scene_.stage().body;
  const TouchSetup touch = scene_.touch();
  std::vector<char> wanted(molecule.atoms.size(), 0);
  for (const std::uint32_t atom : body.atoms) wanted[atom] = 1;
  const LewisStructure lewis = lewisStructure(molecule, wanted);
  std::vector<std::int8_t> charges_e;
  for (const std::uint32_t atom : body.atoms) charges_e.push_back(lewis.formal_charges_e[atom]);
  const MolecularEnergy& e = chosen.energy;
  std::vector<SdfItem> items = {{"energy_kcal_per_mol", poseNumber(e.total_kcal_mol(), 3)}};
  for (const EnergyPartInfo& part : energyParts())
    items.push_back({posePart(part.name, '_', false) + "_kcal_per_mol", poseNumber(e.parts[part.part], 3)});
  items.push_back({"receptor", molecule.id});
  items.push_back({"rmsd_from_file_A", poseNumber(rmsdBetween_A(body, chosen.pose, PoseA{body.middle}), 3)});
  items.push_back({"pose", chosen.minimised ? "energy minimisation" : "reached by hand"});
  items.push_back({"forces", touch.forces});
  items.push_back({"dielectric", touch.dielectric});
  items.push_back({"cutoff", kForcesOfPoses});
  items.push_back({"parameters", parametersOfPoses(molecule)});
  const std::uint32_t residue = molecule.atoms[body.atoms.front()].residue;
  const std::string name = residue == kNoResidue ? molecule.id : std::string(molecule.residues[residue].name);
  return posedSdf(molecule, {body.atoms, places_A, charges_e}, lewis.bonds, name,
                  "Both molecules rigid; no water, no ions, no entropy: no free energy of binding", items);
}

}  // namespace moltact
