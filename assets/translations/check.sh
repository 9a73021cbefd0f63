#!/usr/bin/env bash
# Fails where a language lacks a text, has one that nobody has looked at since the English changed, or has other
# placeholders than the English; and where moltact.pot is not what the sources say. Lists each.
set -uo pipefail
cd "$(dirname "$0")"
status=0
./update.sh --check || status=1
for po in *.po; do
  msgfmt --check --output-file=/dev/null "$po" || status=1
  # What the sources say and the file does not have at all is untranslated too.
  msgmerge --quiet --no-fuzzy-matching --output-file=- "$po" moltact.pot |
    msgattrib --no-obsolete --no-wrap --untranslated - | grep -E '^msg(ctxt|id|id_plural) ' | grep -v '^msgid ""$' |
    sed "s/^/$po: no text: /" >"${TMPDIR:-/tmp}/moltact-untranslated.$$"
  msgattrib --no-obsolete --no-wrap --only-fuzzy "$po" | grep -E '^msgid ' | grep -v '^msgid ""$' |
    sed "s/^/$po: to be looked at anew (fuzzy): /" >>"${TMPDIR:-/tmp}/moltact-untranslated.$$"
  if [ -s "${TMPDIR:-/tmp}/moltact-untranslated.$$" ]; then
    cat "${TMPDIR:-/tmp}/moltact-untranslated.$$"
    status=1
  fi
  rm -f "${TMPDIR:-/tmp}/moltact-untranslated.$$"
done
exit $status
