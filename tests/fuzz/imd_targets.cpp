// The bytes of an IMD server. For any bytes in pieces of any size the positions are finite and those of the whole, no
// force names an atom that is not there, and a session that ends after its handshake ends its forces and disconnects.
#include <algorithm>
#include <vector>

#include "engine/dynamics/imd/imd_session.h"
#include "tests/dynamics/imd_bytes.h"
#include "tests/fuzz/target.h"

namespace moltact::fuzz {
namespace {

constexpr std::size_t kImdAtoms = 3;

// A session over these bytes, and what it has sent.
struct PlayedSession {
  ImdSession session{{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 2, 0)}, 0.0};
  std::vector<std::uint8_t> sent;

  PlayedSession(std::string_view bytes, std::size_t piece) {
    SimulationCommand pull;
    pull.pushes.push_back({1, Vec3(9, 9, 9), Vec3(0.0), 2.0});
    pull.pushes.push_back({77, Vec3(9, 9, 9), Vec3(0.0), 2.0});
    double now_s = 0.0;
    while (!bytes.empty() && !session.ended()) {
      const std::size_t count = std::min(piece, bytes.size());
      const std::vector<std::uint8_t> some(bytes.begin(), bytes.begin() + std::ptrdiff_t(count));
      session.received(some, now_s);
      session.command(pull, now_s);
      session.passed(now_s);
      sent.insert(sent.end(), session.toSend().begin(), session.toSend().end());
      session.toSend().clear();
      bytes.remove_prefix(count);
      now_s += 1e-4;
    }
    session.leave();
    sent.insert(sent.end(), session.toSend().begin(), session.toSend().end());
  }
};

}  // namespace

void imd(std::string_view bytes) {
  const std::size_t piece = bytes.empty() ? 1 : 1u + static_cast<unsigned char>(bytes.front());
  if (!bytes.empty()) bytes.remove_prefix(1);
  const PlayedSession whole(bytes, bytes.size()), cut(bytes, piece);
  const SimulationFrame &a = whole.session.frame(), &b = cut.session.frame();
  mustBe(a.positions_A == b.positions_A && a.dead == b.dead && a.fault == b.fault, "the same in pieces");
  mustBe(a.positions_A.empty() || a.positions_A.size() == kImdAtoms, "a place for each atom");
  for (const Vec3& v : a.positions_A) mustBe(finite(v), "a place that is a number");
  mustBe(std::isfinite(a.time_ps) && std::isfinite(a.energies.temperature_K), "a time and a temperature");
  mustBe(a.dead == whole.session.problem().has_value() && (!a.dead || !a.fault.empty()), "a sentence");
  std::vector<std::uint8_t> rest = cut.sent;
  if (rest.empty()) return;
  const bool little = bytes.size() > 4 && bytes[4] != 0;
  const std::vector<test::ImdSent> sent = test::takeSent(rest, little);
  mustBe(rest.empty() && sent.size() >= 4, "whole messages");
  mustBe(
      sent[0].type == 3 && sent.back().type == 0 && sent[sent.size() - 2].type == 6 && sent[sent.size() - 2].value == 0,
      "begun with GO, ended without force");
  for (const test::ImdSent& s : sent)
    for (std::size_t k = 0; k < s.atoms.size(); ++k)
      mustBe(s.atoms[k] == 1 && glm::length(s.forces[k]) < 4.185 * 28.81, "a force on the atom that is pulled");
}

}  // namespace moltact::fuzz
