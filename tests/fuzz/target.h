// The readers of external data, each as a function that must accept any bytes without a crash, an exception, a hang or
// an impossible value; likewise the exact body, with bytes as the path of the hand. libFuzzer (fuzz_one.cpp) and our own
// driver, which needs only a compiler (fuzz_all.cpp), run the same functions.
#pragma once

#include <cstddef>
#include <cstdio>
#include <cstdlib>
#include <span>
#include <string>
#include <string_view>

namespace moltact::fuzz {

struct Target {
  const char* name;  ///< also the name of its folder in seeds/
  void (*run)(std::string_view bytes);
};

std::span<const Target> targets();

/// Ends the program if a reader has accepted something impossible.
inline void mustBe(bool good, const char* what) {
  if (good) return;
  std::fprintf(stderr, "must be: %s\n", what);
  std::abort();
}

/// Decisions derived from bytes, to generate structured input that readers parse more deeply. After the last byte all
/// decisions are 0.
class Choices {
 public:
  explicit Choices(std::string_view bytes) : bytes_(bytes) {}
  bool more() const { return !bytes_.empty(); }
  /// A number from 0 to below - 1.
  std::size_t pick(std::size_t below) {
    std::size_t out = 0;
    for (std::size_t reach = 1; reach < below && more(); reach <<= 8) {
      out = out << 8 | static_cast<unsigned char>(bytes_.front());
      bytes_.remove_prefix(1);
    }
    return below ? out % below : 0;
  }
  std::string_view rest() const { return bytes_; }

 private:
  std::string_view bytes_;
};

/// Texts in place of a number: unusual ones, and ones that are almost numbers.
std::string_view oddNumber(Choices& choices);

/// A file with these bytes for readers of files, the same one each time. In memory where the system allows.
std::string fileOf(std::string_view bytes, const char* name);

void pdb(std::string_view), mmcif(std::string_view), smallCif(std::string_view), sdf(std::string_view);
void mol2(std::string_view), pqr(std::string_view), pdbqt(std::string_view), gro(std::string_view),
    xyzr(std::string_view), gzip(std::string_view);
void gridMap(std::string_view);
void dcd(std::string_view bytes);
void xtc(std::string_view bytes);
void trr(std::string_view bytes);
void models(std::string_view bytes);
void anyMolecule(std::string_view), structure(std::string_view);
void lesson(std::string_view), selection(std::string_view), answers(std::string_view);
void glossary(std::string_view), lessonPicture(std::string_view), formula(std::string_view);
void attempt(std::string_view), attemptLines(std::string_view), suspended(std::string_view);
void recording(std::string_view), recordingState(std::string_view), handPath(std::string_view);
void hipPath(std::string_view), gltf(std::string_view), catalogue(std::string_view), settings(std::string_view);
void translations(std::string_view), reportStream(std::string_view);
void pack(std::string_view), bodyPath(std::string_view), imd(std::string_view);
void classRequests(std::string_view bytes);
void simulationMessage(std::string_view), modes(std::string_view);

}  // namespace moltact::fuzz
