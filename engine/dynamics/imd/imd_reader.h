// Splits the bytes of an IMD server into messages. IMD (interactive molecular dynamics) is the protocol with which
// GROMACS, LAMMPS and NAMD send positions over TCP and take forces; versions 2 and 3. A message is a header of two
// 32-bit numbers, type and length, most significant byte first, and a body in the server's byte order, which the
// handshake reveals. Pure: no socket, no clock. Memory is bounded by the number of atoms that the caller expects,
// whatever length a header announces. One thread at a time. Units: angstrom, picosecond, kelvin, kJ/mol.
// Source: docs/source/protocol_v3.rst of the program imdclient, and the implementations in GROMACS and LAMMPS.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/core/problem.h"
#include "engine/core/units.h"

namespace moltact {

enum class ImdType : std::int32_t {
  Disconnect = 0,
  Energies = 1,
  Positions = 2,
  Go = 3,
  Handshake = 4,
  Kill = 5,
  Forces = 6,  ///< from the client
  Pause = 7,   ///< version 2: pauses and resumes in turn
  Rate = 8,    ///< steps from one frame to the next
  Error = 9,
  // Version 3.
  SessionInfo = 10,
  Resume = 11,
  Time = 12,
  Box = 13,
  Velocities = 14,
  ForcesOfAtoms = 15,  ///< from the server
};

inline constexpr std::size_t kImdHeaderBytes = 8, kImdEnergyBytes = 40, kImdTimeBytes = 24, kImdBoxBytes = 36,
                             kImdSessionBytes = 7, kImdAtomBytes = 12;

/// As the server sends them. Version 2 does not define the unit: GROMACS sends kJ/mol, NAMD kcal/mol.
struct ImdEnergies {
  double temperature_K = 0.0, potential = 0.0;
};

class ImdReader {
 public:
  enum class Event : std::uint8_t {
    None,       ///< all bytes are used
    Greeted,    ///< the handshake is complete, with the session info of version 3
    Energies,   ///< energies() is new
    Time,       ///< time_ps() is new
    Positions,  ///< positions_A() is new
    Ended,      ///< the server ends the session
    Fault,      ///< fault() says what is wrong; the connection must be closed, later calls return Fault again
  };

  explicit ImdReader(std::size_t atoms) : atoms_(atoms) {}

  /// Takes bytes from the front of `bytes` until a message is complete or none are left.
  Event next(std::span<const std::uint8_t>& bytes);

  int version() const { return version_; }
  /// Whether the server puts atoms that leave its box back on the other side (version 3 says so).
  bool wrapped() const { return wrapped_; }
  /// Whether the server's numbers have the least significant byte first.
  bool littleEndian() const { return little_; }
  const ImdEnergies& energies() const { return energies_; }
  double time_ps() const { return time_ps_; }
  /// All finite, and at most kFarthest_A from the origin along each axis.
  std::span<const Vec3> positions_A() const { return positions_A_; }
  const Problem& fault() const { return fault_; }

  static constexpr double kFarthest_A = 1e6;

 private:
  template <class T>
  T number(const std::uint8_t* at) const;
  Event header();
  Event body();
  Event wants(std::size_t bytes, bool kept);
  Event fail(std::string message, std::string remedy);

  std::size_t atoms_;
  std::vector<std::uint8_t> bytes_;  // of the header, then of the body
  std::size_t missing_ = kImdHeaderBytes;
  bool in_body_ = false, kept_ = true;
  ImdType type_ = ImdType::Handshake;
  int version_ = 0;
  bool little_ = true, greeted_ = false, failed_ = false, wrapped_ = false;
  ImdEnergies energies_;
  double time_ps_ = 0.0;
  std::vector<Vec3> positions_A_;
  Problem fault_;
};

}  // namespace moltact
