#include "engine/haptics/atom_chemistry.h"

#include <array>

#include "engine/language/catalogue.h"

namespace moltact {
namespace {

constexpr std::array kSources{
    ChargeSource{kNoCharges, N_("no charges")},
    ChargeSource{kFileCharges, N_("the partial charges in the molecule's file, if its format has them")},
    ChargeSource{
        kFormalCharges,
        N_("formal charges at pH 7, each shared evenly by the atoms that carry it: side chains and phosphates")},
};

}  // namespace

std::span<const ChargeSource> chargeSources() { return kSources; }

}  // namespace moltact
