#include "app/commands/replay_body.h"

#include <array>
#include <cmath>
#include <string_view>

#include "app/commands/command.h"
#include "app/commands/csv_numbers.h"
#include "app/commands/number_rows.h"
#include "engine/language/catalogue.h"
#include "engine/language/quantity_text.h"
#include "engine/platform/terminal.h"
#include "engine/platform/write_file.h"

namespace moltact {
namespace {

constexpr std::array<std::string_view, 1> kSphereHeader{"x,y,z,r"};

constexpr std::string_view kColumns =
    "hand_x,hand_y,hand_z,hand_qw,hand_qx,hand_qy,hand_qz,body_x,body_y,body_z,body_qw,body_qx,body_qy,body_qz,"
    "force_x_N,force_y_N,force_z_N,torque_x_NA,torque_y_NA,torque_z_NA,at_rest\n";

void check(const std::optional<Problem>& problem) {
  if (problem) throw CommandError{problem->text()};
}

void append(std::string& row, const PoseA& pose) {
  appendNumbers(row, pose.place.A);
  for (const double q : {pose.orientation.w, pose.orientation.x, pose.orientation.y, pose.orientation.z})
    appendNumber(row, q);
}

}  // namespace

std::vector<Sphere> readSpheres(const std::filesystem::path& file, std::size_t max) {
  std::vector<Sphere> out;
  check(readNumberRows(
      file, kSphereHeader, tr("leave some of them out"), [&](const NumberRow& row) -> std::optional<Problem> {
        const auto& n = row.numbers;
        for (std::size_t k = 0; k < 4; ++k)
          if (!(std::abs(n[k]) <= kMaxPosition_A) || (k == 3 && !(n[k] > 0.0)))
            return Problem{file.string(), row.line, row.columns[k], tr("no sphere has this number"),
                           trf("coordinates lie within {0} of the origin; a radius is greater than 0",
                               quantityText(kMaxPosition_A, Dimension::Length, plain()))};
        if (out.size() == max)
          return Problem{file.string(), row.line, 1, trf("more than {0} spheres", max), tr("leave some of them out")};
        out.push_back({{n[0], n[1], n[2]}, n[3]});
        return std::nullopt;
      }));
  return out;
}

void writeSpheres(const std::string& file, std::span<const Sphere> spheres) {
  Expected<Draft> draft = Draft::begin(file);
  if (!draft) throw CommandError{draft.problem().text()};
  check(draft->append(std::string(kSphereHeader[0]) + '\n'));
  std::string row;
  for (const Sphere& sphere : spheres) {
    row.clear();
    appendNumbers(row, sphere.centre_A);
    appendNumber(row, sphere.radius_A);
    row += '\n';
    check(draft->append(std::string_view(row).substr(1)));  // each number follows a comma
  }
  check(draft->commit());
}

std::vector<Sphere> touchableSpheres(const SphereGrid& scene) {
  std::vector<Sphere> out;
  for (std::size_t k = 0; k < scene.size(); ++k)
    if (scene.touchable(k)) out.push_back(scene[k]);
  return out;
}

std::vector<char> replayBody(const InteractionInput& input, const HipPath& path, double stiffness_N_per_A,
                             const std::string& out) {
  const auto felt = makeInteraction(input);
  std::optional<Draft> draft;
  if (!out.empty()) {
    Expected<Draft> begun = Draft::begin(out);
    if (!begun) throw CommandError{begun.problem().text()};
    draft = *std::move(begun);
    check(draft->append(kColumns));
  }
  std::vector<char> touching(path.size());
  std::size_t inside = 0, refused = 0, unrested = 0;
  std::string row;
  for (std::size_t k = 0; k < path.size(); ++k) {
    const PoseA hand = path.at(k);
    const Response answer = felt->respond(hand);
    touching[k] = answer.contact.touching();
    inside += answer.contact.fault == Fault::StartedInside;
    refused += answer.contact.fault == Fault::NotFinite;
    unrested += !answer.at_rest;
    if (!draft) continue;
    const FeltForce force = answer.total(stiffness_N_per_A);
    row.clear();
    append(row, hand);
    append(row, answer.shownBody(hand));
    appendNumbers(row, force.force_N);
    appendNumbers(row, force.torque_N_A);
    row += answer.at_rest ? ",1\n" : ",0\n";
    check(draft->append(std::string_view(row).substr(1)));  // each number follows a comma
  }
  if (draft) check(draft->commit());
  if (inside)
    err() << "moltact: the body is inside the molecule: no force in " << inside
          << " ticks, until it has been outside\n";
  if (refused) err() << "moltact: " << refused << " places were not finite or beyond 1e9 A: no force there\n";
  if (unrested) err() << "moltact: the body had not come to rest in " << unrested << " ticks\n";
  return touching;
}

}  // namespace moltact
