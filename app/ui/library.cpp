#include "app/ui/library.h"

namespace moltact {
const std::vector<LibraryItem>& library() {
  static const std::vector<LibraryItem> kItems{{"1ubq", "Ubiquitin (1UBQ)", "/tmp/mol_debs/x/freesasa/usr/share/freesasa/test-data/1ubq.pdb"}, {"2hhb","Haemoglobin (2HHB)","/tmp/mol_debs/x/emboss-test/usr/share/EMBOSS/test/data/structure/2hhb.ent"}};
  return kItems;
}
const std::vector<LibraryItem>& lessons() { static const std::vector<LibraryItem> kItems; return kItems; }
}
