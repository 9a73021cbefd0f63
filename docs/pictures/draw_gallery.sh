#!/bin/sh
# Draws the pictures of docs/gallery.md by the commands that stand there. Run in the source folder:
# docs/pictures/draw_gallery.sh [PROGRAM]
set -eu
program=${1:-build/release/moltact}
sed -n 's/^    moltact //p' docs/gallery.md | while read -r line; do
  eval "\"$program\" $line"
done
