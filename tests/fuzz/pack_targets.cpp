// Packs of lessons.
#include "engine/pack/pack_file.h"
#include "engine/pack/pack_name.h"
#include "tests/fuzz/target.h"

namespace moltact::fuzz {

void pack(std::string_view bytes) {
  const auto opened = PackFile::ofBytes("p.moltact", std::string(bytes));
  if (!opened) return mustBe(!opened.problem().message.empty() && !opened.problem().remedy.empty(), "a message");
  std::size_t whole = 0;
  bool lesson = false;
  for (const PackEntry& e : opened->entries()) {
    mustBe(packNameFault(e.name).empty(), "a name in the folder");
    mustBe(e.bytes <= kSmallUnpacked || e.bytes / kMaxPackRatio <= bytes.size(), "no bomb");
    lesson = lesson || e.name == opened->lesson();
    std::size_t read = 0;
    const auto fault = opened->read(e, [&](std::string_view piece) {
      read += piece.size();
      return std::optional<Problem>();
    });
    mustBe(read <= e.bytes && (fault || read == e.bytes), "as many bytes as were told");
    mustBe(!fault || !fault->message.empty(), "a message");
    whole += e.bytes;
  }
  mustBe(lesson, "a lesson");
  mustBe(whole <= kMaxUnpacked && opened->entries().size() <= kMaxPackEntries, "within the limits");
}

}  // namespace moltact::fuzz
