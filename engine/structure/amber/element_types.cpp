#include "engine/structure/amber/element_types.h"

namespace moltact {

std::string_view elementType(int atomic_number, std::size_t neighbours) {
  switch (atomic_number) {
    case 1:
      return "H";
    case 6:
      return neighbours >= 4 ? "CT" : "C";
    case 7:
      return "N";
    case 8:
      return "O";
    case 15:
      return "P";
    case 16:
      return "S";
    default:
      return {};
  }
}

const AmberType* nobleGas(int atomic_number) {
  static constexpr AmberType kHelium{"He", 1.485f, 0.0218f}, kNeon{"Ne", 1.545f, 0.0839f}, kArgon{"Ar", 1.88f, 0.2846f},
      kKrypton{"Kr", 2.005f, 0.399f}, kXenon{"Xe", 2.18f, 0.561f};
  switch (atomic_number) {
    case 2:
      return &kHelium;
    case 10:
      return &kNeon;
    case 18:
      return &kArgon;
    case 36:
      return &kKrypton;
    case 54:
      return &kXenon;
    default:
      return nullptr;
  }
}

int ionCharge_e(int atomic_number) {
  switch (atomic_number) {
    case 3:
    case 11:
    case 19:
    case 37:
    case 55:
      return 1;
    case 12:
    case 20:
    case 30:
    case 38:
    case 48:
    case 56:
      return 2;
    case 9:
    case 17:
    case 35:
    case 53:
      return -1;
    default:
      return 0;
  }
}

}  // namespace moltact
