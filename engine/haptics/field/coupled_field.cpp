#include "engine/haptics/field/coupled_field.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace moltact {
namespace {

// A rise of the energy beyond this is more than the rounding of the sums in float (unit: kcal/mol).
constexpr double kNoise_kcal_mol = 2e-3, kRelativeNoise = 1e-5;
constexpr double kMaxCaution = 256.0;

}  // namespace

CoupledField::CoupledField(std::unique_ptr<Interaction> inner, std::shared_ptr<const PairField> field,
                           const VirtualCoupling& coupling)
    : WrappedInteraction(std::move(inner)),
      field_(std::move(field)),
      sum_(field_->places, field_->atoms, field_->held, field_->model),
      coupling_(coupling),
      forces_(field_->atoms.size()),
      near_(field_->atoms.size()) {}

void CoupledField::reset() noexcept {
  placed_ = false;
  inner().reset();
}

MemoryUsage CoupledField::memoryUsage() const noexcept {
  MemoryUsage out = inner().memoryUsage();
  out.bytes += sum_.bytes() + field_->places->bytes();
  return out;
}

double CoupledField::couplingEnergy_kcal_mol(const PoseA& body) const noexcept {
  const Vec3 away = body.place.A - hand_.place.A;
  const Vec3 turned = coupling_.lever_A * rotationBetween(body.orientation, hand_.orientation);
  return 0.5 * coupling_.stiffness_kcal_mol_A2 * (glm::dot(away, away) + glm::dot(turned, turned));
}

Response CoupledField::respond(const PoseA& pose) noexcept {
  if (!finite(pose.place.A) || glm::length(pose.place.A) > kMaxPosition_A || !rotates(pose.orientation))
    return inner().respond(pose);  // Fault::NotFinite
  return placed_ ? step(pose) : begin(pose);
}

// Without an earlier pose the body is where the inner interaction lets it be for this hand.
Response CoupledField::begin(const PoseA& hand) noexcept {
  inner_answer_ = inner().respond(hand);
  if (inner_answer_.contact.fault != Fault::None) return inner_answer_;
  placed_ = true;
  caution_ = 1.0;
  moved_A_ = 0.0;
  limited_ = false;
  turning_.begin(hand);
  goal_ = hand_ = hand;
  body_ = inner_answer_.shownBody(hand);
  at_ = sum_.at(body_);
  return felt(hand, inner_answer_);
}

// The minimum of the coupling and of the bound of the field at the body's pose, at most kStep_A away.
PoseA CoupledField::goal() const noexcept {
  const double k = coupling_.stiffness_kcal_mol_A2, lever = coupling_.lever_A;
  const Vec3 pull = k * (hand_.place.A - body_.place.A) + at_.force_kcal_mol_A;
  double bound = at_.stiffness_kcal_mol_A2;
  Vec3 twist(0.0);
  if (lever > 0.0) {
    twist = k * lever * rotationBetween(body_.orientation, hand_.orientation) + at_.torque_kcal_mol / lever;
    // A positive form of six variables has no eigenvalue above the sum of those of its two blocks.
    bound += at_.rotational_stiffness_kcal_mol / (lever * lever);
  }
  const bool in_field = at_.force_kcal_mol_A != Vec3(0.0) || at_.torque_kcal_mol != Vec3(0.0) || bound > 0.0;
  const double share = 1.0 / (k + caution_ * bound);
  Vec3 step = share * pull, turn = lever > 0.0 ? share / lever * twist : Vec3(0.0);
  const double way = glm::length(step) + glm::length(turn) * coupling_.reach_A;
  const double most = sum_.listedPairs() > 0 ? kStep_A : kFreeStep_A;
  if (way > most) {
    step *= most / way;
    turn *= most / way;
  } else if (!in_field) {
    return hand_;
  }
  const double angle = glm::length(turn);
  return {{body_.place.A + step},
          angle > 0.0 ? glm::normalize(glm::angleAxis(angle, turn / angle) * body_.orientation) : body_.orientation};
}

Response CoupledField::step(const PoseA& hand) noexcept {
  const bool free = !inner_answer_.contact.touching() && sum_.listedPairs() == 0;
  hand_ = {hand.place, coupling_.lever_A > 0.0 ? turning_.orientation(hand, body_.orientation, free, coupling_.lever_A)
                                               : hand.orientation};
  const PoseA from = body_;
  const double before = couplingEnergy_kcal_mol(body_) + at_.energy.felt_kcal_mol;
  const PairEnergy was = at_;
  goal_ = goal();
  // A point takes the hand's orientation, which no energy depends on.
  if (coupling_.lever_A <= 0.0) goal_.orientation = hand_.orientation;
  inner_answer_ = inner().respond(goal_);
  if (inner_answer_.contact.fault != Fault::None) {
    placed_ = false;
    return inner_answer_;
  }
  body_ = inner_answer_.shownBody(goal_);
  at_ = sum_.at(body_);
  const double after = couplingEnergy_kcal_mol(body_) + at_.energy.felt_kcal_mol;
  if (after > before + kNoise_kcal_mol + kRelativeNoise * std::abs(before)) {
    ++rejected_;
    caution_ = std::min(kMaxCaution, 4.0 * caution_);
    goal_ = from;
    inner_answer_ = inner().respond(goal_);
    body_ = inner_answer_.shownBody(goal_);
    const bool back = body_.place == from.place && body_.orientation == from.orientation;
    at_ = back ? was : sum_.at(body_);
  } else {
    caution_ = std::max(1.0, 0.8 * caution_);
  }
  moved_A_ = glm::distance(body_.place.A, from.place.A) +
             coupling_.reach_A * glm::length(rotationBetween(from.orientation, body_.orientation));
  return felt(hand, inner_answer_);
}

// Force and torque of the coupling, and what the inner interaction exerts besides leading the body: a penalty, a shaded
// normal, several springs.
Response CoupledField::felt(const PoseA& hand, const Response& inner_answer) noexcept {
  Response out = inner_answer;
  const Vec3 led = body_.place.A - goal_.place.A, away = body_.place.A - hand.place.A;
  const double lever2 = coupling_.lever_A * coupling_.lever_A;
  const Vec3 theta = lever2 > 0.0 ? rotationBetween(body_.orientation, hand_.orientation) : Vec3(0.0);
  out.contact.scp = body_.place;
  out.contact.displacement_A = away + (inner_answer.contact.displacement_A - led);
  out.contact.energy_A2 = 0.5 * (glm::dot(away, away) + lever2 * glm::dot(theta, theta));
  if (inner_answer.body_pose) {
    out.torque_A2 = -lever2 * theta;
    out.rotational_A2 = lever2;
  } else {
    out.contact.energy_A2 += inner_answer.contact.energy_A2 - 0.5 * glm::dot(led, led);
    out.torque_A2 -= lever2 * theta;
    out.rotational_A2 += lever2;
  }
  out.at_rest = inner_answer.at_rest && moved_A_ < kRest_A;
  if (hasOrientation()) out.body_pose = body_;
  out.molecular_energy = at_.energy;
  out.molecular_energy->coupling_kcal_mol_A2 = coupling_.stiffness_kcal_mol_A2;
  return out;
}

std::size_t CoupledField::reactions(const Response& last, double spring_N_per_A, double field_share,
                                    std::span<AtomForce> out) const noexcept {
  if (!placed_ || !last.acts()) return 0;
  // The inner springs are as stiff as coupling and bound of the field together: their stretch is the contact's force.
  const double k = coupling_.stiffness_kcal_mol_A2, N_per_kcal_mol_A = spring_N_per_A / k;
  std::size_t count = 0;
  Vec3 rest = -last.total(spring_N_per_A, field_share).force_N;
  const std::size_t near = sum_.sceneForces(forces_, near_);
  double sizes = 0.0;
  for (std::size_t j = 0; j < near; ++j) {
    const Vec3 force_N = N_per_kcal_mol_A * forces_[near_[j]];
    if (force_N == Vec3(0.0)) continue;
    out[count++] = {std::int32_t(field_->carriers[near_[j]]), force_N, -1};
    rest -= force_N;
    sizes += glm::length(force_N);
  }
  if (!last.contact.touching()) {
    for (std::size_t j = 0; j < count; ++j) out[j].force_N += rest * (glm::length(out[j].force_N) / sizes);
    return count;
  }
  // What the field does not carry, the contact does.
  const std::size_t fields = count;
  count += inner().reactions(inner_answer_, spring_N_per_A, field_share, out.subspan(count));
  Vec3 contact(0.0);
  double pressed = 0.0;
  for (std::size_t j = fields; j < count; ++j) contact += out[j].force_N, pressed += glm::length(out[j].force_N);
  if (pressed <= 0.0) {
    for (std::size_t j = 0; j < fields; ++j) out[j].force_N += rest * (glm::length(out[j].force_N) / sizes);
    return fields;
  }
  const double scale = std::max(0.0, glm::dot(rest, contact) / std::max(1e-30, glm::dot(contact, contact)));
  rest -= scale * contact;
  for (std::size_t j = fields; j < count; ++j) {
    const double share = glm::length(out[j].force_N) / pressed;
    out[j].force_N = scale * out[j].force_N + share * rest;
  }
  return count;
}

}  // namespace moltact
