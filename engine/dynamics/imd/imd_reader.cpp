#include "engine/dynamics/imd/imd_reader.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

#include "engine/core/file_bytes.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

// A header's number, whatever the byte order of this machine.
std::int32_t bigEndian(const std::uint8_t* at) {
  std::uint32_t out = 0;
  for (int k = 0; k < 4; ++k) out = out << 8 | at[k];
  return std::int32_t(out);
}

std::int32_t littleEndianNumber(const std::uint8_t* at) {
  std::uint32_t out = 0;
  for (int k = 3; k >= 0; --k) out = out << 8 | at[k];
  return std::int32_t(out);
}

std::string anotherProtocol() {
  return tr("check the address: a program that speaks IMD, such as GROMACS, LAMMPS or NAMD, must listen there");
}

}  // namespace

template <class T>
T ImdReader::number(const std::uint8_t* at) const {
  if (little_ == (std::endian::native == std::endian::little)) return numberAt<T>(at);
  std::array<std::uint8_t, sizeof(T)> turned;
  std::reverse_copy(at, at + sizeof(T), turned.begin());
  return numberAt<T>(turned.data());
}

ImdReader::Event ImdReader::fail(std::string message, std::string remedy) {
  fault_ = {{}, 0, 0, std::move(message), std::move(remedy)};
  failed_ = true;
  return Event::Fault;
}

ImdReader::Event ImdReader::next(std::span<const std::uint8_t>& bytes) {
  if (failed_) return Event::Fault;
  while (!bytes.empty()) {
    const std::size_t count = std::min(missing_, bytes.size());
    if (kept_) bytes_.insert(bytes_.end(), bytes.begin(), bytes.begin() + std::ptrdiff_t(count));
    bytes = bytes.subspan(count);
    missing_ -= count;
    if (missing_ > 0) break;
    const Event event = in_body_ ? body() : header();
    if (event == Event::Fault) return event;
    if (!in_body_ || missing_ == 0) {  // the next header
      in_body_ = false;
      kept_ = true;
      missing_ = kImdHeaderBytes;
    }
    bytes_.clear();
    if (event != Event::None) return event;
  }
  return Event::None;
}

// The header is followed by a body of this size; one that is not kept is skipped.
ImdReader::Event ImdReader::wants(std::size_t bytes, bool kept) {
  in_body_ = bytes > 0;
  missing_ = bytes;
  kept_ = kept;
  return Event::None;
}

ImdReader::Event ImdReader::header() {
  type_ = ImdType(bigEndian(bytes_.data()));
  const std::int32_t length = bigEndian(bytes_.data() + 4);
  if (version_ == 0) {
    const std::int32_t turned = littleEndianNumber(bytes_.data() + 4);
    if (type_ != ImdType::Handshake) return fail(tr("what listens there does not speak IMD"), anotherProtocol());
    if (length != 2 && length != 3 && turned != 2 && turned != 3)
      return fail(tr("the server speaks a version of IMD that this program does not know"),
                  tr("set the server to version 2 or 3"));
    little_ = turned == 2 || turned == 3;
    version_ = little_ ? turned : length;
    if (version_ == 3) return Event::None;
    greeted_ = true;
    return Event::Greeted;
  }
  const auto is = [&](std::size_t count, std::size_t bytes, bool kept) {
    if (length >= 0 && std::size_t(length) == count) return wants(bytes, kept);
    return fail(trf("the server announces a message of type {0} with the length {1}", int(type_), length),
                tr("connect again; if it happens again, report it"));
  };
  if (!greeted_) {
    if (type_ == ImdType::SessionInfo) return is(kImdSessionBytes, kImdSessionBytes, true);
    return fail(tr("the server does not say what it sends"), anotherProtocol());
  }
  switch (type_) {
    case ImdType::Energies:
      return is(1, kImdEnergyBytes, true);
    case ImdType::Positions:
    case ImdType::Velocities:
    case ImdType::ForcesOfAtoms:
      if (length < 0 || std::size_t(length) != atoms_)
        return fail(trf("the server sends {0} atoms, and the molecule has {1}", length, atoms_),
                    tr("open the structure of exactly the atoms that the server sends (GROMACS: IMD-group; LAMMPS: "
                       "the group of the fix), in the same order"));
      return wants(kImdAtomBytes * atoms_, type_ == ImdType::Positions);
    case ImdType::Time:
      return is(1, kImdTimeBytes, true);
    case ImdType::Box:
      return is(1, kImdBoxBytes, false);
    case ImdType::Disconnect:
    case ImdType::Kill:
    case ImdType::Error:
      return Event::Ended;
    default:
      return fail(trf("the server sends a message of the unknown type {0}", int(type_)),
                  tr("connect again; if it happens again, report it"));
  }
}

ImdReader::Event ImdReader::body() {
  if (!kept_) return Event::None;
  const std::uint8_t* at = bytes_.data();
  if (type_ == ImdType::SessionInfo) {
    // Time, energies, box, positions, wrapped, velocities, forces.
    constexpr std::size_t kPositions = 3, kWrapped = 4;
    if (at[kPositions] == 0)
      return fail(tr("the server is set to send no positions"), tr("set it to send coordinates"));
    wrapped_ = at[kWrapped] != 0;
    greeted_ = true;
    return Event::Greeted;
  }
  if (type_ == ImdType::Energies) {
    energies_ = {number<float>(at + 4), number<float>(at + 12)};
    return Event::Energies;
  }
  if (type_ == ImdType::Time) {
    time_ps_ = number<double>(at + 8);
    return Event::Time;
  }
  positions_A_.resize(atoms_);
  for (std::size_t i = 0; i < atoms_; ++i) {
    Vec3& v = positions_A_[i];
    for (int k = 0; k < 3; ++k) v[k] = number<float>(at + kImdAtomBytes * i + 4 * std::size_t(k));
    if (!finite(v) || std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}) > kFarthest_A)
      return fail(trf("the server sends an impossible position of atom {0}", i + 1),
                  tr("the simulation has become unstable; start it again with weaker forces or a shorter step"));
  }
  return Event::Positions;
}

}  // namespace moltact
