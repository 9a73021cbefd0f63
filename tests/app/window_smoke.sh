#!/bin/sh
# The real window under a virtual X server: starts, accepts keys and the mouse, shows a picture, and interprets keys by their characters
# on a French keyboard, and ends with status 0.
# Arguments: the program, a molecule.
set -eu
export MOLTACT_LANGUAGE=en
program=$1 molecule=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export XDG_CONFIG_HOME="$work/config"
cat > "$work/inside.sh" <<'INSIDE'
set -eu
"$1" "$2" & pid=$!
window=
for attempt in $(seq 100); do
  window=$(xdotool search --onlyvisible --name '^Moltact$' 2>/dev/null | head -n 1 || true)
  [ -n "$window" ] && break
  kill -0 "$pid" || { echo "the program ended before its window was there"; exit 1; }
  sleep 0.2
done
[ -n "$window" ] || { echo "no window came"; kill "$pid"; exit 1; }
sleep 2
xdotool mousemove --window "$window" 500 400 mousedown 1
sleep 1
xdotool mouseup 1 key --window "$window" F1
sleep 1
xdotool key --window "$window" Escape
# A busy machine takes its time for the first pictures.
for attempt in $(seq 30); do
  import -window "$window" "$3/window.png"
  colours=$(identify -format '%k' "$3/window.png")
  [ "$colours" -gt 50 ] && break
  sleep 1
done
[ "$colours" -gt 50 ] || { echo "the window shows only $colours colours"; kill "$pid"; exit 1; }
# On AZERTY, A and Q are exchanged relative to a US keyboard.
setxkbmap fr
sleep 1
xdotool key --window "$window" ctrl+a
sleep 1
xdotool search --onlyvisible --name '^Moltact$' > /dev/null || { echo "on a French keyboard Ctrl+A ended the program"; exit 1; }
xdotool key --window "$window" ctrl+q
(sleep 60; kill "$pid") >/dev/null 2>&1 & late=$!
wait "$pid" || { echo "on a French keyboard Ctrl+Q did not end the program with status 0"; exit 1; }
kill "$late"
INSIDE
xvfb-run -a -s '-screen 0 1280x800x24' sh "$work/inside.sh" "$program" "$molecule" "$work"
