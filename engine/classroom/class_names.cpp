#include "engine/classroom/class_names.h"

#include <utility>

#include "engine/core/printable.h"
#include "engine/core/random.h"
#include "engine/core/text.h"
#include "engine/core/utf8.h"
#include "engine/language/catalogue.h"

namespace moltact {
namespace {

std::vector<std::string> animalNames() {
  // Animals as names of students, separated by comma and blank. Each must be singular, friendly and different.
  const std::string_view all = tr(
      "Otter, Badger, Hedgehog, Squirrel, Beaver, Lynx, Marten, Hare, Fox, Deer, Ibex, Marmot, Dormouse, Mole, Shrew, "
      "Seal, Dolphin, Whale, Penguin, Puffin, Gannet, Heron, Stork, Crane, Swan, Kingfisher, Woodpecker, Owl, Falcon, "
      "Kestrel, Raven, Jay, Robin, Wren, Swift, Swallow, Lark, Finch, Plover, Ibis, Flamingo, Pelican, Toucan, Macaw, "
      "Tortoise, Gecko, Iguana, Chameleon, Newt, Frog, Salamander, Axolotl, Salmon, Trout, Pike, Perch, Ray, Seahorse, "
      "Octopus, Squid, Nautilus, Crab, Lobster, Mussel, Starfish, Coral, Bee, Bumblebee, Ladybird, Dragonfly, Cricket, "
      "Firefly, Butterfly, Moth, Beetle, Ant, Panda, Koala, Wombat, Kangaroo, Wallaby, Platypus, Echidna, Lemur, "
      "Gibbon, "
      "Tapir, Okapi, Giraffe, Zebra, Antelope, Gazelle, Bison, Yak, Alpaca, Llama, Camel, Elephant, Rhino, Armadillo, "
      "Sloth");
  std::vector<std::string> out;
  for (std::size_t at = 0; at < all.size();) {
    const std::size_t end = std::min(all.find(',', at), all.size());
    if (const std::string_view one = trimmed(all.substr(at, end - at)); !one.empty()) out.emplace_back(one);
    at = end + 1;
  }
  if (out.empty()) out.emplace_back("Otter");
  return out;
}

}  // namespace

std::string cleanName(std::string_view typed) {
  const std::string line = oneLine(typed);
  std::string out;
  std::size_t characters = 0;
  bool blank = false;
  for (std::string_view rest = trimmed(line); !rest.empty() && characters < kMaxNameCharacters;) {
    const std::size_t bytes = firstCodePoint(rest).bytes;
    const std::string_view one = rest.substr(0, bytes);
    rest.remove_prefix(bytes);
    if (one == " ") {
      blank = true;
      continue;
    }
    if (std::exchange(blank, false)) {
      out += ' ';
      ++characters;
    }
    out += one;
    ++characters;
  }
  return out;
}

NameBook::NameBook(std::uint64_t seed) : animals_(animalNames()) {
  for (std::size_t k = animals_.size(); k > 1; --k) std::swap(animals_[k - 1], animals_[nextRandom(seed) % k]);
}

void NameBook::mark(const std::string& name) { taken_.insert(lower(name)); }

std::string NameBook::take(std::string_view wanted) {
  std::string name = cleanName(wanted);
  if (name.empty()) {
    // The first animal that nobody has; after all of them, the first again with a number.
    for (std::size_t k = 0; k < animals_.size() && name.empty(); ++k) {
      const std::string& animal = animals_[next_++ % animals_.size()];
      if (!taken_.contains(lower(animal))) name = animal;
    }
    if (name.empty()) name = animals_[next_++ % animals_.size()];
  }
  std::string out = name;
  for (std::size_t number = 2; taken_.contains(lower(out)); ++number) out = name + ' ' + std::to_string(number);
  mark(out);
  return out;
}

}  // namespace moltact
