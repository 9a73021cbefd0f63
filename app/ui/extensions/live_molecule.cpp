#include "app/ui/extensions/live_molecule.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <system_error>
#include <utility>

#include "app/ui/application/application_options.h"
#include "app/ui/extensions/displacement_text.h"
#include "app/ui/lesson/lesson_guide.h"
#include "app/ui/widgets/messages.h"
#include "engine/dynamics/felt_atoms.h"
#include "engine/haptics/field/force_choices.h"
#include "engine/haptics/field/pair_model.h"
#include "engine/haptics/pull_spring.h"
#include "engine/language/catalogue.h"
#include "engine/lesson/lesson_molecules.h"

namespace moltact {
namespace {

namespace fs = std::filesystem;

// English in every language, as the other words of attempts.
std::string engineText(const EngineFacts& engine) {
  char text[160];
  std::snprintf(text, sizeof text, "%s, %s, steps of %g fs, seed %u", engine.name.c_str(), engine.platform.c_str(),
                1000.0 * engine.step_ps, unsigned(MdStart().seed));
  return text;
}

}  // namespace

Expected<LiveMolecule::Opened> LiveMolecule::openFile(const fs::path& system,
                                                      const std::shared_ptr<const Molecule>& molecule,
                                                      SimulationPace pace) {
  try {
    MdStart start;
    start.temperature_K = kUsual_K;
    start.friction_per_ps = kFriction_per_ps;
    start.hold_kcal_mol_A2 = kHold_kcal_mol_A2;
    return beginSimulation(system, molecule, std::move(start), pace);
  } catch (const std::exception& e) {
    return Problem{system.filename().string(), 0, 0, trf("the simulation cannot begin: {0}", e.what()), {}};
  }
}

Expected<LiveMolecule::Opened> LiveMolecule::openAddress(const SimulationAddress& address,
                                                         const std::shared_ptr<const Molecule>& molecule,
                                                         const std::shared_ptr<const std::atomic<bool>>& cancelled) {
  std::vector<Vec3> start_A;
  for (const Sphere& s : molecule->spheres) start_A.push_back(s.centre_A);
  return address.engine->connect(address.at, std::move(start_A), cancelled);
}

void LiveMolecule::forget() {
  drawn_ = 0;
  if (simulation_) {
    scene_.servo().loop().wantImpulses(false);
    scene_.pull().hold({});
  }
  hold_ = Hold::Push;
  selected_.clear();
  masses_u_.clear();
  asks_ = false;
  own_.release();
  forgetConnection();
  opening_.drop();
  simulation_.reset();
  molecule_.reset();
  problem_.clear();
  waiting_.clear();
  frame_ = {};
  shown_A_.clear();
  push_pN_ = 0.0;
  // A file that changed is read again at the next start.
}

std::optional<SimulationAddress> LiveMolecule::address() const {
  const LessonSession* session = lesson_.session();
  std::string_view text;
  if (session && lesson_.onStage())
    text = session->scene().simulation;
  else if (!named_for_.empty() && scene_.molecule().file == named_for_)
    text = options_.simulation;
  const auto read = simulationAddress(text);
  return read && *read ? std::optional(**read) : std::nullopt;
}

fs::path LiveMolecule::system() const {
  const LessonSession* session = lesson_.session();
  if (session && lesson_.onStage() && !session->scene().simulation.empty()) {
    const auto file = simulationFile(lesson_.file(), scene_.molecule(), session->scene().simulation);
    return file ? *file : fs::path();
  }
  std::error_code error;
  fs::path beside = systemBeside(scene_.molecule().file);
  return fs::is_regular_file(beside, error) ? beside : fs::path();
}

void LiveMolecule::sceneChanged() {
  const LessonSession* session = lesson_.session();
  const bool lesson = session && lesson_.onStage();
  if (lesson) on_ = !session->scene().simulation.empty();
  // What a lesson switched on ends with it.
  if (!lesson && by_lesson_) on_ = false;
  by_lesson_ = lesson;
  // The command line names the address for the first molecule.
  if (!lesson && !options_.simulation.empty() && named_for_.empty() && scene_.stage()) {
    named_for_ = scene_.molecule().file;
    agreed_ = options_.simulation;
    if (start()) return;
  }
  if (!on_ || !scene_.stage()) return forget();
  begin();
}

std::string LiveMolecule::unavailable() const {
  if (std::string why = AtomMover::unavailable(); !why.empty()) return why;
  if (forceChoice(scene_.touch().forces).any())
    return tr("Forces between atoms act in a molecule at rest. Switch them off to simulate it.");
  if (scene_.stage() && scene_.stage().body)
    return tr("The hand holds a part of the molecule. Only a whole molecule can be simulated.");
  return {};
}

void LiveMolecule::onStart() {
  if (on_) return;
  on_ = true;
  if (scene_.stage()) begin();
}

void LiveMolecule::end() {
  if (!on_) return;
  on_ = false;
  // The atoms return to their places.
  if (simulation_ && own_.owns()) scene_.placeAtoms(own_, scene_.atoms().resting().spheres->spheres());
  forget();
}

void LiveMolecule::begin() {
  if (const auto elsewhere = address()) return beginElsewhere(*elsewhere);
  const fs::path file = system();
  if (simulation_ && scene_.stage().molecule == molecule_ && file == file_) {
    // The scene has restarted with the atoms at rest.
    const std::uint32_t restarts = wanted_.restarts + 1;
    wanted_.pushes.clear();
    wanted_.running = true;
    wanted_.restarts = restarts;
    startAgain();
    return;
  }
  forget();
  file_ = file;
  molecule_ = scene_.stage().molecule;
  if (file.empty()) {
    const auto missing = simulationFile(lesson_.file(), scene_.molecule(),
                                        lesson_.session() ? lesson_.session()->scene().simulation : std::string());
    problem_ = missing ? std::string() : missing.problem().text();
    messages_.error(problem_);
    return;
  }
  opening_.begin(
      inBackground(openFile, file, molecule_,
                   options_.clock == ServoClock::Frames ? SimulationPace::Frames : SimulationPace::OwnClock));
  if (options_.clock == ServoClock::Frames) take(*opening_.wait());
}

// The session goes on while a scene restarts with the same molecule.
void LiveMolecule::beginElsewhere(const SimulationAddress& address) {
  if (simulation_ && scene_.stage().molecule == molecule_ && file_ == address.text()) {
    wanted_.running = true;
    frame_.starts = 0;
    return startAgain();
  }
  forget();
  file_ = address.text();
  molecule_ = scene_.stage().molecule;
  asks_ = !address.at.loopback() && agreed_ != address.text();
  if (asks_)
    return messages_.notice(trf("A simulation at {0} moves this molecule. The panel Motion (menu View) connects to it.",
                                address.at.text()));
  connect();
}

void LiveMolecule::connect() {
  const auto elsewhere = address();
  if (!elsewhere || !on_ || !scene_.stage() || simulation_ || opening_.busy()) return;
  asks_ = false;
  agreed_ = elsewhere->text();
  problem_.clear();
  cancelled_ = std::make_shared<std::atomic<bool>>(false);
  opening_.begin(
      inBackground(openAddress, *elsewhere, molecule_, std::shared_ptr<const std::atomic<bool>>(cancelled_)));
  if (options_.clock == ServoClock::Frames) take(*opening_.wait());
}

void LiveMolecule::fail(std::string why) {
  problem_ = std::move(why);
  messages_.error(problem_);
}

void LiveMolecule::take(Expected<Opened> opened) {
  if (!opened) return fail(opened.problem().text());
  masses_u_ = massesOf(*molecule_);
  wanted_ = {};
  frame_ = {};
  simulation_ = *std::move(opened);
  plots_ = {PlotBuffer(kPlotLength), PlotBuffer(kPlotLength), PlotBuffer(kPlotLength), PlotBuffer(kPlotLength)};
  scene_.servo().loop().wantImpulses(true);
  startAgain();
}

// The atoms are where the molecule's file has them.
void LiveMolecule::startAgain() {
  smooth_A_.clear();
  for (const Sphere& s : molecule_->spheres) smooth_A_.push_back(s.centre_A);
  impulses_N_s_.assign(smooth_A_.size(), Vec3(0.0));
  ticks_ = 0;
  waiting_.clear();
  wanted_.pushes.clear();
  push_pN_ = 0.0;
  scene_.servo().loop().takeImpulses();  // earlier ones
  takeSceneKeys();
}

// What the lesson's scene says about the hand and the bath; each time that the scene begins.
void LiveMolecule::takeSceneKeys() {
  const LessonSession* session = lesson_.session();
  if (!session || !lesson_.onStage()) return;
  const SceneSpec& scene = session->scene();
  wanted_.temperature_K = scene.temperature_K;
  selected_ = scene.pull == PullBy::Selection ? scene.pulled.select(*molecule_) : std::vector<std::uint32_t>();
  setHold(scene.pull == PullBy::Atom        ? Hold::Atom
          : scene.pull == PullBy::Residue   ? Hold::Residue
          : scene.pull == PullBy::Selection ? Hold::Selection
                                            : Hold::Push);
}

void LiveMolecule::run(bool running) {
  // After an unstable run the atoms stand still until it starts again.
  if (running && frame_.blow_ups > 0 && !wanted_.running) ++wanted_.restarts;
  wanted_.running = running;
}

void LiveMolecule::singleStep() {
  if (!wanted_.running) ++wanted_.singles;
}

void LiveMolecule::addImpulses() {
  const AtomImpulses& given = scene_.servo().loop().takeImpulses();
  if (given.scene != scene_.servo().scene()) return;
  ticks_ += given.ticks;
  for (const AtomImpulse& a : given.atoms())
    if (a.atom >= 0 && std::size_t(a.atom) < impulses_N_s_.size()) impulses_N_s_[std::size_t(a.atom)] += a.impulse_N_s;
}

// The mean force of the ticks since the last step becomes springs between the hand and the pushed atoms.
void LiveMolecule::pushAtoms() {
  const double kcal_mol_A = kScale_pN_per_N / kForceUnit_pN / (double(ticks_) * kTick_s);
  double whole = 0.0;  // sum of the magnitudes
  Vec3 sum(0.0);
  for (const Vec3& impulse : impulses_N_s_) {
    whole += glm::length(impulse) * kcal_mol_A;
    sum += impulse * kcal_mol_A;
  }
  const double spring = std::min(kStiffest_kcal_mol_A2, springOfHand_kcal_mol_A2());
  const double share = std::min(1.0, kStrongest_pN / std::max(glm::length(sum) * kForceUnit_pN, 1e-9));
  const SharedArray<Sphere>& at = scene_.stage().spheres->spheres();
  wanted_.pushes.clear();
  push_pN_ = share * glm::length(sum) * kForceUnit_pN;
  ticks_ = 0;
  if (!scene_.pull().atoms().empty()) {
    std::fill(impulses_N_s_.begin(), impulses_N_s_.end(), Vec3(0.0));
    return gripAtoms(spring);
  }
  for (std::size_t i = 0; i < impulses_N_s_.size(); ++i) {
    const Vec3 force = std::exchange(impulses_N_s_[i], Vec3(0.0)) * kcal_mol_A;
    if (const double size = glm::length(force); size > 0.0 && spring > 0.0)
      wanted_.pushes.push_back(pushOf(std::uint32_t(i), at[i].centre_A, share * force, spring * size / whole));
  }
}

// Each held atom is drawn to the place that it had when it was taken, moved by the hand's way since then, by a share of
// the spring as large as its share of the mass. Together they act on the centre of mass like the one spring.
void LiveMolecule::gripAtoms(double spring_kcal_mol_A2) {
  const std::vector<std::uint32_t>& held = scene_.pull().atoms();
  if (held.size() != taken_A_.size()) return;
  const Vec3 followed = heldCentre_A() - taken_at_A_;
  Vec3 ahead = scene_.log().latest().hip.A - hand_took_at_A_ - followed;
  const double most_A = kStrongest_pN / kForceUnit_pN / spring_kcal_mol_A2;
  if (const double size = glm::length(ahead); size > most_A) ahead *= most_A / size;
  for (std::size_t k = 0; k < held.size(); ++k)
    wanted_.pushes.push_back({held[k], taken_A_[k] + followed + ahead, Vec3(0.0), spring_kcal_mol_A2 * shares_[k]});
}

double LiveMolecule::springOfHand_kcal_mol_A2() const {
  const ServoSettings& servo = scene_.servo_settings;
  return servo.stiffness_N_per_mm / servo.workspace.A_per_mm * kScale_pN_per_N / kForceUnit_pN;
}

void LiveMolecule::setHold(Hold hold) {
  hold_ = hold;
  scene_.pull().hold({});
}

// A press takes hold of the first atom that it touches.
void LiveMolecule::takeOrLetGo() {
  const bool holds = !scene_.pull().atoms().empty();
  if (holds && !scene_.controls.pressing()) return scene_.pull().hold({});
  if (holds || hold_ == Hold::Push || !scene_.controls.pressing()) return;
  const Contact& contact = scene_.log().latest().contact;
  const auto touched = std::find_if(contact.atoms.begin(), contact.atoms.end(), [](auto atom) { return atom >= 0; });
  if (!contact.touching() || touched == contact.atoms.end()) return;
  std::vector<std::uint32_t> atoms{std::uint32_t(*touched)};
  const std::uint32_t residue = atoms[0] < molecule_->atoms.size() ? molecule_->atoms[atoms[0]].residue : kNoResidue;
  if (hold_ == Hold::Residue && residue != kNoResidue) {
    const Residue& r = molecule_->residues[residue];
    atoms.clear();
    for (std::uint32_t k = 0; k < r.atom_count; ++k) atoms.push_back(r.first_atom + k);
  }
  if (hold_ == Hold::Selection) {
    if (!std::binary_search(selected_.begin(), selected_.end(), atoms[0])) return;  // is pushed
    atoms = selected_;
  }
  std::vector<double> masses;
  for (const std::uint32_t atom : atoms) masses.push_back(massOf(atom));
  shares_ = PullSpring::sharesOf(masses, masses.size());
  scene_.pull().hold(std::move(atoms), std::move(masses));
  if (scene_.pull().atoms().size() != shares_.size()) return;
  taken_at_A_ = heldCentre_A();
  hand_took_at_A_ = scene_.log().latest().hip.A;
  taken_A_.clear();
  for (const std::uint32_t atom : scene_.pull().atoms()) taken_A_.push_back(smooth_A_[atom]);
}

Vec3 LiveMolecule::heldCentre_A() const {
  Vec3 out(0.0);
  const std::vector<std::uint32_t>& held = scene_.pull().atoms();
  for (std::size_t k = 0; k < std::min(held.size(), shares_.size()); ++k)
    if (held[k] < smooth_A_.size()) out += shares_[k] * smooth_A_[held[k]];
  return out;
}

double LiveMolecule::pulledBy_A() const {
  return scene_.pull().atoms().empty() ? 0.0 : glm::distance(heldCentre_A(), taken_at_A_);
}

std::string LiveMolecule::heldText() const {
  const std::vector<std::uint32_t>& held = scene_.pull().atoms();
  if (held.empty() || !molecule_) return {};
  if (hold_ == Hold::Selection) return trnf("{0} atom", "{0} atoms", held.size(), held.size());
  return hold_ == Hold::Residue ? molecule_->words(held[0]).residue : molecule_->describe(held[0]);
}

void LiveMolecule::beforeTicks() {
  if (std::optional<Expected<Opened>> opened = opening_.take()) take(*std::move(opened));
  if (!simulation_ || scene_.stage().molecule != molecule_) return;
  if (std::string why = unavailable(); !why.empty()) {
    end();
    messages_.notice(std::move(why));
    return;
  }
  if (!own_.claim()) return;
  // Also after another mover has ended in this scene.
  scene_.servo().loop().wantImpulses(true);
  takeOrLetGo();
  addImpulses();
  if (ticks_ < kFeltStep_ticks || !waiting_.empty()) {
    if (!waiting_.empty() && scene_.moveAtoms(own_, waiting_, kFeltStep_ticks)) waiting_.clear();
    return drawNewest();
  }
  const double dt_s = double(ticks_) * kTick_s;
  pushAtoms();
  simulation_->command(wanted_);
  simulation_->pass(dt_s);
  readFrame(dt_s);
  if (!simulation_) return;  // lost
  if (!waiting_.empty() && scene_.moveAtoms(own_, waiting_, kFeltStep_ticks)) waiting_.clear();
  drawNewest();
}

// The picture does not wait for the smoothing of what is felt. Atoms that jump are drawn when they have been placed.
void LiveMolecule::drawNewest() {
  const SimulationFrame& newest = simulation_->newest();
  if (newest.serial == drawn_ || newest.lost || newest.silent || newest.starts != frame_.starts ||
      newest.positions_A.size() != smooth_A_.size())
    return;
  std::vector<Sphere> at = scene_.atoms().resting().spheres->spheres().copy();
  for (std::size_t i = 0; i < std::min(at.size(), newest.positions_A.size()); ++i)
    at[i].centre_A = newest.positions_A[i];
  if (scene_.atoms().show(std::move(at))) drawn_ = newest.serial;
}

void LiveMolecule::readFrame(double dt_s) {
  const SimulationFrame& newest = simulation_->newest();
  if (newest.lost) return lose(newest.fault);
  if (newest.positions_A.size() != smooth_A_.size()) return;  // none yet
  const bool unstable = newest.blow_ups != frame_.blow_ups;
  // The hand must not feel what has stopped to follow it.
  const bool again = newest.starts != frame_.starts || newest.silent != frame_.silent;
  if (newest.wrapped && !frame_.wrapped)
    messages_.warning(
        tr("The server puts atoms that leave its box back on the other side. Each time the force on the hand restarts. "
           "Set the server to send unwrapped coordinates (LAMMPS: 'unwrap on')."));
  frame_ = newest;
  unplotted_s_ += dt_s;
  if (unplotted_s_ >= kPlotted_s) {
    unplotted_s_ = 0.0;
    plots_.temperature_K.add(float(frame_.energies.temperature_K));
    plots_.energy_kcal_mol.add(float(frame_.energies.potential_kcal_mol));
    plots_.push_pN.add(float(push_pN_));
    plots_.pulled_A.add(float(pulledBy_A()));
  }
  if (unstable) {
    wanted_.running = false;
    messages_.warning(frame_.dead
                          ? tr("The simulation became unstable and cannot start again. Switch it off and on.")
                          : tr("The simulation became unstable. It stands at its beginning again; play starts it."));
  }
  if (unstable || again) {
    // The hand begins outside of atoms that have jumped.
    smooth_A_ = frame_.positions_A;
    waiting_.clear();
    scene_.placeAtoms(own_, placed());
    return;
  }
  const double share = feltShare(dt_s);
  double most_A = 0.0;
  for (std::size_t i = 0; i < smooth_A_.size(); ++i) {
    const Vec3 step = share * (frame_.positions_A[i] - smooth_A_[i]);
    smooth_A_[i] += step;
    most_A = std::max(most_A, glm::length(step));
  }
  constexpr double kUnnoticed_A = 1e-3;  // smaller motions are neither seen nor felt
  if (most_A > kUnnoticed_A) waiting_ = placed();
}

// The force on the hand ends before anything else: the atoms return to their places, where the hand begins outside.
void LiveMolecule::lose(std::string why) {
  scene_.pull().hold({});
  scene_.placeAtoms(own_, scene_.atoms().resting().spheres->spheres());
  forget();
  // connect() begins again with this molecule.
  molecule_ = scene_.stage().molecule;
  fail(std::move(why));
}

std::vector<Sphere> LiveMolecule::placed() const {
  const SharedArray<Sphere>& resting = scene_.atoms().resting().spheres->spheres();
  std::vector<Sphere> out(resting.begin(), resting.end());
  for (std::size_t i = 0; i < std::min(out.size(), smooth_A_.size()); ++i) out[i].centre_A = smooth_A_[i];
  return out;
}

std::optional<AtomsMoved> LiveMolecule::position() const {
  if (!ready()) return std::nullopt;
  const EngineFacts engine = simulation_->engine();
  std::vector<Vec3> by;
  if (smooth_A_.size() <= kMaxRecorded)
    for (std::size_t i = 0; i < smooth_A_.size(); ++i) by.push_back(smooth_A_[i] - molecule_->spheres[i].centre_A);
  // The system's file is named with the engine: a playback needs only the displacements.
  const std::string computed_by = engine.name.empty() ? agreed_ : engineText(engine) + "; " + file_.filename().string();
  return AtomsMoved{{}, {}, textOfDisplacements(by), frame_.time_ps, computed_by};
}

// A simulation is not repeated: the recorded displacements are shown. A large molecule, of which none are recorded, stays
// at rest.
void LiveMolecule::show(const MotionSource& source, const AtomsMoved& position, const MoleculeKey&) {
  if (!scene_.stage()) return;
  const SharedArray<Sphere>& resting = scene_.atoms().resting().spheres->spheres();
  std::vector<Vec3> by = displacementsOfText(position.detail);
  if (by == shown_A_) return;
  std::vector<Sphere> out(resting.begin(), resting.end());
  for (std::size_t i = 0; i < std::min(out.size(), by.size()); ++i) out[i].centre_A += by[i];
  if (scene_.placeAtoms(source, out)) shown_A_ = std::move(by);
}

}  // namespace moltact
