#!/usr/bin/env bash
# Installs what is missing, builds Moltact and starts it; arguments go to the program.
#   ./run.sh                    opens the window
#   ./run.sh info 1ubq          a command without a window; ./run.sh --help lists them
#   ./run.sh web                builds the browser edition, build/web/moltact.html, and says where it is
#   ./run.sh package            makes the Debian packages and says where they are
#   ./run.sh windows            makes the installer and the zip for Windows and says where they are
set -eu
here=$PWD
cd "$(dirname "$0")"
root=$PWD
. .ci/setup.sh
install_missing >&2
if [ "${1:-}" = web ]; then
  install_missing .ci/packages-web >&2
  build_preset web >&2
  echo "$root/build/web/moltact.html"
  exit 0
fi
if [ "${1:-}" = package ]; then
  install_missing .ci/packages-package >&2
  make_package >&2
  ls "$root"/build/package/*moltact*.deb
  exit 0
fi
if [ "${1:-}" = windows ]; then
  install_missing .ci/packages-windows >&2
  rm -f build/windows/moltact-*-windows-x64*
  build_preset windows moltact_installer >&2
  ls "$root"/build/windows/moltact-*-windows-x64*
  exit 0
fi
[ -x build/release/moltact ] || echo "Building Moltact; the first time this takes a few minutes." >&2
targets=moltact
[ "${1:-}" = bench ] && targets="moltact moltact-bench"
for target in $targets; do
  if [ ! -x "build/release/$target" ] && [ -t 2 ]; then
    build_preset release "$target" >&2
  else
    build_log=$(build_preset release "$target" 2>&1) || { printf "%s\n" "$build_log" >&2; exit 1; }
  fi
done
cd "$here"
exec "$root/build/release/moltact" "$@"
