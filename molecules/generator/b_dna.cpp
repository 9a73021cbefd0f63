// B-DNA from fibre diffraction: S. Arnott and D. W. L. Hukins, Optimised parameters for A-DNA and B-DNA, Biochem.
// Biophys. Res. Commun. 47, 1504-1509 (1972), table 5: radius, angle and height of each atom of a nucleotide. The next
// nucleotide is rotated by 36 degrees and shifted by 3.38 A; the partner strand has angle and height negated. The table
// contains the phosphate that a nucleotide shares with its neighbour: its O1 is the neighbour's O3'.
#include <cmath>
#include <numbers>
#include <string_view>

#include "molecules/generator/pdb_writer.h"

namespace moltact::generator {
namespace {

constexpr double kTwist_deg = 36.0, kRise_A = 3.38;
constexpr std::string_view kSequence = "CGCGAATTCGCG";  // the Dickerson-Drew dodecamer, self-complementary

struct Place {
  const char* name;
  const char* element;
  double radius_A, angle_deg, height_A;
};

constexpr Place kPhosphate[] = {
    {"P", "P", 8.91, 95.2, 2.08}, {"OP1", "O", 10.20, 91.1, 1.86}, {"OP2", "O", 8.82, 103.3, 1.29}};
constexpr Place kSugar[] = {{"O5'", "O", 7.73, 88.0, 1.83},
                            {"C5'", "C", 7.70, 79.8, 2.77},
                            {"C4'", "C", 7.59, 69.9, 2.04},
                            {"O4'", "O", 6.22, 66.0, 1.83},
                            {"C3'", "C", 8.20, 69.9, 0.64},
                            // the neighbour's shared oxygen, one step back
                            {"O3'", "O", 8.75, 97.4 - kTwist_deg, 3.63 - kRise_A},
                            {"C2'", "C", 7.04, 73.2, -0.24},
                            {"C1'", "C", 5.86, 67.4, 0.47}};
constexpr Place kAdenine[] = {{"N9", "N", 4.63, 76.6, 0.42},  {"C8", "C", 4.84, 93.0, 0.50},
                              {"N7", "N", 3.95, 105.4, 0.43}, {"C5", "C", 2.74, 94.0, 0.28},
                              {"C6", "C", 1.41, 107.2, 0.15}, {"N6", "N", 1.83, 154.0, 0.14},
                              {"N1", "N", 0.86, 40.1, 0.03},  {"C2", "C", 2.17, 30.6, 0.04},
                              {"N3", "N", 3.24, 47.0, 0.16},  {"C4", "C", 3.33, 70.5, 0.28}};
constexpr Place kGuanine[] = {
    {"N9", "N", 4.63, 76.6, 0.42}, {"C8", "C", 4.82, 93.2, 0.50},  {"N7", "N", 3.92, 105.7, 0.42},
    {"C5", "C", 2.70, 94.0, 0.28}, {"C6", "C", 1.39, 109.3, 0.15}, {"O6", "O", 1.71, 154.6, 0.13},
    {"N1", "N", 0.92, 37.9, 0.03}, {"C2", "C", 2.28, 28.7, 0.03},  {"N2", "N", 3.01, 4.2, -0.10},
    {"N3", "N", 3.29, 46.7, 0.16}, {"C4", "C", 3.33, 70.3, 0.28}};
constexpr Place kCytosine[] = {{"N1", "N", 4.63, 76.6, 0.42},  {"C2", "C", 3.40, 67.4, 0.27},
                               {"O2", "O", 3.69, 47.9, 0.18},  {"N3", "N", 2.31, 83.9, 0.22},
                               {"C4", "C", 2.94, 110.0, 0.32}, {"N4", "N", 2.76, 136.6, 0.27},
                               {"C5", "C", 4.35, 107.0, 0.47}, {"C6", "C", 4.99, 92.2, 0.52}};
constexpr Place kThymine[] = {
    {"N1", "N", 4.63, 76.6, 0.42},  {"C2", "C", 3.42, 67.3, 0.27},  {"O2", "O", 3.64, 47.8, 0.18},
    {"N3", "N", 2.36, 85.2, 0.23},  {"C4", "C", 2.98, 111.9, 0.32}, {"O4", "O", 2.82, 136.3, 0.27},
    {"C5", "C", 4.38, 106.9, 0.47}, {"C7", "C", 5.40, 119.8, 0.58}, {"C6", "C", 5.01, 92.3, 0.52}};

struct Strand {
  char chain;
  double sign;  // -1 negates angle and height
};

struct Nucleotide {
  Strand strand;
  int number;  // in the chain, from 1
  char base;
  int step;  // position along the helix
};

template <std::size_t N>
void add(std::vector<MadeAtom>& out, const Place (&places)[N], const Nucleotide& n) {
  const double middle = (static_cast<double>(kSequence.size()) - 1) / 2;
  for (const Place& p : places) {
    const double angle = (n.strand.sign * p.angle_deg - n.step * kTwist_deg) * std::numbers::pi / 180;
    const double height = n.strand.sign * p.height_A - (n.step - middle) * kRise_A;
    out.push_back({p.name,
                   std::string("D") + n.base,
                   p.element,
                   n.strand.chain,
                   n.number,
                   {p.radius_A * std::cos(angle), p.radius_A * std::sin(angle), height}});
  }
}

void addNucleotide(std::vector<MadeAtom>& out, const Nucleotide& n) {
  if (n.number > 1) add(out, kPhosphate, n);  // a strand begins with the hydroxyl of its sugar
  add(out, kSugar, n);
  switch (n.base) {
    case 'A':
      add(out, kAdenine, n);
      break;
    case 'G':
      add(out, kGuanine, n);
      break;
    case 'C':
      add(out, kCytosine, n);
      break;
    default:
      add(out, kThymine, n);
      break;
  }
}

char partner(char base) { return base == 'A' ? 'T' : base == 'T' ? 'A' : base == 'G' ? 'C' : 'G'; }

}  // namespace

std::string makeBDna() {
  std::vector<MadeAtom> atoms;
  const int length = static_cast<int>(kSequence.size());
  for (int i = 0; i < length; ++i) addNucleotide(atoms, {{'A', 1.0}, i + 1, kSequence[static_cast<std::size_t>(i)], i});
  for (int i = 0; i < length; ++i) {
    const int step = length - 1 - i;
    addNucleotide(atoms, {{'B', -1.0}, i + 1, partner(kSequence[static_cast<std::size_t>(step)]), step});
  }
  return writePdb("B-DNA, 12 BASE PAIRS, CGCGAATTCGCG",
                  {"GEOMETRY OF THE FIBRE: S. ARNOTT, D. W. L. HUKINS,",
                   "BIOCHEM. BIOPHYS. RES. COMMUN. 47, 1504-1509 (1972), TABLE 5",
                   "36 DEGREES AND 3.38 A A BASE PAIR; NO HYDROGENS", "MADE BY MOLTACT_GENERATE_MOLECULES"},
                  atoms);
}

}  // namespace moltact::generator
