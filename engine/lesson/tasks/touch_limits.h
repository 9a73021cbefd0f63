// Optional limits of tasks whose targets are atoms: where on them a touch counts, and replies to touches of other atoms.
// Window's thread. Unit: angstrom.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/lesson/tasks/task.h"

namespace moltact {

/// Where a touch of the target counts: on the side that faces other atoms ("side"), and within a sphere around atoms
/// ("region"). Everywhere if neither is given.
class TouchLimits {
 public:
  /// `target`: the key of the atoms to be touched.
  TouchLimits(const TaskSpec& spec, std::string_view target, const Molecule& molecule);
  bool given() const { return side_.has_value() || region_.has_value(); }
  /// Whether a contact point of a probe with this radius counts.
  bool allow(const Vec3& scp_A, double probe_A) const;
  /// The same for a contact with the target.
  bool allow(const Contact& contact, double probe_A) const { return allow(contact.scp.A, probe_A); }

  static std::vector<KeySpec> keys();

 private:
  struct Side {
    Vec3 from_A{0.0}, to_A{0.0};  // the centres of the target and of the atoms that its side faces
  };
  struct Reach {
    Vec3 centre_A{0.0};
    double radius_A = 0.0;  // to the atoms' surfaces
  };
  std::optional<Side> side_;
  std::optional<Reach> region_;
};

/// The author's replies to touches of other places than the requested one ("wrong").
class WrongTouches {
 public:
  WrongTouches(const TaskSpec& spec, const Molecule& molecule);
  /// The reply for the first of the author's atoms in the contact's active set; empty if there is none.
  std::string about(const Contact& contact) const;

  static KeySpec key();

 private:
  struct Remark {
    AtomSet atoms;
    std::string text;
  };
  std::vector<Remark> remarks_;
};

}  // namespace moltact
