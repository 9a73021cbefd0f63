#include "engine/dynamics/imd/imd_session.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"

namespace moltact {
namespace {

constexpr double kKilojoules = 4.184;  // in a kilocalorie

Vec3 centreOf(std::span<const Vec3> places_A) {
  Vec3 sum(0.0);
  for (const Vec3& v : places_A) sum += v;
  return places_A.empty() ? sum : sum / double(places_A.size());
}

Vec3 forceOf(const AtomPush& push, const Vec3& at_A) {
  if (push.direction == Vec3(0.0)) return push.stiffness_kcal_mol_A2 * (push.to_A - at_A);
  return push.force_kcal_mol_A(at_A) * push.direction;
}

// The forces on each atom become one.
void joinForces(std::vector<ImdForce>& forces) {
  std::sort(forces.begin(), forces.end(), [](const ImdForce& a, const ImdForce& b) { return a.atom < b.atom; });
  std::size_t kept = 0;
  for (std::size_t k = 1; k < forces.size(); ++k) {
    if (forces[k].atom == forces[kept].atom)
      forces[kept].force += forces[k].force;
    else
      forces[++kept] = forces[k];
  }
  if (!forces.empty()) forces.resize(kept + 1);
}

double finiteOr0(double value) { return std::isfinite(value) ? value : 0.0; }

}  // namespace

ImdSession::ImdSession(std::vector<Vec3> start_A, double now_s)
    : reader_(start_A.size()), start_A_(std::move(start_A)), began_s_(now_s), commanded_s_(now_s), heard_s_(now_s) {
  frame_.has_time = frame_.has_temperature = frame_.has_energy = false;
}

void ImdSession::received(std::span<const std::uint8_t> bytes, double now_s) {
  bool moved = false;
  while (!ended_) {
    switch (reader_.next(bytes)) {
      case ImdReader::Event::None:
        if (moved && running_) sendForces();  // while it is paused, positions on the way still arrive
        return;
      case ImdReader::Event::Greeted:
        greet(now_s);
        break;
      case ImdReader::Event::Energies:
        frame_.has_temperature = true;
        frame_.energies.temperature_K = finiteOr0(reader_.energies().temperature_K);
        // Version 2 does not say in which unit.
        frame_.has_energy = reader_.version() == 3;
        if (frame_.has_energy)
          frame_.energies.potential_kcal_mol = finiteOr0(reader_.energies().potential) / kKilojoules;
        break;
      case ImdReader::Event::Time:
        if (!has_time_) first_ps_ = before_ps_ = finiteOr0(reader_.time_ps());
        has_time_ = frame_.has_time = true;
        frame_.time_ps = finiteOr0(reader_.time_ps()) - first_ps_;
        break;
      case ImdReader::Event::Positions:
        takePositions(now_s);
        moved = true;
        break;
      case ImdReader::Event::Ended:
        end({{}, 0, 0, tr("the server has ended the session"), tr("start the simulation there again, and connect")});
        break;
      case ImdReader::Event::Fault:
        end(reader_.fault());
        break;
    }
  }
}

void ImdSession::greet(double now_s) {
  greeted_ = true;
  heard_s_ = now_s;
  frame_.wrapped = reader_.wrapped();
  addImdMessage(to_send_, ImdType::Go);
  // An earlier client may have left forces behind.
  addImdForces(to_send_, {}, reader_.littleEndian());
  addImdMessage(to_send_, ImdType::Rate, kStepsPerFrame);
}

void ImdSession::takePositions(double now_s) {
  const std::span<const Vec3> from = reader_.positions_A();
  const bool first = frame_.serial == 0;
  if (first) {
    shift_A_ = centreOf(start_A_) - centreOf(from);
    counted_since_s_ = now_s;
    frame_.positions_A.resize(from.size());
  }
  bool jumped = first || std::exchange(frame_.silent, false);
  for (std::size_t i = 0; i < from.size(); ++i) {
    const Vec3 to = from[i] + shift_A_;
    jumped |= glm::distance(to, frame_.positions_A[i]) > kJump_A;
    frame_.positions_A[i] = to;
  }
  if (jumped) ++frame_.starts;
  ++frame_.serial;
  ++counted_;
  heard_s_ = now_s;
  if (const double counted_s = now_s - counted_since_s_; counted_s >= 1.0) {
    frame_.frames_per_s = double(counted_) / counted_s;
    if (has_time_) frame_.ps_per_s = (frame_.time_ps + first_ps_ - before_ps_) / counted_s;
    before_ps_ = frame_.time_ps + first_ps_;
    counted_ = 0;
    counted_since_s_ = now_s;
  }
}

void ImdSession::sendForces() {
  forces_.clear();
  double whole = 0.0;
  for (const AtomPush& push : pushes_) {
    if (push.atom >= frame_.positions_A.size()) continue;  // such an index makes servers crash
    const Vec3 force = forceOf(push, frame_.positions_A[push.atom]);
    if (!finite(force) || force == Vec3(0.0)) continue;
    whole += glm::length(force);
    forces_.push_back({push.atom, force});
  }
  if (forces_.empty()) return endForces();
  joinForces(forces_);
  const double unit = reader_.version() == 3 ? kKilojoules : 1.0;
  const double share = unit * std::min(1.0, kStrongest_kcal_mol_A / whole);
  for (ImdForce& f : forces_) f.force *= share;
  addImdForces(to_send_, forces_, reader_.littleEndian());
  forces_on_ = true;
}

void ImdSession::endForces() {
  if (std::exchange(forces_on_, false)) addImdForces(to_send_, {}, reader_.littleEndian());
}

void ImdSession::command(const SimulationCommand& wanted, double now_s) {
  commanded_s_ = now_s;
  if (ended_ || frame_.serial == 0) return;
  pushes_ = wanted.pushes;
  if (wanted.running != running_) {
    if (!wanted.running) endForces();
    pause(!wanted.running);
    heard_s_ = now_s;
  }
  if (pushes_.empty() || !running_) endForces();
}

void ImdSession::pause(bool on) {
  running_ = !on;
  addImdMessage(to_send_, reader_.version() == 3 && !on ? ImdType::Resume : ImdType::Pause);
}

void ImdSession::passed(double now_s) {
  if (ended_) return;
  if (now_s - commanded_s_ > kCommands_s) {
    pushes_.clear();
    endForces();
  }
  if (frame_.serial == 0) {
    if (now_s - began_s_ > kFirst_s)
      end({{},
           0,
           0,
           greeted_ ? tr("the server sends no positions") : tr("what listens there does not answer as IMD servers do"),
           tr("see whether the simulation runs, and whether another program is connected to it")});
    return;
  }
  const double silent_s = running_ ? now_s - heard_s_ : 0.0;
  if (silent_s > kGone_s) {
    end({{},
         0,
         0,
         trf("the server has sent nothing for {0} s", numberText(kGone_s, decimals(0))),
         tr("see whether the simulation still runs, and connect again")});
  } else if (silent_s > kSilence_s && !frame_.silent) {
    pushes_.clear();
    endForces();
    frame_.silent = true;
    ++frame_.serial;
  }
}

void ImdSession::lost() {
  if (ended_) return;
  end({{}, 0, 0, tr("the connection to the server is lost"), tr("start the simulation there again, and connect")});
  to_send_.clear();
}

void ImdSession::end(Problem why) {
  problem_ = std::move(why);
  frame_.dead = frame_.lost = true;
  frame_.fault = problem_->text();
  ++frame_.serial;
  leave();
}

void ImdSession::leave() {
  if (std::exchange(ended_, true) || !greeted_) return;
  pushes_.clear();
  forces_on_ = false;
  addImdForces(to_send_, {}, reader_.littleEndian());
  if (!running_) pause(false);
  addImdMessage(to_send_, ImdType::Disconnect);
}

std::vector<std::uint8_t> ImdSession::lastWords() const {
  std::vector<std::uint8_t> out;
  if (!greeted_ || ended_) return out;
  addImdForces(out, {}, reader_.littleEndian());
  addImdMessage(out, ImdType::Disconnect);
  return out;
}

}  // namespace moltact
