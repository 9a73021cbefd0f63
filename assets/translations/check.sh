#!/usr/bin/env bash
# Reports the translated share of each language, and lists each fault. Fails if a language in the file `complete` lacks a
# sentence or has one that was not reviewed after a change of the English (fuzzy). Also fails if placeholders or plural
# forms differ from the English, or moltact.pot from the sources.
# check.sh FOLDER checks the languages and the file `complete` of that folder instead.
set -uo pipefail
own=$(cd "$(dirname "$0")" && pwd)
cd "${1:-$own}" || exit 1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
status=0
"$own/update.sh" --check || status=1

# Prints the number of sentences that a file has.
count() { grep -cE '^msgid ' "$1" | awk '{ print ($1 > 0 ? $1 - 1 : 0) }'; }  # the first is the header

msgattrib --no-obsolete --no-wrap --output-file="$work/all" "$own/moltact.pot" || exit 1
all=$(count "$work/all")
complete=" $(grep -v '^#' complete | tr -s '[:space:]' ' ') "
for code in $complete; do
  [ -e "$code.po" ] || { echo "complete: there is no $code.po"; status=1; }
done
for po in *.po; do
  [ -e "$po" ] || continue
  code=${po%.po}
  msgfmt --check --output-file=/dev/null "$po" || status=1
  # A sentence of the sources that the file does not contain at all is untranslated too.
  msgmerge --quiet --no-fuzzy-matching --output-file="$work/merged" "$po" "$own/moltact.pot" || { status=1; continue; }
  msgattrib --no-obsolete --no-wrap --translated --no-fuzzy --force-po --output-file="$work/translated" "$work/merged"
  translated=$(count "$work/translated")
  echo "$code: $translated of $all sentences, $((100 * translated / all)) %"
  [[ $complete == *" $code "* ]] || continue
  msgattrib --no-obsolete --no-wrap --untranslated "$work/merged" | grep -E '^msg(ctxt|id|id_plural) ' | grep -v '^msgid ""$' |
    sed "s/^/$po: no text: /" >"$work/faults"
  msgattrib --no-obsolete --no-wrap --only-fuzzy "$po" | grep -E '^msgid ' | grep -v '^msgid ""$' |
    sed "s/^/$po: to be reviewed (fuzzy): /" >>"$work/faults"
  if [ -s "$work/faults" ]; then
    cat "$work/faults"
    status=1
  fi
done
exit $status
