#include "engine/haptics/paper/cone.h"

namespace moltact::paper {

bool insideCone(const Cone& cone, const Vec3& hip) {
  const IntersectionCircle& c = cone.circle;
  const Vec3 from_C1 = hip - c.centre;
  const Vec3 projected = from_C1 - c.axis * glm::dot(from_C1, c.axis);
  const double a2 = c.radius * c.radius;
  if (!(glm::dot(projected, projected) < a2)) return false;
  // "a dot product": the cosine of the HIP's angle at the apex against height over slant, multiplied out.
  const Vec3 from_apex = hip - cone.apex;
  const double slant = glm::sqrt(c.height * c.height + a2);
  return glm::dot(from_apex, c.axis) * slant >= c.height * glm::length(from_apex);
}

bool pastBase(const Cone& cone, const Vec3& hip) { return glm::dot(hip - cone.circle.centre, cone.circle.axis) > 0.0; }

Cone neighbourCone(const Cone& cone, const Vec3& neighbour_centre) {
  Cone out = cone;
  out.apex = neighbour_centre;
  out.atom = cone.neighbour;
  out.neighbour = cone.atom;
  out.circle.axis = -cone.circle.axis;
  out.circle.height = glm::dot(cone.circle.centre - neighbour_centre, out.circle.axis);
  return out;
}

}  // namespace moltact::paper
