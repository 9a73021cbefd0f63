#include "engine/structure/colour_sight.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <limits>
#include <numbers>
#include <optional>

namespace moltact {
namespace {

using Triple = std::array<double, 3>;

// G. M. Machado, M. M. Oliveira, L. A. F. Fernandes, "A physiologically-based model for simulation of color vision
// deficiency", IEEE Trans. Vis. Comput. Graph. 15 (2009) 1291-1298: severity 1, in linear RGB. The first matrix is
// normal vision. Models of tritanopia differ most: the last matrix is the half-plane for blue and green of H. Brettel,
// F. Viénot and J. D. Mollon, J. Opt. Soc. Am. A 14 (1997) 2647-2655.
constexpr std::array<std::array<Triple, 3>, 5> kSights = {{
    {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
    {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}},
    {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}},
    {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}},
    {{{1.01277, 0.13548, -0.14826}, {-0.01243, 0.86812, 0.14431}, {0.07589, 0.80500, 0.11911}}},
}};

// A colour's L*, a* and b* for each type of vision.
using Seen = std::array<Triple, kSights.size()>;

Seen seen(const Rgb8& colour) {
  const Triple linear = linearRgb(colour);
  Seen out;
  for (std::size_t s = 0; s < kSights.size(); ++s) {
    Triple simulated;
    for (std::size_t k = 0; k < 3; ++k) {
      const Triple& row = kSights[s][k];
      simulated[k] = std::clamp(row[0] * linear[0] + row[1] * linear[1] + row[2] * linear[2], 0.0, 1.0);
    }
    out[s] = labOfLinear(simulated);
  }
  return out;
}

double degrees(double radians) { return radians * 180.0 / std::numbers::pi; }
double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

// CIEDE2000 with the weights 1, 1, 1 (CIE 142-2001), in the notation of Sharma, Wu and Dalal (2005).
double ciede2000(const Triple& p, const Triple& q) {
  constexpr double k25To7 = 6103515625.0;
  const auto chromaShare = [](double chroma) {
    const double c7 = std::pow(chroma, 7);
    return std::sqrt(c7 / (c7 + k25To7));
  };
  const double g = 0.5 * (1.0 - chromaShare(0.5 * (std::hypot(p[1], p[2]) + std::hypot(q[1], q[2]))));
  const double a1 = p[1] * (1.0 + g), a2 = q[1] * (1.0 + g);
  const double c1 = std::hypot(a1, p[2]), c2 = std::hypot(a2, q[2]);
  const auto hue = [](double a, double b) {
    if (a == 0.0 && b == 0.0) return 0.0;
    const double h = degrees(std::atan2(b, a));
    return h < 0.0 ? h + 360.0 : h;
  };
  const double h1 = hue(a1, p[2]), h2 = hue(a2, q[2]);
  const bool coloured = c1 * c2 > 0.0;
  const double turn = coloured ? std::remainder(h2 - h1, 360.0) : 0.0;
  const double light = q[0] - p[0], chroma = c2 - c1, hues = 2.0 * std::sqrt(c1 * c2) * std::sin(radians(0.5 * turn));
  const double mean_l = 0.5 * (p[0] + q[0]), mean_c = 0.5 * (c1 + c2);
  double mean_h = h1 + h2;
  if (coloured) {
    mean_h *= 0.5;
    if (std::abs(h1 - h2) > 180.0) mean_h += h1 + h2 < 360.0 ? 180.0 : -180.0;
  }
  const double t = 1.0 - 0.17 * std::cos(radians(mean_h - 30.0)) + 0.24 * std::cos(radians(2.0 * mean_h)) +
                   0.32 * std::cos(radians(3.0 * mean_h + 6.0)) - 0.20 * std::cos(radians(4.0 * mean_h - 63.0));
  const double from_50 = (mean_l - 50.0) * (mean_l - 50.0);
  const double s_l = 1.0 + 0.015 * from_50 / std::sqrt(20.0 + from_50), s_c = 1.0 + 0.045 * mean_c,
               s_h = 1.0 + 0.015 * mean_c * t;
  const double blue = std::exp(-std::pow((mean_h - 275.0) / 25.0, 2));
  const double r_t = -std::sin(radians(60.0 * blue)) * 2.0 * chromaShare(mean_c);
  const double l = light / s_l, c = chroma / s_c, h = hues / s_h;
  return std::sqrt(std::max(0.0, l * l + c * c + h * h + r_t * c * h));
}

double minDistance(const Seen& a, const Seen& b) {
  double smallest = std::numeric_limits<double>::max();
  for (std::size_t s = 0; s < kSights.size(); ++s) smallest = std::min(smallest, ciede2000(a[s], b[s]));
  return smallest;
}

// From the colour itself to shades that differ increasingly from it.
struct Shade {
  float share;  // fraction of white or black
  bool white;
};
constexpr std::array<Shade, 7> kShades = {
    {{0.0f, true}, {0.15f, false}, {0.2f, true}, {0.3f, false}, {0.4f, true}, {0.45f, false}, {0.6f, true}}};

Rgb8 shaded(const Rgb8& colour, const Shade& shade) {
  const float to = shade.white ? 255.0f : 0.0f;
  Rgb8 out;
  for (std::size_t k = 0; k < 3; ++k)
    out[k] = static_cast<std::uint8_t>(std::lround(float(colour[k]) + (to - float(colour[k])) * shade.share));
  return out;
}

struct Candidate {
  Rgb8 colour;
  Seen seen;
  double change;  // fraction of white or black
  double from_targets = 1.0, from_beside = 1.0;
};

// The quality of a choice, ordered by importance of its parts. Distances are fractions of the required ones, at most 1;
// an additional mark never increases a part.
struct Worth {
  double of_marks = 1.0, of_beside = 1.0, unchanged = 0.0;
  auto operator<=>(const Worth&) const = default;
};

// Chooses one candidate for each mark in turn.
class Chooser {
 public:
  Chooser(std::span<const Rgb8> wanted, std::span<const Rgb8> targets, std::span<const Rgb8> beside) {
    std::vector<Seen> at_targets, at_beside;
    for (const Rgb8& t : targets) at_targets.push_back(seen(t));
    for (const Rgb8& b : beside) at_beside.push_back(seen(b));
    for (const Rgb8& colour : wanted) {
      std::vector<Candidate>& of = candidates_.emplace_back();
      for (const Shade& shade : kShades) {
        Candidate one{shaded(colour, shade), {}, double(shade.share)};
        one.seen = seen(one.colour);
        for (const Seen& t : at_targets)
          one.from_targets = std::min(one.from_targets, minDistance(one.seen, t) / kMarksApart);
        for (const Seen& b : at_beside)
          one.from_beside = std::min(one.from_beside, minDistance(one.seen, b) / kBesideApart);
        of.push_back(one);
      }
    }
  }

  std::vector<Rgb8> chosen() {
    // All combinations are tried for a few marks; of many, each gets the best shade relative to the previous ones.
    constexpr std::size_t kMaxTogether = 5;
    for (std::size_t first = 0; first < candidates_.size(); first += kMaxTogether) {
      best_worth_.reset();
      search(first, std::min(candidates_.size(), first + kMaxTogether), {});
      now_ = best_;
    }
    std::vector<Rgb8> out;
    for (std::size_t k = 0; k < now_.size(); ++k) out.push_back(candidates_[k][now_[k]].colour);
    return out;
  }

 private:
  void search(std::size_t mark, std::size_t end, const Worth& worth) {
    if (best_worth_ && worth <= *best_worth_) return;
    if (mark == end) {
      best_worth_ = worth;
      best_ = now_;
      return;
    }
    for (std::size_t c = 0; c < candidates_[mark].size(); ++c) {
      const Candidate& one = candidates_[mark][c];
      Worth with{std::min(worth.of_marks, one.from_targets), std::min(worth.of_beside, one.from_beside),
                 worth.unchanged - one.change};
      for (std::size_t k = 0; k < mark && !(best_worth_ && with <= *best_worth_); ++k)
        with.of_marks = std::min(with.of_marks, minDistance(one.seen, candidates_[k][now_[k]].seen) / kMarksApart);
      now_.push_back(c);
      search(mark + 1, end, with);
      now_.pop_back();
    }
  }

  std::vector<std::vector<Candidate>> candidates_;  // per mark
  std::vector<std::size_t> now_, best_;
  std::optional<Worth> best_worth_;
};

}  // namespace

double minSeenDistance(const Rgb8& a, const Rgb8& b) { return minDistance(seen(a), seen(b)); }

std::vector<Rgb8> shadesApart(std::span<const Rgb8> wanted, std::span<const Rgb8> targets,
                              std::span<const Rgb8> beside) {
  return Chooser(wanted, targets, beside).chosen();
}

}  // namespace moltact
