#!/bin/sh
# Regenerates the pictures of docs/pages.md and README.md off-screen. Run in the source folder: docs/pictures/draw_pages.sh [PROGRAM]
# The class's report is drawn where there is chromium; its class is the one that the tests make up.
set -eu
program=${1:-build/release/moltact}
pictures=docs/pictures
work=${TMPDIR:-/tmp}/moltact-pictures
rm -rf "$work"
mkdir "$work"
trap 'rm -rf "$work"' EXIT
export MOLTACT_HOME="$PWD"

for theme in light dark high-contrast; do
  sed "s/THEME/$theme/g" $pictures/pages.script > "$work/pages.script"
  "$program" --size 1280x800 --script "$work/pages.script"
done

"$program" 1ubq --screenshot $pictures/ubiquitin.png --size 1280x800 --script $pictures/ubiquitin.script

mkdir "$work/my lessons"
cp lessons/first-touch.md "$work/my lessons/grooves.md"
cp molecules/benzene.pdb "$work/my lessons/"
sed "s|PICTURES|$PWD/$pictures|" $pictures/file_pages.script > "$work/files.script"
full=$(realpath "$program")
(cd "$work/my lessons" && "$full" --size 1280x800 --script "$work/files.script")

"$program" --size 1280x800 --script $pictures/scene_pages.script

"$program" --size 1280x800 --attempts "$work/attempts" --script $pictures/attempt.script
cat > "$work/study.md" <<'LESSON'
---
title: A study
minutes: 5
goals: G
molecules: 1ubq
author: A
licence: L
---
## Without force
```scene
molecule: 1ubq
force: off
locked: force, probe, stiffness, show, method
```
In a study every student works under the same conditions. What the lesson locks is greyed out. See [what an aside is](#aside-what-an-aside-is).

```touch
reach: protein
say: Touch the protein.
```

## Aside: What an aside is
An aside lies beside the way: only a link leads to it, it does not count among the steps, and its one button leads back.
LESSON
sed 's/^force: off/force: offf/; s/#aside-what-an-aside-is/#asides/' "$work/study.md" > "$work/mistakes.md"
sed "s|ATTEMPT|$(ls "$work"/attempts/*.jsonl)|; s|LESSONS|$work|" $pictures/more_pages.script > "$work/more.script"
"$program" --size 1280x800 --script "$work/more.script"

if command -v chromium > /dev/null && [ -x build/release/test_results ]; then
  MOLTACT_CLASS_REPORT="$work/class" build/release/test_results -tc='a class of 24*' > /dev/null
  "$program" report "$work/class/attempts" --csv "$work/class.csv" --html "$work/class.html" > /dev/null
  chromium --headless --no-sandbox --disable-gpu --hide-scrollbars --user-data-dir="$work/browser" --window-size=1280,1700 \
    --screenshot="$pictures/class-report.png" "file://$work/class.html" 2> /dev/null
fi
