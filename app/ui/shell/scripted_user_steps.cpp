// The script language: one command per line, words separated by spaces, "#" begins a comment.
//
//   open FILE | drop FILE        size WIDTH HEIGHT             theme light|dark|high-contrast
//   scale FACTOR                 text-size FACTOR: of the text only
//   click WIDGET [right]         drag WIDGET DX DY [right]     point WIDGET [X Y]        press | release
//   wheel NOTCHES                key NAMES                     hold NAMES | let-go NAMES type TEXT
//   plug out|in: the simulated stylus, if it is in use
//   sound on|off                 heard FILE.wav: the sound since it was switched on
//   wait FRAMES                  expect WIDGET TEXT            expect-not WIDGET TEXT    picture FILE.png
//
// `expect` passes if the widget is on the screen and its text contains TEXT.
#include <algorithm>
#include <charconv>
#include <sstream>
#include <string_view>
#include <vector>

#include "app/ui/extensions/extensions.h"
#include "app/ui/shell/scripted_user.h"
#include "engine/device/simulated_device.h"
#include "engine/language/quantity_text.h"
#include "engine/sound/wav_file.h"

namespace moltact {
namespace {

// The numeric arguments of a command: the index of the first one, and their range.
struct Numbers {
  std::string_view verb;
  std::size_t first, count;
  double min, max;
};
constexpr Numbers kNumbers[]{{"size", 0, 2, 64.0, 8192.0}, {"scale", 0, 1, 0.5, 4.0},  {"text-size", 0, 1, 0.5, 4.0},
                             {"drag", 1, 2, -1e5, 1e5},    {"point", 1, 2, -1e3, 1e3}, {"wheel", 0, 1, -1e3, 1e3},
                             {"wait", 0, 1, 0.0, 1e5}};

std::optional<double> numberOf(const std::string& word) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return value;
}

struct Act {
  std::string verb;
  std::vector<std::string> words;
  std::string rest;  ///< of the line, after the command's name

  const std::string& word(std::size_t k) const {
    static const std::string kNone;
    return k < words.size() ? words[k] : kNone;
  }
  double number(std::size_t k, double otherwise) const {
    return k < words.size() ? numberOf(words[k]).value_or(otherwise) : otherwise;
  }
  std::string after(std::size_t k) const {
    std::string out;
    for (; k < words.size(); ++k) out += (out.empty() ? "" : " ") + words[k];
    return out;
  }
};

Act parse(const std::string& line) {
  Act act;
  std::istringstream in(line.substr(0, line.find('#')));
  in >> act.verb;
  for (std::string word; in >> word;) act.words.push_back(word);
  act.rest = act.after(0);
  return act;
}

// The first argument that should be a number and is not, or is out of range; empty if there is none.
std::string wrongNumber(const Act& a) {
  for (const Numbers& n : kNumbers) {
    if (n.verb != a.verb) continue;
    for (std::size_t k = n.first; k < std::min(a.words.size(), n.first + n.count); ++k) {
      if (a.words[k] == "right" && k + 1 == a.words.size()) continue;
      const std::optional<double> value = numberOf(a.words[k]);
      if (!value || !(*value >= n.min && *value <= n.max))
        return "'" + a.words[k] + "' is no number from " + numberText(n.min) + " to " + numberText(n.max);
    }
  }
  return {};
}

// Runs a command. Returns why it failed, empty on success.
std::string perform(ScriptedUser& d, const Act& a) {
  if (std::string wrong = wrongNumber(a); !wrong.empty()) return wrong;
  const std::string absent = "'" + a.word(0) + "' is not on the screen";
  const int button = a.words.size() > 1 && a.words.back() == "right" ? 1 : 0;
  if (a.verb == "open")
    d.app().open(a.rest), d.app().finishLoading(), d.frames(3);
  else if (a.verb == "drop")
    d.app().drop({a.rest}), d.app().finishLoading(), d.frames(3);
  else if (a.verb == "size")
    d.resize(int(a.number(0, 1280)), int(a.number(1, 800)));
  else if (a.verb == "theme") {
    const std::optional<ThemeChoice> theme = themeNamed(a.rest);
    if (!theme) return "there is no theme '" + a.rest + "'";
    d.app().settings.theme = *theme;
    d.frames(3);
  } else if (a.verb == "scale")
    d.app().settings.scale = a.number(0, 1.0), d.frames(3);
  else if (a.verb == "text-size")
    d.app().settings.text_size = a.number(0, 1.0), d.frames(3);
  else if (a.verb == "click")
    return d.click(a.word(0), button) ? "" : absent;
  else if (a.verb == "drag")
    return d.drag(a.word(0), a.number(1, 0), a.number(2, 0), button) ? "" : absent;
  else if (a.verb == "point")
    return d.point(a.word(0), a.number(1, 0.5), a.number(2, 0.5)) ? "" : absent;
  else if (a.verb == "press")
    d.press(button);
  else if (a.verb == "release")
    d.release(button);
  else if (a.verb == "wheel")
    d.wheel(a.number(0, 1));
  else if (a.verb == "key")
    return d.tap(a.rest) ? "" : "there is no key '" + a.rest + "'";
  else if (a.verb == "hold")
    return d.hold(a.rest) ? "" : "there is no key '" + a.rest + "'";
  else if (a.verb == "let-go")
    return d.letGo(a.rest) ? "" : "there is no key '" + a.rest + "'";
  else if (a.verb == "type")
    d.type(a.rest);
  else if (a.verb == "plug") {
    SimulatedDevice* stylus = dynamic_cast<SimulatedDevice*>(d.app().scene.servo().loop().device());
    if (!stylus) return "the simulated stylus is not in use";
    stylus->plug(a.rest == "in");
    d.frames(1);
  } else if (a.verb == "sound")
    d.app().settings.sound = a.rest == "on", d.frames(1);
  else if (a.verb == "heard") {
    if (const std::optional<Problem> problem =
            writeWav(a.rest, d.app().extensions().touch_sound.heard(), kSamples_per_s))
      return problem->text();
  } else if (a.verb == "wait")
    d.frames(int(a.number(0, 1)));
  else if (a.verb == "expect") {
    if (!d.shows(a.word(0))) return absent;
    if (d.text(a.word(0)).find(a.after(1)) == std::string::npos)
      return "'" + a.word(0) + "' says '" + d.text(a.word(0)) + "' and not '" + a.after(1) + "'";
  } else if (a.verb == "expect-not") {
    if (d.text(a.word(0)).find(a.after(1)) != std::string::npos)
      return "'" + a.word(0) + "' says '" + d.text(a.word(0)) + "'";
  } else if (a.verb == "picture") {
    if (const std::optional<Problem> problem = writePng(a.rest, d.picture())) return problem->text();
  } else {
    return "there is no act '" + a.verb + "'";
  }
  return {};
}

}  // namespace

std::optional<Problem> ScriptedUser::run(const std::string& script, const std::string& file) {
  std::istringstream in(script);
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    const Act act = parse(line);
    if (act.verb.empty()) continue;
    if (std::string why = perform(*this, act); !why.empty()) return Problem{file, number, 1, std::move(why), {}};
  }
  return std::nullopt;
}

}  // namespace moltact
