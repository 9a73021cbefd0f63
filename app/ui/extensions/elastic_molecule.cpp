#include "app/ui/extensions/elastic_molecule.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <utility>

#include "app/ui/application/application_options.h"
#include "app/ui/extensions/displacement_text.h"
#include "app/ui/lesson/lesson_guide.h"
#include "app/ui/widgets/messages.h"
#include "engine/dynamics/network_solution.h"
#include "engine/haptics/body/held_body.h"
#include "engine/haptics/field/force_choices.h"
#include "engine/haptics/field/pair_model.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

constexpr double kUnnoticed_A = 1e-3;  // smaller displacements are neither seen nor felt
// A molecule without a push returns in this time.
constexpr double kMinRelaxation_s = 0.15;

std::vector<std::uint32_t> bodyAtoms(const TouchableModel& stage) {
  return stage.body ? stage.body->atoms : std::vector<std::uint32_t>();
}

Expected<ElasticModel> modelOf(const std::shared_ptr<const Molecule>& molecule, const std::vector<std::uint32_t>& held,
                               const std::filesystem::path& cache, const std::shared_ptr<ElasticProgress>& progress) {
  try {
    auto network = ElasticNetwork::make(*molecule, ElasticNetwork::kCutOff_A, held);
    if (!network) return network.problem();
    ElasticModel out;
    out.network = std::make_shared<const ElasticNetwork>(*std::move(network));
    auto solution = keptOrSolved(*out.network, ElasticMolecule::kModes, cache, [&](double share) {
      progress->share = share;
      return !progress->unwanted;
    });
    if (!solution) return solution.problem();
    out.modes = std::make_shared<const NormalModes>(std::move(solution->modes));
    const std::vector<glm::dmat3>& compliances = solution->compliances;
    out.spring_kcal_mol_A2 = springFromDisplacementFactors(*out.network, *molecule, compliances);
    out.spring_assumed = !(out.spring_kcal_mol_A2 > 0.0);
    if (out.spring_assumed) out.spring_kcal_mol_A2 = ElasticMolecule::kUsualSpring_kcal_mol_A2;
    for (const glm::dmat3& c : compliances)
      out.compliances_A2_mol_kcal.push_back(greatestCompliance(c) / out.spring_kcal_mol_A2);
    return out;
  } catch (const std::exception& e) {
    return Problem{{}, 0, 0, trf("The elastic network cannot be computed: {0}", e.what()), {}};
  }
}

}  // namespace

void ElasticMolecule::forget() {
  if (motion_) scene_.servo().loop().wantImpulses(false);
  own_.release();
  if (progress_) progress_->unwanted = true;
  reading_.drop();
  model_.reset();
  molecule_.reset();
  motion_.reset();
  problem_.clear();
  waiting_.clear();
  resetModes();
  resting_ = true;
}

void ElasticMolecule::resetModes() {
  mode_ = 0;
  shown_ = false;
  felt_.clear();
  if (const LessonSession* session = lesson_.session(); session && lesson_.onStage())
    felt_ = session->scene().elastic_modes;
}

void ElasticMolecule::sceneChanged() {
  const LessonSession* session = lesson_.session();
  const bool lesson = session && lesson_.onStage();
  if (lesson) on_ = session->scene().elastic;
  // What a lesson switched on ends with it.
  if (!lesson && by_lesson_) on_ = false;
  by_lesson_ = lesson;
  if (!on_ || !scene_.stage()) return forget();
  begin();
}

std::string ElasticMolecule::unavailable() const {
  if (std::string why = AtomMover::unavailable(); !why.empty()) return why;
  if (forceChoice(scene_.touch().forces).any())
    return tr("Forces between atoms act in a molecule at rest. Switch them off to make it elastic.");
  return {};
}

void ElasticMolecule::onStart() {
  if (on_) return;
  on_ = true;
  if (scene_.stage()) begin();
}

void ElasticMolecule::end() {
  if (!on_) return;
  on_ = false;
  // The atoms return to their places.
  if (motion_ && own_.owns()) scene_.placeAtoms(own_, scene_.atoms().resting().spheres->spheres());
  forget();
}

void ElasticMolecule::begin() {
  const TouchableModel& stage = scene_.stage();
  motion_.reset();
  waiting_.clear();
  resetModes();
  resting_ = true;
  if (stage.molecule == molecule_) {
    // The scene has restarted with the atoms at rest.
    if (model_) take(*model_);
    return;
  }
  forget();
  molecule_ = stage.molecule;
  progress_ = std::make_shared<ElasticProgress>();
  reading_.begin(inBackground(modelOf, molecule_, bodyAtoms(stage), options_.cache_folder, progress_));
  if (options_.clock == ServoClock::Frames) take(*reading_.wait());
}

void ElasticMolecule::take(Expected<ElasticModel> made) {
  if (!made) {
    problem_ = made.problem().text();
    messages_.error(problem_);
    return;
  }
  if (!model_) model_ = std::make_shared<const ElasticModel>(*std::move(made));
  motion_.emplace(model_->network, model_->modes, model_->spring_kcal_mol_A2, kStep_s);
  const bool chosen = !felt_.empty();
  while (!felt_.empty() && felt_.back() >= model_->modes->count()) felt_.pop_back();
  if (chosen && felt_.empty())
    messages_.warning(
        trf("The molecule has {0} motions, and none of those that the scene names. It gives way in every way.",
            model_->modes->count()));
  restrict();
  impulses_N_s_.assign(model_->network->nodes().size(), Vec3(0.0));
  ticks_ = 0;
  scene_.servo().loop().wantImpulses(true);
  scene_.servo().loop().takeImpulses();  // earlier ones
}

void ElasticMolecule::addImpulses() {
  const AtomImpulses& given = scene_.servo().loop().takeImpulses();
  if (given.scene != scene_.servo().scene()) return;
  ticks_ += given.ticks;
  for (const AtomImpulse& a : given.atoms())
    if (a.atom >= 0 && std::size_t(a.atom) < model_->network->atomCount())
      if (const std::uint32_t node = model_->network->nodeOf(std::size_t(a.atom)); node != ElasticNetwork::kNoNode)
        impulses_N_s_[node] += a.impulse_N_s;
}

void ElasticMolecule::beforeTicks() {
  if (std::optional<Expected<ElasticModel>> made = reading_.take()) take(*std::move(made));
  if (!motion_ || scene_.stage().molecule != molecule_) return;
  if (std::string why = unavailable(); !why.empty()) {
    end();
    messages_.notice(std::move(why));
    return;
  }
  if (!own_.claim()) return;
  // Also after another mover has ended in this scene.
  scene_.servo().loop().wantImpulses(true);
  addImpulses();
  if (waiting_.empty()) step();
  if (!waiting_.empty() && scene_.moveAtoms(own_, waiting_, kStep_ticks)) waiting_.clear();
}

// One step under the mean force of the ticks since the last one.
void ElasticMolecule::step() {
  if (ticks_ == 0) return;
  std::vector<NodeForce> forces;
  double compliance = 0.0;  // of the softest pushed node
  const double kcal_mol_A = kScale_pN_per_N / kForceUnit_pN / (double(ticks_) * kTick_s);
  for (std::size_t n = 0; n < impulses_N_s_.size(); ++n)
    if (impulses_N_s_[n] != Vec3(0.0)) {
      forces.push_back({std::uint32_t(n), impulses_N_s_[n] * kcal_mol_A});
      impulses_N_s_[n] = Vec3(0.0);
      compliance = std::max(compliance, model_->compliances_A2_mol_kcal[n]);
    }
  ticks_ = 0;
  if (resting_ && forces.empty() && !shown_) return;
  const ServoSettings& servo = scene_.servo_settings;
  const double hand_kcal_mol_A2 = servo.stiffness_N_per_mm / servo.workspace.A_per_mm * kScale_pN_per_N / kForceUnit_pN;
  motion_->setRelaxation(std::max(kMinRelaxation_s, relaxationFor(hand_kcal_mol_A2, compliance, kStep_s)));
  if (shown_) {
    const auto mode = model_->modes->mode(mode_);
    double most = 0.0;
    for (const Vec3& v : mode) most = std::max(most, glm::length(v));
    std::vector<double> amplitudes(mode_ + 1, 0.0);
    shown_for_s_ += kStep_s;
    amplitudes[mode_] = kShown_A / most * std::sin(kTwoPi * shown_for_s_ / kShown_s);
    motion_->setRest(amplitudes);
    motion_->setRelaxation(0.0);  // the movement itself is slow
  } else {
    motion_->setRest({});
  }
  motion_->step(forces);
  resting_ = forces.empty() && !shown_ && motion_->maxDisplacement_A() < kUnnoticed_A;
  waiting_ = displaced();
}

std::vector<Sphere> ElasticMolecule::displaced() const {
  const SharedArray<Sphere>& resting = scene_.atoms().resting().spheres->spheres();
  std::vector<Sphere> out(resting.begin(), resting.end());
  const std::span<const Vec3> by = motion_->displacements_A();
  for (std::size_t i = 0; i < std::min(out.size(), model_->network->atomCount()); ++i)
    if (const std::uint32_t node = model_->network->nodeOf(i); node != ElasticNetwork::kNoNode)
      out[i].centre_A += by[node];
  return out;
}

void ElasticMolecule::chooseMode(std::size_t mode) {
  if (!model_ || mode >= model_->modes->count()) return;
  mode_ = mode;
  showMode(shown_);
}

void ElasticMolecule::showMode(bool on) {
  shown_ = on;
  shown_for_s_ = 0.0;
}

void ElasticMolecule::restrict() {
  if (!motion_) return;
  if (felt_.empty())
    motion_->useAll();
  else
    motion_->restrictTo(felt_);
}

void ElasticMolecule::feelMode(std::size_t mode, bool on) {
  if (!model_ || mode >= model_->modes->count() || on == feels(mode)) return;
  const auto at = std::lower_bound(felt_.begin(), felt_.end(), mode);
  if (on)
    felt_.insert(at, mode);
  else
    felt_.erase(at);
  restrict();
}

std::optional<AtomsMoved> ElasticMolecule::position() const {
  if (!motion_) return std::nullopt;
  return AtomsMoved{{},
                    {},
                    resting_ ? std::string() : textOfDisplacements(motion_->displacements_A()),
                    motion_->maxDisplacement_A(),
                    "elastic network"};
}

// The recorded displacements suffice: the network only says which atoms follow which node.
void ElasticMolecule::show(const MotionSource& source, const AtomsMoved& position, const MoleculeKey&) {
  const TouchableModel& stage = scene_.stage();
  if (!stage) return;
  if (stage.molecule != molecule_ || !model_) {
    forget();
    molecule_ = stage.molecule;
    Expected<ElasticModel> made =
        modelOf(molecule_, bodyAtoms(stage), options_.cache_folder, std::make_shared<ElasticProgress>());
    if (!made) return;
    model_ = std::make_shared<const ElasticModel>(*std::move(made));
    motion_.emplace(model_->network, model_->modes, model_->spring_kcal_mol_A2, kStep_s);
  }
  std::vector<Vec3> at = displacementsOfText(position.detail);
  at.resize(model_->network->nodes().size(), Vec3(0.0));
  if (textOfDisplacements(at) == textOfDisplacements(motion_->displacements_A())) return;
  motion_->place(at);
  scene_.placeAtoms(source, displaced());
}

}  // namespace moltact
