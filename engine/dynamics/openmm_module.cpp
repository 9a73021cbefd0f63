// OpenMM behind the interface MdEngine, as a module that the program loads when a scene asks for a simulation
// (openmm_engine.h). Everything that knows OpenMM is here. Units here: nanometre, kilojoule per mole, picosecond.
#include <OpenMM.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>
#include <set>
#include <sstream>
#include <stdexcept>
#include <thread>

#include "engine/dynamics/md_engine.h"

namespace moltact {
namespace {

constexpr double kA_per_nm = 10.0, kKJ_per_kcal = 4.184;
constexpr double kKJ_nm2_per_kcal_A2 = kKJ_per_kcal * kA_per_nm * kA_per_nm;
constexpr double kGas_kJ_mol_K = 0.00831446261815324;
// Forces of pushes and of the hold are not part of the molecule's energy.
constexpr int kHandGroup = 31;

OpenMM::Vec3 nm(const Vec3& v) { return {v.x / kA_per_nm, v.y / kA_per_nm, v.z / kA_per_nm}; }

void loadPlugins() {
  static const bool loaded = [] {
    OpenMM::Platform::loadPluginsFromDirectory(OpenMM::Platform::getDefaultPluginsDirectory());
    return true;
  }();
  (void)loaded;
}

// The order of trial. Threads are left to the haptic loop and the window.
std::map<std::string, std::string> propertiesOf(const std::string& platform) {
  if (platform != "CPU") return {};
  const unsigned all = std::max(1u, std::thread::hardware_concurrency());
  return {{"Threads", std::to_string(std::clamp(all / 2, 1u, 8u))}};
}

// OpenMM casts what it reads to the wanted class without a check.
bool isSystem(const std::string& xml) {
  std::size_t at = xml.find('<');
  while (at != std::string::npos && (xml.compare(at, 2, "<?") == 0 || xml.compare(at, 2, "<!") == 0))
    at = xml.find('<', at + 1);
  if (at == std::string::npos) return false;
  const std::string root = xml.substr(at, xml.find('>', at) - at);
  return root.starts_with("<System ") && root.find("type=\"System\"") != std::string::npos;
}

class OpenMMEngine final : public MdEngine {
 public:
  explicit OpenMMEngine(const MdStart& start) : start_(start) {
    if (!isSystem(start.system)) throw std::runtime_error("the file is no serialized System");
    loadPlugins();
    std::istringstream text(start.system);
    system_.reset(OpenMM::XmlSerializer::deserialize<OpenMM::System>(text));
    const int count = system_->getNumParticles();
    if (std::size_t(count) != start.positions_A.size())
      throw std::runtime_error("the system has " + std::to_string(count) + " particles, not " +
                               std::to_string(start.positions_A.size()));
    for (int i = 0; i < count; ++i) masses_u_.push_back(system_->getParticleMass(i));
    addHand();
    chooseStep();
    freedom_ = 0;
    for (const double m : masses_u_) freedom_ += m > 0.0 ? 3 : 0;
    freedom_ -= system_->getNumConstraints();
    for (int k = 0; k < system_->getNumForces(); ++k)
      if (dynamic_cast<const OpenMM::CMMotionRemover*>(&system_->getForce(k))) freedom_ -= 3;
    freedom_ = std::max(freedom_, 1);
    choosePlatform();
  }

  std::size_t atomCount() const override { return masses_u_.size(); }
  std::span<const double> masses_u() const override { return masses_u_; }
  double step_ps() const override { return step_ps_; }
  std::string_view platform() const override { return platform_; }
  std::string name() const override { return "OpenMM " + OpenMM::Platform::getOpenMMVersion(); }
  double measured_steps_per_s() const override { return steps_per_s_; }
  std::span<const PlatformRate> measured() const override { return measured_; }

  std::string push(std::span<const AtomPush> pushes) override {
    return guarded([&] {
      for (const std::uint32_t atom : pushed_) push_->setParticleParameters(int(atom), int(atom), kNoPush);
      const bool any = !pushes.empty() || !pushed_.empty();
      pushed_.clear();
      for (const AtomPush& p : pushes) {
        if (p.atom >= masses_u_.size()) continue;
        const OpenMM::Vec3 to = nm(p.to_A);
        const bool grip = p.direction == Vec3(0.0);
        const double k = p.stiffness_kcal_mol_A2 * kKJ_nm2_per_kcal_A2;
        push_->setParticleParameters(
            int(p.atom), int(p.atom),
            {to[0], to[1], to[2], p.direction.x, p.direction.y, p.direction.z, grip ? 0.0 : k, grip ? k : 0.0});
        pushed_.push_back(p.atom);
      }
      if (any) push_->updateParametersInContext(*context_);
    });
  }

  std::string setTemperature(double kelvin) override {
    return guarded([&] {
      start_.temperature_K = kelvin;
      if (auto* bath = dynamic_cast<OpenMM::LangevinMiddleIntegrator*>(integrator_.get())) bath->setTemperature(kelvin);
    });
  }

  std::string advance(int steps) override {
    return guarded([&] { integrator_->step(steps); });
  }

  std::string relax(int iterations) override {
    return guarded([&] {
      OpenMM::LocalEnergyMinimizer::minimize(*context_, 1.0, iterations);
      context_->setVelocitiesToTemperature(start_.temperature_K, nextSeed());
    });
  }

  std::string restart() override {
    return guarded([&] { begin(); });
  }

  std::span<const Vec3> positions_A() override {
    positions_A_.assign(masses_u_.size(), Vec3(std::nan("")));
    guarded([&] {  // OpenMM refuses to return a state that is not a number
      const OpenMM::State state = context_->getState(OpenMM::State::Positions);
      const std::vector<OpenMM::Vec3>& at = state.getPositions();
      for (std::size_t i = 0; i < at.size(); ++i) positions_A_[i] = kA_per_nm * Vec3(at[i][0], at[i][1], at[i][2]);
    });
    return positions_A_;
  }

  MdEnergies energies() override {
    MdEnergies out{std::nan(""), std::nan(""), std::nan("")};
    guarded([&] {
      const OpenMM::State state = context_->getState(OpenMM::State::Energy, false, int(~(1u << kHandGroup)));
      out.potential_kcal_mol = state.getPotentialEnergy() / kKJ_per_kcal;
      out.kinetic_kcal_mol = state.getKineticEnergy() / kKJ_per_kcal;
      out.temperature_K = 2.0 * state.getKineticEnergy() / (freedom_ * kGas_kJ_mol_K);
    });
    return out;
  }

 private:
  inline static const std::vector<double> kNoPush{0, 0, 0, 0, 0, 0, 0, 0};

  template <class Work>
  static std::string guarded(Work&& work) {
    try {
      work();
      return {};
    } catch (const std::exception& e) {
      return *e.what() ? e.what() : "unknown error";
    }
  }

  // The springs of the hand and the one on the centre of mass.
  void addHand() {
    auto push = std::make_unique<OpenMM::CustomExternalForce>(
        "0.5*k*max(0, nx*(ax-x)+ny*(ay-y)+nz*(az-z))^2 + 0.5*grip*((ax-x)^2+(ay-y)^2+(az-z)^2)");
    for (const char* name : {"ax", "ay", "az", "nx", "ny", "nz", "k", "grip"}) push->addPerParticleParameter(name);
    for (std::size_t i = 0; i < masses_u_.size(); ++i) push->addParticle(int(i), kNoPush);
    push->setForceGroup(kHandGroup);
    push_ = push.get();
    system_->addForce(push.release());
    if (start_.hold_kcal_mol_A2 <= 0.0) return;
    Vec3 centre(0.0);
    double mass = 0.0;
    std::vector<int> all;
    for (std::size_t i = 0; i < masses_u_.size(); ++i) {
      centre += masses_u_[i] * start_.positions_A[i];
      mass += masses_u_[i];
      all.push_back(int(i));
    }
    if (mass <= 0.0) return;
    const OpenMM::Vec3 at = nm(centre / mass);
    auto hold = std::make_unique<OpenMM::CustomCentroidBondForce>(1, "0.5*hold_k*((x1-hx)^2+(y1-hy)^2+(z1-hz)^2)");
    for (const char* name : {"hx", "hy", "hz", "hold_k"}) hold->addPerBondParameter(name);
    hold->addGroup(all);
    hold->addBond({0}, {at[0], at[1], at[2], start_.hold_kcal_mol_A2 * kKJ_nm2_per_kcal_A2});
    hold->setForceGroup(kHandGroup);
    system_->addForce(hold.release());
  }

  void chooseStep() {
    std::set<int> rigid;
    for (int k = 0; k < system_->getNumConstraints(); ++k) {
      int a = 0, b = 0;
      double length = 0.0;
      system_->getConstraintParameters(k, a, b, length);
      rigid.insert({a, b});
    }
    double lightest = 1e9;
    bool all_rigid = true;
    for (std::size_t i = 0; i < masses_u_.size(); ++i) {
      if (masses_u_[i] <= 0.0) continue;
      lightest = std::min(lightest, masses_u_[i]);
      // A carbon that gave mass to its hydrogens may be as light as they are.
      if (masses_u_[i] < 2.0 && !rigid.contains(int(i))) all_rigid = false;
    }
    if (rigid.empty() && lightest < 5.0) all_rigid = false;
    step_ps_ = start_.step_ps > 0.0 ? start_.step_ps : stepFor_ps(lightest, all_rigid);
  }

  void open(const std::string& platform) {
    context_.reset();
    if (start_.friction_per_ps > 0.0) {
      auto bath =
          std::make_unique<OpenMM::LangevinMiddleIntegrator>(start_.temperature_K, start_.friction_per_ps, step_ps_);
      bath->setRandomNumberSeed(int(start_.seed & 0x3fffffff) + 1);
      integrator_ = std::move(bath);
    } else {
      integrator_ = std::make_unique<OpenMM::VerletIntegrator>(step_ps_);
    }
    // Without a bath the energy is conserved only as well as the constraints are kept; iterating further costs time.
    integrator_->setConstraintTolerance(start_.friction_per_ps > 0.0 ? 1e-6 : 1e-9);
    context_ = std::make_unique<OpenMM::Context>(*system_, *integrator_, OpenMM::Platform::getPlatformByName(platform),
                                                 propertiesOf(platform));
    platform_ = platform;
    draws_ = 0;
    begin();
  }

  // Tries every platform for a moment, and keeps the fastest.
  void choosePlatform() {
    if (!start_.platform.empty()) return open(start_.platform);
    using Clock = std::chrono::steady_clock;
    std::string why;
    for (int k = 0; k < OpenMM::Platform::getNumPlatforms(); ++k) {
      const std::string name = OpenMM::Platform::getPlatform(k).getName();
      try {
        open(name);
        integrator_->step(5);
        const auto from = Clock::now();
        double took_s = 0.0;
        int steps = 0;
        for (; took_s < 0.1 && steps < 2000; steps += 10) {
          integrator_->step(10);
          context_->getState(OpenMM::State::Positions);
          took_s = std::chrono::duration<double>(Clock::now() - from).count();
        }
        measured_.push_back({name, steps / std::max(took_s, 1e-6)});
      } catch (const std::exception& e) {
        why = e.what();  // a graphics card that is not there
      }
    }
    if (measured_.empty()) throw std::runtime_error(why.empty() ? "no platform" : why);
    const auto fastest = std::max_element(measured_.begin(), measured_.end(),
                                          [](const auto& a, const auto& b) { return a.steps_per_s < b.steps_per_s; });
    open(fastest->platform);
    steps_per_s_ = fastest->steps_per_s;
  }

  void begin() {
    std::vector<OpenMM::Vec3> at;
    for (const Vec3& v : start_.positions_A) at.push_back(nm(v));
    context_->setTime(0.0);
    context_->setPositions(at);
    context_->applyConstraints(1e-6);
    context_->setVelocitiesToTemperature(start_.temperature_K, nextSeed());
  }

  int nextSeed() { return int((start_.seed + 7919u * ++draws_) & 0x3fffffff) + 1; }

  MdStart start_;
  std::unique_ptr<OpenMM::System> system_;
  std::unique_ptr<OpenMM::Integrator> integrator_;
  std::unique_ptr<OpenMM::Context> context_;  // uses both
  OpenMM::CustomExternalForce* push_ = nullptr;
  std::vector<std::uint32_t> pushed_;
  std::vector<double> masses_u_;
  std::vector<Vec3> positions_A_;
  std::string platform_;
  std::vector<PlatformRate> measured_;
  double step_ps_ = 0.0, steps_per_s_ = 0.0;
  int freedom_ = 1;
  std::uint32_t draws_ = 0;
};

}  // namespace
}  // namespace moltact

extern "C" __attribute__((visibility("default"))) moltact::MdEngine* moltactMakeMdEngine(const moltact::MdStart& start,
                                                                                         std::string& why) {
  try {
    return new moltact::OpenMMEngine(start);
  } catch (const std::exception& e) {
    why = *e.what() ? e.what() : "unknown error";
    return nullptr;
  }
}
