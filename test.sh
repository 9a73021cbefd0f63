#!/usr/bin/env bash
# Installs what is missing, builds Moltact and runs every test.
#   ./test.sh                   the release build
#   ./test.sh release asan tsan the builds of CMakePresets.json that are named
set -eu
cd "$(dirname "$0")"
. .ci/setup.sh
install_missing
for preset in "${@:-release}"; do
  echo "== $preset"
  build_preset "$preset"
  ctest --preset "$preset"
done
