#!/usr/bin/env bash
# Fails where one of our sources is not as .clang-format has it, and lists each. Version 14 alone judges: others format
# in other ways. Where it is not installed it says so and exits with 77, which ctest takes as skipped.
set -uo pipefail
cd "$(dirname "$0")/.."
format=
for name in clang-format-14 clang-format; do
  "$name" --version 2>/dev/null | grep -q 'version 14\.' && format=$name && break
done
if [ -z "$format" ]; then
  echo "left out: clang-format 14 is not installed (Debian 12: apt-get install clang-format-14)"
  exit 77
fi
# GNU xargs exits with 123 where a run failed and with more where one could not be made.
differ=$(find app assets docs engine molecules tests \( -name '*.h' -o -name '*.cpp' \) -print0 |
  xargs -0 -P "$(nproc)" -n 32 "$format" --dry-run -Werror 2>&1)
status=$?
[ $status = 0 ] && exit 0
files=$(printf '%s\n' "$differ" | sed -n 's/^\([^: ]*\):[0-9]*:[0-9]*: error: code should be clang-formatted.*/\1/p' | sort -u)
if [ -z "$files" ]; then
  printf '%s\n' "$differ"
else
  printf 'not as .clang-format has it:\n%s\nIn the project'"'"'s root: %s -i %s\n' "$files" "$format" "$(echo $files)"
fi
exit 1
