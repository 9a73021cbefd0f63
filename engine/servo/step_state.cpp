#include "engine/servo/step_state.h"

#include <charconv>
#include <cmath>
#include <map>
#include <type_traits>
#include <utility>

#include "engine/language/catalogue.h"

namespace moltact {

static_assert(sizeof(void*) != 8 ||  // the layout differs on other machines; the names are the same
                  (sizeof(HandSpeed) == 312 && sizeof(PassivityControl) == 12304 && sizeof(ThermalModel) == 16 &&
                   sizeof(Clutch) == 152 && sizeof(SafetyStage) == 13376 && sizeof(ServoStep) == 13688),
              "a member more is to be named below, or a replay is not the same");

// All members of a step's state with their names in files and ranges; a friend of the classes whose members they are.
// The file names do not follow renamed members, so that older recordings stay readable. `each` is called as
// each(prefix, name, value, min, max).
struct StepState {
  static constexpr double kAny = 1e12;  // in any unit: far beyond every device, with finite squares

  template <class Each>
  static void vector(Each& each, const std::string& prefix, const std::string& name, Vec3& v, double limit = kAny) {
    each(prefix, name + ".x", v.x, -limit, limit), each(prefix, name + ".y", v.y, -limit, limit),
        each(prefix, name + ".z", v.z, -limit, limit);
  }

  template <class Each>
  static void quaternion(Each& each, const std::string& prefix, const std::string& name, Quat& q) {
    each(prefix, name + ".w", q.w, -1.01, 1.01), each(prefix, name + ".x", q.x, -1.01, 1.01),
        each(prefix, name + ".y", q.y, -1.01, 1.01), each(prefix, name + ".z", q.z, -1.01, 1.01);
  }

  template <class Each>
  static void of(Each& each, const std::string& p, HandSpeed& s) {
    for (std::size_t k = 0; k < s.ring_.size(); ++k) {
      vector(each, p, "place_m." + std::to_string(k), s.ring_[k].place_m);
      each(p, "time_s." + std::to_string(k), s.ring_[k].time_s, 0.0, kAny);
    }
    each(p, "next", s.next_, std::size_t{0}, s.ring_.size() - 1),
        each(p, "count", s.count_, std::size_t{0}, s.ring_.size());
    each(p, "time_s", s.time_s_, 0.0, kAny);
  }

  template <class Each>
  static void of(Each& each, const std::string& p, PassivityControl& s) {
    each(p, "debt_J", s.debt_J_, 0.0, kAny);
    // A ring of kOlder ticks, as contained in older recordings.
    constexpr std::size_t kOlder = 8;
    const std::size_t size = s.given_.size();
    if (each.holds(p + "next", false)) {
      std::size_t next = 0;
      each(p, "next", next, std::size_t{0}, kOlder - 1);
      for (std::size_t k = 0; k < kOlder; ++k) {
        const std::size_t at = size - 1 - (next + kOlder - 1 - k) % kOlder;
        vector(each, p, "given_N." + std::to_string(k), s.given_[at]);
        vector(each, p, "given_N_mm." + std::to_string(k), s.torques_[at]);
      }
      return;
    }
    // The newest entry first; zeros are omitted.
    for (std::size_t ago = 0; ago < size; ++ago) {
      const std::size_t at = (s.next_ + size - 1 - ago) % size;
      for (auto [name, v] : {std::pair("given_ago_N.", &s.given_[at]), std::pair("given_ago_N_mm.", &s.torques_[at])}) {
        const std::string full = name + std::to_string(ago);
        if (each.holds(p + full + ".x", *v != Vec3(0.0))) vector(each, p, full, *v);
      }
    }
  }

  template <class Each>
  static void of(Each& each, const std::string& p, ThermalModel& s) {
    each(p, "heat_N2", s.heat_N2_, 0.0, kAny), each(p, "told", s.reported_, -kAny, kAny);
  }

  template <class Each>
  static void of(Each& each, const std::string& p, Clutch& s) {
    vector(each, p, "offset_mm", s.offset_mm_), vector(each, p, "last_mm", s.last_mm_),
        vector(each, p, "rest_mm", s.rest_mm_);
    each(p, "still_s", s.still_s_, 0.0, kAny), each(p, "held", s.held_, false, true);
    // Without a grip the stylus's last orientation matters only while the button is held. Recordings from before the
    // clutch for orientation contain neither.
    if (each.holds(p + "turned.w", s.turned_ != kNoRotation || s.last_stylus_ != kNoRotation))
      quaternion(each, p, "turned", s.turned_), quaternion(each, p, "last_stylus", s.last_stylus_);
  }

  template <class Each>
  static void of(Each& each, const std::string& p, SafetyStage& s) {
    each(p, "peak_N", s.peak_N_, 0.0, kAny), each(p, "continuous_N", s.continuous_N_, 0.0, kAny);
    each(p, "max_stiffness", s.max_stiffness_, 0.0, kAny), each(p, "max_damping", s.max_damping_, 0.0, kAny);
    each(p, "damping", s.damping_, 0.0, kAny), each(p, "friction_N", s.friction_N_, 0.0, kAny);
    each(p, "resolution_m", s.resolution_m_, 0.0, kAny), each(p, "device_delay_s", s.device_delay_s_, 0.0, kAny);
    each(p, "fastest_m_per_s", s.max_speed_m_per_s_, 0.0, safety::kMaxSpeed_m_per_s);
    each(p, "rise_N_per_s", s.rise_N_per_s_, 0.0, safety::kSlew_N_per_s),
        each(p, "closes_loop", s.closes_loop_, false, true);
    each(p, "peak_torque_N_mm", s.peak_torque_N_mm_, 0.0, kAny);
    if (each.holds(p + "rotational_damping_N_mm_s", s.rotational_damping_N_mm_s_ != 0.0))
      each(p, "rotational_damping_N_mm_s", s.rotational_damping_N_mm_s_, 0.0, kAny);
    of(each, p + "speed.", s.speed_), of(each, p + "turning.", s.angular_speed_);
    vector(each, p, "place_mm", s.place_mm_), vector(each, p, "moved_m", s.moved_m_);
    quaternion(each, p, "orientation", s.orientation_);
    vector(each, p, "angle_rad", s.angle_rad_), vector(each, p, "turned_rad", s.rotation_rad_, 4.0);
    each(p, "placed", s.placed_, false, true),
        each(p, "discontinuities", s.discontinuities_, std::uint32_t{0}, ~std::uint32_t{0});
    each(p, "stale_s", s.stale_s_, 0.0, kAny), each(p, "delay_s", s.delay_s_, 0.0, safety::kContactLost_s);
    each(p, "elapsed_s", s.elapsed_s_, 0.0, safety::kStale_s), each(p, "dt_s", s.dt_s_, 0.0, kTick_s);
    each(p, "off", s.off_, false, true);
    of(each, p + "heat.", s.heat_), of(each, p + "passivity.", s.passivity_);
    each(p, "gain", s.gain_, 0.0, 1.0), each(p, "stiffness", s.stiffness_, 0.0, safety::kMaxStiffness_N_per_mm);
    Stored& stored = s.stored_;
    each(p, "stretch_mm", stored.springs.stretch_mm, 0.0, kAny);
    each(p, "torque_mm2", stored.springs.torque_mm2, 0.0, kAny);
    each(p, "energy_mm2", stored.springs.energy_mm2, -kAny, kAny);
    // Recordings from before the introduction of fields contain none of these.
    if (each.holds(p + "field", stored.field || s.field_share_ != 1.0)) {
      each(p, "field", stored.field, false, true);
      each(p, "field_energy_N_mm", stored.field_energy_N_mm, -kAny, kAny);
      each(p, "field_stiffness_N_per_mm", stored.field_stiffness_N_per_mm, 0.0, kAny);
      each(p, "wanted_N", stored.force_N, 0.0, kAny), each(p, "wanted_N_mm", stored.torque_N_mm, 0.0, kAny);
      each(p, "field_share", s.field_share_, 0.0, 1.0);
    }
    each(p, "fault", s.fault_, false, true), each(p, "stopped", s.stopped_, false, true);
    vector(each, p, "force_N", s.force_N_), vector(each, p, "torque_N_mm", s.torque_N_mm_);
    // The limits that acted in the last tick are recomputed in the next.
  }

  template <class Each>
  static void of(Each& each, ServoStep& s) {
    each("", "tick", s.tick_, std::uint64_t{0},
         ~std::uint64_t{0} >> 1);  // the count is also a time, which must not overflow
    each("", "discontinuities", s.discontinuities_, std::uint32_t{0}, ~std::uint32_t{0});
    each("", "hand_placements", s.hand_discontinuities_, std::uint32_t{0}, ~std::uint32_t{0});
    each("", "other_device", s.other_device_, false, true), each("", "A_per_mm", s.A_per_mm_, -kAny, kAny);
    vector(each, "", "workspace_mm", s.workspace_mm_), vector(each, "", "push", s.push_, 2.0);
    of(each, "clutch.", s.clutch_), of(each, "safety.", s.safety_);
    // The last interaction is a memory address: a step read from text has none.
  }
};

namespace {

struct Writer {
  std::string out{};

  static bool holds(const std::string&, bool worth_saying) { return worth_saying; }

  template <class T>
  void operator()(const std::string& prefix, const std::string& name, T& value, T, T) {
    char text[64];
    std::to_chars_result end{};
    if constexpr (std::is_same_v<T, double>)
      end = std::to_chars(text, text + sizeof text, value, std::chars_format::hex);
    else if constexpr (std::is_same_v<T, bool>)
      end = std::to_chars(text, text + sizeof text, int(value));
    else
      end = std::to_chars(text, text + sizeof text, value);
    out.append(prefix).append(name).append("=").append(text, end.ptr) += '\n';
  }
};

struct Reader {
  std::map<std::string, std::string_view, std::less<>> values;
  std::string wrong{};  // the first invalid value

  bool holds(const std::string& name, bool) const { return values.contains(name); }

  template <class T>
  void operator()(const std::string& prefix, const std::string& name, T& value, T min, T max) {
    if (!wrong.empty()) return;
    const auto found = values.find(prefix + name);
    if (found == values.end()) {
      wrong = trf("the state that the recording begins from does not say {0}", prefix + name);
      return;
    }
    const std::string_view text = found->second;
    const char* const last = text.data() + text.size();
    std::conditional_t<std::is_same_v<T, bool>, int, T> read{};
    std::from_chars_result end{};
    if constexpr (std::is_same_v<T, double>)
      end = std::from_chars(text.data(), last, read, std::chars_format::hex);
    else
      end = std::from_chars(text.data(), last, read);
    if (end.ec != std::errc{} || end.ptr != last || !(read >= min && read <= max)) {
      wrong = trf("the state that the recording begins from has a {0} that cannot be", prefix + name);
      return;
    }
    value = T(read);
    values.erase(found);
  }
};

}  // namespace

std::string stateText(const ServoStep& step) {
  Writer writer;
  ServoStep copy = step;
  StepState::of(writer, copy);
  return std::move(writer.out);
}

Expected<ServoStep> stepFromText(std::string_view text) {
  const auto problem = [](std::string what) { return Problem{"", 0, 0, std::move(what), tr("record it again")}; };
  Reader reader;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size()), equals = text.find('=');
    if (equals >= end) return problem(tr("the state that the recording begins from holds a line without a value"));
    if (!reader.values.emplace(text.substr(0, equals), text.substr(equals + 1, end - equals - 1)).second)
      return problem(tr("the state that the recording begins from says a value twice"));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  ServoStep step;
  StepState::of(reader, step);
  if (!reader.wrong.empty()) return problem(reader.wrong);
  if (!reader.values.empty())
    return problem(tr("the state that the recording begins from holds a value that is not known"));
  return step;
}

}  // namespace moltact
