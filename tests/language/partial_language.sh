#!/usr/bin/env bash
# partial_language.sh SOURCES MOLTACT: a third language with 30 % of the sentences. The check passes and reports its share;
# it fails once the language is listed as complete or a placeholder is wrong; the program shows what is missing in English.
set -euo pipefail
source=$1 program=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "partial_language.sh: $1"; [ ! -e "$work/out" ] || tail -20 "$work/out"; exit 1; }
check() { "$source/assets/translations/check.sh" "$work/po" >"$work/out" 2>&1; }

# The first sentences get themselves in angle brackets as their translation, until 30 % have one. Among them is one of two
# that the program prints below; the other has none.
mkdir "$work/po"
cp "$source/assets/translations/de.po" "$source/assets/translations/complete" "$work/po"
msginit --locale=fr_FR.UTF-8 --no-translator --no-wrap --input="$source/assets/translations/moltact.pot" --output="$work/empty.po" 2>/dev/null
total=$(grep -c '^msgid ' "$work/empty.po")
awk -v wanted=$((total * 30 / 100)) 'BEGIN { RS = ""; ORS = "\n\n" }
  NR > 1 && !/msgid_plural/ && !/msgid "these are known/ && /\nmsgid "[^"]/ && !/\\n/ && (done < wanted - 1 || /msgid "there is no device/) {
    match($0, /\nmsgid "[^\n]*"/)
    text = substr($0, RSTART + 8, RLENGTH - 9)
    sub(/\nmsgstr ""$/, "")
    $0 = $0 "\nmsgstr \"<" text ">\""
    ++done
  }
  { print }' "$work/empty.po" >"$work/po/fr.po"

check || fail "a partial language does not pass"
grep -qE '^de: [0-9]+ of [0-9]+ sentences, 100 %$' "$work/out" || fail "the share of German is not 100 %"
grep -qE '^fr: [0-9]+ of [0-9]+ sentences, (29|30) %$' "$work/out" || fail "the share of the partial language is not 30 %"

echo fr >>"$work/po/complete"
check && fail "a partial language passes although it is listed as complete"
grep -q '^fr.po: no text: ' "$work/out" || fail "the missing sentences are not listed"
cp "$source/assets/translations/complete" "$work/po"

sed 's/^msgstr "<there is no device \\"{0}\\">"/msgstr "<there is no device \\"{7}\\">"/' "$work/po/fr.po" >"$work/wrong.po"
cmp -s "$work/wrong.po" "$work/po/fr.po" && fail "the sentence to be broken is not there"
mv "$work/po/fr.po" "$work/right.po"
mv "$work/wrong.po" "$work/po/fr.po"
check && fail "a wrong placeholder passes"
mv "$work/right.po" "$work/po/fr.po"

# The program takes the folder's languages; a home of links, so that all else is as it is.
mkdir -p "$work/home/translations"
ln -s "$source"/* "$work/home"
msgfmt --output-file="$work/home/translations/fr.mo" "$work/po/fr.po"
MOLTACT_HOME=$work/home "$program" --language fr device check phantom >"$work/out" 2>&1 && fail "there is a device of the name phantom"
grep -q '<there is no device "phantom">' "$work/out" || fail "a translated sentence is not shown"
grep -q 'these are known: ' "$work/out" || fail "an untranslated sentence is not shown in English"
grep -q '<these are known' "$work/out" && fail "the untranslated sentence is translated"
echo "$(grep -c . "$work/po/fr.po") lines of the partial language checked"
