// A session with an IMD server without its socket and its clock: bytes and times go in, positions and bytes to send come
// out. The hand's springs (AtomPush) become forces at the newest positions each time the server sends new ones. The
// forces end when commands stop, when positions stop, when the user pauses and when the session ends. One thread at a
// time. Units: angstrom, kcal/mol, picosecond, second.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/dynamics/imd/imd_reader.h"
#include "engine/dynamics/imd/imd_writer.h"
#include "engine/dynamics/live_simulation.h"

namespace moltact {

class ImdSession {
 public:
  /// `start_A`: the places of the molecule's atoms. The server's positions are shifted so that the centre of the first
  /// ones lies at the centre of these.
  ImdSession(std::vector<Vec3> start_A, double now_s);

  /// Bytes that the server has sent.
  void received(std::span<const std::uint8_t> bytes, double now_s);
  /// The newest requests. Of a command only `pushes` and `running` have an effect.
  void command(const SimulationCommand& wanted, double now_s);
  /// Call at least ten times a second: it notices silence.
  void passed(double now_s);
  /// The connection is gone.
  void lost();
  /// The user ends the session: the last messages are added to toSend().
  void leave();

  /// Bytes for the server, in their order; the caller sends and clears them.
  std::vector<std::uint8_t>& toSend() { return to_send_; }
  /// Messages that end all forces, for a process that dies. Empty before the handshake: nothing is to be sent then.
  std::vector<std::uint8_t> lastWords() const;

  const SimulationFrame& frame() const { return frame_; }
  bool ended() const { return ended_; }
  /// Why it ended; empty while it runs and after leave().
  const std::optional<Problem>& problem() const { return problem_; }

  /// The server sends positions after this number of steps. LAMMPS with version 2 applies no force in the steps in which
  /// it sends positions, so a small number would weaken the hand.
  static constexpr int kStepsPerFrame = 10;
  /// The largest sum of the sizes of the forces (about 2000 pN).
  static constexpr double kStrongest_kcal_mol_A = 28.8;
  /// Without a command for this time the forces end.
  static constexpr double kCommands_s = 0.5;
  /// Without positions for this time, while it is not paused, the forces end and the hand is released; after the second
  /// one the session ends.
  static constexpr double kSilence_s = 1.0, kGone_s = 20.0;
  /// The first positions must come within this time.
  static constexpr double kFirst_s = 10.0;
  /// An atom that moves farther from one frame to the next has jumped. Either the server has started again, or the atom
  /// has left its box on one side and entered on the other.
  static constexpr double kJump_A = 10.0;

 private:
  void greet(double now_s);
  void takePositions(double now_s);
  void sendForces();
  void endForces();
  void end(Problem why);
  void pause(bool on);

  ImdReader reader_;
  std::vector<Vec3> start_A_;
  std::vector<std::uint8_t> to_send_;
  SimulationFrame frame_;
  std::vector<AtomPush> pushes_;
  std::vector<ImdForce> forces_;  // as sent, so that the same memory is used again
  std::optional<Problem> problem_;
  Vec3 shift_A_{0.0};
  double began_s_, commanded_s_, heard_s_;
  double first_ps_ = 0.0, before_ps_ = 0.0, counted_since_s_ = 0.0;
  std::uint64_t counted_ = 0;
  bool greeted_ = false, running_ = true, forces_on_ = false, has_time_ = false, ended_ = false;
};

}  // namespace moltact
