#include "app/ui/scene/body_place.h"

#include "engine/haptics/sweep.h"

namespace moltact {

BodyPlace bodyPlace(const Stage& stage, const ServoSample& now, const SphereMotion* motion) {
  BodyPlace out;
  if (!stage.body) return out;
  const bool touching = now.contact.touching();
  const Vec3 drawn_A = touching ? now.contact.scp.A : now.hip.A;
  const BallScene& others = motion ? motion->sweptBalls() : *stage.balls;
  out.atoms = stage.body->balls.size();
  for (std::size_t k = 0; k < stage.body->balls.size(); ++k) {
    const Ball& ball = stage.body->balls[k];
    const Vec3 lever_A = now.orientation * ball.centre_A;
    const Vec3 home_A = stage.body->middle.A + ball.centre_A;
    out.in_place += glm::distance(drawn_A + lever_A, home_A) <= kInPlace_A;
    if (touching && clearance(others, ball.radius_A, now.hip.A + lever_A, motion, now.fraction) < 0.0)
      out.stopped.push_back(std::uint32_t(k));
  }
  return out;
}

}  // namespace moltact
