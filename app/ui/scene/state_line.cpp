#include "app/ui/scene/state_line.h"

#include <cmath>

namespace moltact {

bool StateLine::update(const std::string& what, const std::string& line, double force_N, double now_s) {
  if (what != candidate_) {
    candidate_ = what;
    candidate_s_ = now_s;
  }
  const bool other = what != told_, force_changed = std::abs(force_N - told_N_) >= pace_.step_N;
  if (!text_.empty()) {
    if (!other && !force_changed) return false;
    if (now_s - told_s_ < pace_.pace_s || now_s - candidate_s_ < pace_.rest_s) return false;
  }
  told_ = what;
  told_N_ = force_N;
  told_s_ = now_s;
  if (line == text_) return false;
  text_ = line;
  return true;
}

}  // namespace moltact
