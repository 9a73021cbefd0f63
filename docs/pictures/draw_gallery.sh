#!/bin/sh
# Draws the pictures of docs/gallery.md by the commands that stand there. Run in the source folder:
# docs/pictures/draw_gallery.sh [PROGRAM]
set -eu
program=${1:-build/release/moltact}
trap 'rm -f capsid.cif' EXIT
tests/benchmarks/made_capsid.py > capsid.cif
sed -n 's/^    moltact //p' docs/gallery.md | while read -r line; do
  eval "\"$program\" $line"
done
