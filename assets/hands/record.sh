#!/bin/sh
# Regenerates the strokes of this folder: assets/hands/record.sh [PROGRAM], in the source folder. No person moves a hand
# here: a script moves the mouse's pointer over the program's own window, drawn off-screen, and the simulated stylus
# is moved by its scripted hand. What both do on the molecule is recorded by the program as any hand is.
set -eu
program=$(realpath "${1:-build/release/moltact}")
hands=$PWD/assets/hands
export MOLTACT_HOME="$PWD"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
export XDG_CONFIG_HOME="$work/config" XDG_PICTURES_DIR="$work" HOME="$work"

# The way from a to b with no jerk at either end, between the times t0 and t1.
ease='function ease(a, b, t0, t1, t,  u) { u = (t - t0) / (t1 - t0); u = u < 0 ? 0 : u > 1 ? 1 : u; return a + (b - a) * u * u * u * (10 - 15 * u + 6 * u * u) }'

# mouse NAME MOLECULE SECONDS X Y WHEEL STROKE: the place of the pointer in the view, 0 to 1, as awk expressions of the time t (s) and
# of the unsteadiness s (a slow wander and a tremor of 9 Hz); WHEEL: notches to push harder by after a second. The button is
# down from 0.3 s on, and up in the last 0.3 s.
mouse() {
  name=$1 molecule=$2 seconds=$3 x=$4 y=$5 wheel=$6
  {
    echo "wait 5"
    echo "point view $(awk "$ease BEGIN{t=0;s=0;sx=0;sy=0;print $x, $y}")"
    echo "wait 40"
    echo "key Ctrl+D"; echo "wait 5"
    echo "click device/record"; echo "wait 5"
    echo "click file/choose"; echo "wait 30"
    awk "$ease BEGIN{
      for (k = 0; k < $seconds * 60; ++k) {
        t = k / 60
        sx = 0.004 * sin(1.7 * t + 1) + 0.0012 * sin(56.5 * t); sy = 0.004 * sin(2.3 * t) + 0.0012 * sin(57.1 * t + 2)
        if (k == 18) print \"press\"
        if (k == int(60 * ($seconds - 0.3))) print \"release\"
        if (k == 60 && $wheel) print \"wheel $wheel\"
        print \"point view\", $x + sx, $y + sy
      }
    }"
    echo "key Ctrl+D"; echo "wait 3"
    echo "click device/record"; echo "wait 5"
  } > "$name.script"
  "$program" "$molecule" --size 1280x1300 --script "$name.script"
  recorded=$(ls -t ./*.recording | head -n 1)
  "$program" device path "$recorded" --out "$hands/$name.hand" --label "hand=a script that moves the mouse's pointer" --label "stroke=$7" --touching 0.1
  rm "$recorded"
}

# stylus NAME MOLECULE SECONDS STROKE
stylus() {
  "$program" device record simulated "$2" --out "$1.recording" --seconds "$3"
  "$program" device path "$1.recording" --out "$hands/$1.hand" --label "hand=the simulated stylus in its scripted hand" --label "stroke=$4" --touching 0.1
}

mouse mouse-across 1ubq 4.2 "ease(0.40, 0.60, 0.5, 3.7, t)" "0.50" 0 "one slow way across ubiquitin"
mouse mouse-circle b-dna 4.2 "0.5 + 0.05 * cos(3.2 * t)" "0.5 + 0.09 * sin(3.2 * t)" 0 "circles over the groove of DNA"
mouse mouse-zigzag 1hel 4.2 "ease(0.44, 0.56, 0.5, 3.7, t)" "0.5 + 0.07 * sin(6.5 * t)" 0 "up and down over lysozyme"
mouse mouse-flick alpha-helix 3.2 "ease(0.47, 0.53, 0.8, 1.0, t) + ease(0, -0.06, 1.6, 1.8, t) + ease(0, 0.04, 2.3, 2.4, t)" "0.45 + ease(0, 0.1, 2.3, 2.4, t)" 0 "three flicks on a helix"
mouse mouse-deep argon-triangle 3.2 "0.5 + 0.02 * sin(4 * t)" "0.5 + 0.03 * cos(2.5 * t)" 6 "pressed hard into a pit, and stirred"
stylus stylus-ubiquitin 1ubq 4 "in, along and out over ubiquitin"
stylus stylus-dna b-dna 4 "the same over DNA"
stylus stylus-helix alpha-helix 4 "the same over a helix"
stylus stylus-benzene benzene 4 "the same over benzene"
stylus stylus-pit argon-triangle 4 "the same over a pit"
