// What tasks that want atoms touched may ask for besides: where on them, and what is said to a touch of others.
// Used as tasks are (task.h). Units: angstrom.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/lesson/tasks/task.h"

namespace moltact {

/// Where on its atoms a touch counts: on the side that looks to other atoms ("side"), and within the sphere round atoms
/// ("region"). Everywhere where neither is asked for.
class TouchLimits {
 public:
  /// `target`: the key of the atoms that are to be touched.
  TouchLimits(const TaskSpec& spec, std::string_view target, const Molecule& molecule);
  bool given() const { return side_.has_value() || region_.has_value(); }
  /// Whether a contact point counts of a probe of this radius.
  bool allow(const Vec3& scp_A, double probe_A) const;
  /// The same of a contact with the target.
  bool allow(const Contact& contact, double probe_A) const { return allow(contact.scp.A, probe_A); }

  static std::vector<KeySpec> keys();

 private:
  struct Side {
    Vec3 from_A{0.0}, to_A{0.0};  // the middles of the target and of the atoms that its side looks to
  };
  struct Reach {
    Vec3 centre_A{0.0};
    double radius_A = 0.0;  // to the atoms' surfaces
  };
  std::optional<Side> side_;
  std::optional<Reach> region_;
};

/// What the author says to a touch that is not the one asked for ("wrong").
class WrongTouches {
 public:
  WrongTouches(const TaskSpec& spec, const Molecule& molecule);
  /// To the first of the author's atoms that hold the contact; empty where nothing is said.
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
