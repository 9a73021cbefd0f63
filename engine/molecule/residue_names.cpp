// Codes and names according to the Chemical Component Dictionary of the wwPDB, with the customary short names.
#include "engine/molecule/residue_names.h"

#include <algorithm>
#include <array>

#include "engine/language/catalogue.h"

namespace moltact {
namespace {

struct Name {
  std::string_view code, name;
};

// By code, ascending.
constexpr std::array kNames{
    Name{"478", N_("amprenavir")},
    Name{"A", N_("adenine")},
    Name{"ACE", N_("acetyl cap")},
    Name{"ACT", N_("acetate")},
    Name{"ADP", "ADP"},
    Name{"AMP", "AMP"},
    Name{"AP5", "Ap5A"},
    Name{"ATP", "ATP"},
    Name{"BNZ", N_("benzene")},
    Name{"C", N_("cytosine")},
    Name{"CIT", N_("citrate")},
    Name{"CLR", N_("cholesterol")},
    Name{"CO2", N_("carbon dioxide")},
    Name{"COA", N_("coenzyme A")},
    Name{"DA", N_("adenine")},
    Name{"DAL", N_("D-alanine")},
    Name{"DC", N_("cytosine")},
    Name{"DG", N_("guanine")},
    Name{"DOD", N_("heavy water")},
    Name{"DPN", N_("D-phenylalanine")},
    Name{"DT", N_("thymine")},
    Name{"DU", N_("uracil")},
    Name{"EDO", N_("ethylene glycol")},
    Name{"FAD", "FAD"},
    Name{"FAT", N_("fatty acid")},
    Name{"FMN", "FMN"},
    Name{"G", N_("guanine")},
    Name{"GAL", N_("galactose")},
    Name{"GDP", "GDP"},
    Name{"GLC", N_("glucose")},
    Name{"GOL", N_("glycerol")},
    Name{"GTP", "GTP"},
    Name{"HEC", N_("haem")},
    Name{"HEM", N_("haem")},
    Name{"HOH", N_("water")},
    Name{"MAN", N_("mannose")},
    Name{"NAD", "NAD"},
    Name{"NAG", N_("N-acetylglucosamine")},
    Name{"NAP", "NADP"},
    Name{"NH2", N_("amino cap")},
    Name{"NO3", N_("nitrate")},
    Name{"OLA", N_("oleic acid")},
    Name{"PEG", N_("polyethylene glycol")},
    Name{"PLM", N_("palmitic acid")},
    Name{"PO4", N_("phosphate")},
    Name{"RET", N_("retinal")},
    Name{"SO4", N_("sulfate")},
    Name{"STE", N_("stearic acid")},
    Name{"U", N_("uracil")},
    Name{"WAT", N_("water")},
};
static_assert(std::is_sorted(kNames.begin(), kNames.end(),
                             [](const Name& a, const Name& b) { return a.code < b.code; }));

}  // namespace

std::string plainResidueName(std::string_view code) {
  const auto at = std::lower_bound(kNames.begin(), kNames.end(), code,
                                   [](const Name& name, std::string_view wanted) { return name.code < wanted; });
  return at != kNames.end() && at->code == code ? std::string(tr(at->name)) : std::string();
}

}  // namespace moltact
