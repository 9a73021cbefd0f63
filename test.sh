#!/usr/bin/env bash
# Installs what is missing, builds Moltact and runs every test.
#   ./test.sh                   the release build
#   ./test.sh release asan tsan the builds of CMakePresets.json that are named
#   ./test.sh package           the Debian packages: made, judged, installed on a bare system, used, removed (tests/package)
#   ./test.sh web               the browser edition in headless Chromium (tests/web)
#   ./test.sh windows           the build for Windows, under Wine (tests/windows, docs/windows.md)
#   ./test.sh fuzz              every reader of files under libFuzzer, 20 s each (tests/fuzz)
set -eu
cd "$(dirname "$0")"
. .ci/setup.sh
install_missing
for preset in "${@:-release}"; do
  echo "== $preset ($SECONDS s)"
  [ "$preset" != fuzz ] || install_missing .ci/packages-fuzz
  if [ "$preset" = package ]; then
    install_missing .ci/packages-package
    make_package
    timeout 30m tests/package/run.sh build/package/*moltact*.deb
    continue
  fi
  if [ "$preset" = web ]; then
    install_missing .ci/packages-web
    build_preset web moltact_page
    build_preset web moltact_hip_path
    build_preset web moltact_energy_ticks
    [ -x build/release/moltact ] || build_preset release moltact
    echo "built ($SECONDS s)"
    timeout 45m python3 tests/web/run.py
    continue
  fi
  if [ "$preset" = windows ]; then
    install_missing .ci/packages-windows
    build_preset windows
    [ -x build/release/moltact ] || build_preset release moltact
    timeout 20m python3 tests/windows/run.py
    continue
  fi
  build_preset "$preset"
  echo "built ($SECONDS s)"
  ctest --preset "$preset" -j "$(nproc)"
done
echo "== done ($SECONDS s)"
