#include "engine/render/atom_style.h"

namespace moltact {
namespace {
constexpr Colour hex(std::uint32_t rgb) {
  return {float(rgb >> 16 & 255) / 255.0f, float(rgb >> 8 & 255) / 255.0f, float(rgb & 255) / 255.0f};
}
}  // namespace

Colour elementColour(std::uint8_t atomic_number) {
  switch (atomic_number) {
    case 1: return hex(0xF2F2EE);   // H
    case 2: case 10: case 18: case 36: case 54: return hex(0x9FE3E0);  // noble gases
    case 3: case 11: case 19: case 37: case 55: return hex(0xA06CE0);  // alkali metals
    case 4: case 12: case 20: case 38: case 56: return hex(0x5FA84A);  // alkaline earths
    case 5: return hex(0xF0B8A0);   // B
    case 6: return hex(0x9A9CA3);   // C
    case 7: return hex(0x4A6FE3);   // N
    case 8: return hex(0xE5483B);   // O
    case 9: return hex(0x8FD66B);   // F
    case 14: return hex(0xD9B98A);  // Si
    case 15: return hex(0xF28C28);  // P
    case 16: return hex(0xF2CC3A);  // S
    case 17: return hex(0x4CC94C);  // Cl
    case 25: return hex(0x9C7AC7);  // Mn
    case 26: return hex(0xD9692C);  // Fe
    case 27: return hex(0xE88FA6);  // Co
    case 28: return hex(0x62C07C);  // Ni
    case 29: return hex(0xC9803F);  // Cu
    case 30: return hex(0x8085B5);  // Zn
    case 34: return hex(0xF0A030);  // Se
    case 35: return hex(0xA8402F);  // Br
    case 53: return hex(0x8A3FB0);  // I
    default: return hex(0xCF9FCF);
  }
}

}  // namespace moltact
