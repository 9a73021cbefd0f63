#!/bin/sh
# Makes the library's real structures from the coordinate files of Debian 12 packages. Downloads the packages into a
# scratch folder without installing them.
#   from_packages.sh OUTPUT_FOLDER
# The ATOM, HETATM, TER, SSBOND, CONECT and CRYST1 records stay as the package has them; the header is ours.
set -eu
out=$(cd "$1" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
apt-get download freesasa r-cran-bio3d emboss-test pymol-data python-biopython-doc >&2

# take ID PACKAGE PATH TITLE CLASS DATE
take() {
  deb=$(ls "$2"_*.deb)
  version=$(dpkg-deb -f "$deb" Version)
  dpkg -x "$deb" "$2"
  upper=$(echo "$1" | tr '[:lower:]' '[:upper:]')
  {
    printf 'HEADER    %-40s%-12s%-4s\n' "$5" "$6" "$upper"
    printf 'TITLE     %s\n' "$4"
    printf 'REMARK   1 COORDINATES OF PDB ENTRY %s (CC0), FROM THE DEBIAN PACKAGE\n' "$upper"
    printf 'REMARK   1 %s %s, FILE %s\n' "$2" "$version" "$(basename "$3")"
    printf 'REMARK   1 KEPT UNCHANGED: ATOM, HETATM, TER, SSBOND, CONECT, CRYST1\n'
    printf 'REMARK   1 LEFT OUT: ALL OTHER RECORDS OF THE HEADER\n'
    grep -E '^(CRYST1|SSBOND)' "$2/$3" || true
    grep -E '^(ATOM  |HETATM|TER|CONECT)' "$2/$3"
    echo END
  } > "$out/$1.pdb"
}

# take_fibril ID PACKAGE PATH TITLE CLASS DATE: of a gzipped ensemble the first model, without hydrogens, and its sheets
take_fibril() {
  deb=$(ls "$2"_*.deb)
  version=$(dpkg-deb -f "$deb" Version)
  dpkg -x "$deb" "$2"
  upper=$(echo "$1" | tr '[:lower:]' '[:upper:]')
  {
    printf 'HEADER    %-40s%-12s%-4s\n' "$5" "$6" "$upper"
    printf 'TITLE     %s\n' "$4"
    printf 'REMARK   1 COORDINATES OF PDB ENTRY %s (CC0), FROM THE DEBIAN PACKAGE\n' "$upper"
    printf 'REMARK   1 %s %s, FILE %s\n' "$2" "$version" "$(basename "$3")"
    printf 'REMARK   1 KEPT UNCHANGED: SHEET, AND OF MODEL 1 ATOM AND TER\n'
    printf 'REMARK   1 LEFT OUT: HYDROGENS, THE OTHER MODELS, ALL OTHER RECORDS OF THE HEADER\n'
    zcat "$2/$3" | awk '
      /^SHEET / { print }
      /^MODEL / { ++model }
      model == 1 && /^ATOM  / && substr($0, 77, 2) != " H" { print }
      model == 1 && /^TER/ { print }'
    echo END
  } > "$out/$1.pdb"
}

take 1ubq freesasa usr/share/freesasa/test-data/1ubq.pdb "HUMAN UBIQUITIN" "CHROMOSOMAL PROTEIN" "02-JAN-87"
take 1hel r-cran-bio3d usr/lib/R/site-library/bio3d/examples/1hel.pdb "HEN EGG-WHITE LYSOZYME" "HYDROLASE(O-GLYCOSYL)" "10-JAN-92"
take 2hhb emboss-test usr/share/EMBOSS/test/data/structure/2hhb.ent "HUMAN DEOXYHAEMOGLOBIN" "OXYGEN TRANSPORT" "07-MAR-84"
take 1hpv pymol-data usr/share/pymol/data/tut/1hpv.pdb "HIV-1 PROTEASE WITH THE INHIBITOR AMPRENAVIR (VX-478)" "HYDROLASE (ACID PROTEINASE)" "18-NOV-94"
take_fibril 2beg python-biopython-doc usr/share/doc/python-biopython-doc/Tests/PDB/2BEG.pdb.gz "FIBRIL OF THE ALZHEIMER PEPTIDE, AMYLOID BETA 1-42" "PROTEIN FIBRIL" "24-OCT-05"
