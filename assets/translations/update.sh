#!/usr/bin/env bash
# Collects the sentences of the sources into moltact.pot and brings every XX.po up to date with it. With --check it changes
# nothing and fails where moltact.pot is not what the sources say now.
set -euo pipefail
cd "$(dirname "$0")/../.."
export LC_ALL=C
into=$(mktemp -d)
trap 'rm -rf "$into"' EXIT

find engine app \( -name '*.cpp' -o -name '*.h' \) | sort >"$into/files"
# The titles of the molecules that come with the program are sentences too; they stand in a JSON file.
mkdir "$into/molecules"
sed -nE 's/.*"title": ("[^"]*").*/NC_("molecule", \1)/p' molecules/catalogue.json >"$into/molecules/catalogue.json"
echo molecules/catalogue.json >>"$into/files"
xgettext --directory="$into" --directory=. --files-from="$into/files" --language=C++ --from-code=UTF-8 --output="$into/raw.pot" \
  --keyword --keyword=tr --keyword=trc:1c,2 --keyword=trn:1,2 --keyword=trf --keyword=trcf:1c,2 --keyword=trnf:1,2 \
  --keyword=N_ --keyword=NC_:1c,2 --add-comments=Translators: --add-location=file --sort-by-file --width=110 \
  --package-name=moltact --msgid-bugs-address=moltact
# In C++ xgettext takes a per cent sign for a format and does not know the placeholders {0}, which msgfmt compares where
# they are named so. The date would make every run another file.
sed -e '1,4d; /^"POT-Creation-Date/d; s/charset=CHARSET/charset=UTF-8/' -e 's/^#, c-format$/#/' "$into/raw.pot" |
  awk 'BEGIN { RS = "" }
       { gsub(/\n#(\n|$)/, "\n") }
       NR > 1 && /\{[0-9]+\}/ { sub(/\nmsg(ctxt|id) /, "\n#, python-brace-format&") }
       { printf "%s%s\n", (NR > 1 ? "\n" : "# The sentences of Moltact.\n"), $0 }' >"$into/moltact.pot"

pot=assets/translations/moltact.pot
if [ "${1:-}" = --check ]; then
  # Versions of gettext break lines at other places.
  for each in "$pot" "$into/moltact.pot"; do
    msgcat --no-wrap --sort-output "$each" | sed '1,/^$/d' >"$into/$(basename "$each").$([ "$each" = "$pot" ] && echo kept || echo new)"
  done
  diff -u "$into/moltact.pot.kept" "$into/moltact.pot.new" >"$into/diff" && exit 0
  echo "$pot is not what the sources say now; run assets/translations/update.sh. It differs so:"
  head -60 "$into/diff"
  exit 1
fi
cp "$into/moltact.pot" "$pot"
for po in assets/translations/*.po; do
  msgmerge --quiet --update --backup=none --no-fuzzy-matching --width=110 --add-location=file "$po" "$pot"
  # What is no longer said is no longer kept.
  msgattrib --no-obsolete --width=110 --output-file="$po" "$po"
done
