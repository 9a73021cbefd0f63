#!/bin/sh
# The real window with an Omni, a stand-in, that gives force, ended from outside: by SIGINT, SIGTERM, SIGHUP, by its display server
# that dies, by SIGSEGV. In each case the last that the device is given is no force; where the end is in order the attempt is
# closed and the settings are kept. Arguments: the program, a lesson, the stand-in for libHD.so.
set -eu
export MOLTACT_LANGUAGE=en
program=$1 lesson=$2 stand_in=$3
work=$(mktemp -d)
server= pid=
trap 'kill $pid $server 2>/dev/null || true; [ -n "${KEEP-}" ] || rm -rf "$work"' EXIT
fail() { echo "$1: $2"; exit 1; }

# The attempt that is kept of the lesson; nothing where none has begun.
kept() { find "$place/data" "$place/config" \( -name '*.jsonl' -o -name '*.attempt*' \) -size +0 2>/dev/null | head -n 1; }

# What drives the motors at the end, and for how many ms it was not 0 after the time $2 (ns).
forces() {
  awk -v from="$2" '$2 == "on" { on = 1; next } $2 == "off" { on = 0; last = 0; next }
    { if (on && last > 0 && $1 > from) forced = ($1 - from) / 1e6; last = on ? $2 : 0 } END { printf "%s %.2f\n", last + 0, forced }' "$1"
}

for way in INT TERM HUP server SEGV; do
  place=$work/$way
  mkdir -p "$place"
  # A display number that is free.
  Xvfb -displayfd 3 -screen 0 1280x800x24 3>"$place/display" >/dev/null 2>&1 & server=$!
  for attempt in $(seq 100); do [ -s "$place/display" ] && break; sleep 0.1; done
  [ -s "$place/display" ] || fail "$way" "no display"
  env DISPLAY=":$(cat "$place/display")" XDG_CONFIG_HOME="$place/config" XDG_DATA_HOME="$place/data" HOME="$place" MOLTACT_LIBHD="$stand_in" \
    STAND_IN_ROOM_Z=45 STAND_IN_LOG="$place/closed" STAND_IN_FORCES="$place/forces" "$program" "$lesson" >"$place/out" 2>&1 & pid=$!
  pressed=
  for attempt in $(seq 600); do
    kill -0 $pid 2>/dev/null || fail "$way" "the program ended before it pressed: $(cat "$place/out")"
    if [ -s "$place/forces" ] && tail -n 1 "$place/forces" | awk '{ exit !($2 + 0 > 0.3) }' && [ -n "$(kept)" ]; then
      pressed=yes
      break
    fi
    sleep 0.1
  done
  [ -n "$pressed" ] || fail "$way" "it never pressed, or no attempt began: $(find "$place" -type f)"
  began=$(tail -n 1 "$place/forces")
  began=${began%% *}
  case $way in
    server) kill -KILL $server ;;
    *) kill -"$way" $pid ;;
  esac
  status=0
  wait $pid || status=$?
  pid=
  kill $server 2>/dev/null || true
  wait $server 2>/dev/null || true
  server=
  set -- $(forces "$place/forces" "$began")
  echo "$way: status $status, last force $1 N, forces for $2 ms"
  [ "$1" = 0 ] || fail "$way" "the last force is $1 N"
  [ "$(echo "$2" | awk '{ print ($1 < 1000) }')" = 1 ] || fail "$way" "there was force for $2 ms"
  case $way in
    SEGV) [ $status -eq 139 ] || fail "$way" "exit status $status"; continue ;;
    server) [ $status -ne 0 ] || fail "$way" "exit status $status" ;;
    *) [ $status -eq 0 ] || fail "$way" "exit status $status"
       grep -q ', 0 N at the stop' "$place/closed" || fail "$way" "the device was not closed" ;;
  esac
  attempt=$(kept)
  [ -n "$attempt" ] || fail "$way" "no attempt was kept: $(find "$place" -type f)"
  tail -n 1 "$attempt" | grep -q left || fail "$way" "the attempt was not closed: $(tail -n 1 "$attempt")"
  [ -n "$(find "$place/config" -name 'settings*')" ] || fail "$way" "no settings were kept"
done
