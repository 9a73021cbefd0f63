#!/usr/bin/env bash
# Tries the Debian packages of Moltact: what Debian's own checkers say of them; the program unpacked under a prefix of its
# own; all installed, used by an ordinary user without and with a window, from Python and from C++, and removed, after
# which nothing of them is left.
#   tests/package/run.sh PACKAGE.deb… [PICTURE.png]    moltact and any of the others; the file for a picture of its window
# The first lines choose where it is installed, the first possibility of:
#   1. in a bare Debian that debootstrap made, in the folder BARE (default /var/tmp/moltact-bare-CODENAME, kept for the next time):
#      as root where debootstrap is installed. Nothing is there but what the package itself asks for: no compiler, no fonts.
#   2. on this system: as root where Moltact is not installed yet. It asks for nothing that building has not brought.
#   3. nowhere: the trial under a prefix of its own has to do.
set -eu
here=$(cd "$(dirname "$0")" && pwd)
package= python= library= simulation= picture=
for file; do
  case $(basename "$file") in
  moltact_*.deb) package=$(realpath "$file") ;;
  python3-moltact_*.deb) python=$(realpath "$file") ;;
  moltact-openmm_*.deb) simulation=$(realpath "$file") ;;
  libmoltact-dev_*.deb) library=$(realpath "$file") ;;
  *.png) picture=$file ;;
  *) echo "$file is no package of Moltact" >&2; exit 2 ;;
  esac
done
[ -n "$package" ] || { echo "the package moltact is missing" >&2; exit 2; }
work=$(mktemp -d)
chmod 755 "$work"
display_server=
bare=
finish() {
  [ -z "$display_server" ] || kill "$display_server" 2>/dev/null || true
  if [ -n "$bare" ]; then for folder in dev proc; do umount -l "$bare/$folder" 2>/dev/null || true; done; fi
  rm -rf "$work"
}
trap finish EXIT
fail() { echo "FAILED: $*" >&2; exit 1; }
step() { echo "-- $*"; }

step "what Debian's checkers say"
# All kinds except the experimental ones; package/linux/lintian-overrides lists accepted ones with their reasons.
# Words in the binaries are left out: a compiler or linker stores sentences in pieces, whose neighbours make accidental words.
lintian --fail-on error,warning,info,pedantic --display-info --pedantic --tag-display-limit 0 \
  --suppress-tags spelling-error-in-binary $package $python $library

step "the spelling of pages, lessons and messages"
project=$here/../..
spellintian "$project"/*.md "$project"/docs/*.md $(find "$project/lessons" -name '*.md' ! -name '*.??.md') "$project/assets/translations/moltact.pot" |
  grep -v -e '(duplicate word)' -e 'Lenth -> Length$' >"$work/spelling" || true  # R. V. Lenth is an author
[ ! -s "$work/spelling" ] || fail "$(cat "$work/spelling")"

step "under a prefix of its own"
dpkg -x "$package" "$work/apart"
apart=$work/apart/usr
desktop-file-validate "$apart"/share/applications/*.desktop
appstreamcli validate --no-net --explain "$apart"/share/metainfo/*.xml
mkdir -p "$work/mime/packages"
cp "$apart"/share/mime/packages/* "$work/mime/packages/"
XDG_DATA_HOME="$work" PKGSYSTEM_ENABLE_FSYNC=0 update-mime-database "$work/mime" 2>"$work/mime.log"
[ ! -s "$work/mime.log" ] || fail "update-mime-database: $(cat "$work/mime.log")"
man --warnings -E UTF-8 -l -Tutf8 -Z "$apart"/share/man/man1/moltact.1.gz >/dev/null 2>"$work/man.log" || fail "man(1) does not take the page"
[ ! -s "$work/man.log" ] || fail "the manual page: $(cat "$work/man.log")"
for command in $(env -i "$apart/bin/moltact" --help | sed -n '/^Subcommands:/,$s/^  \([a-z-]*\) .*/\1/p'); do
  zcat "$apart/share/man/man1/moltact.1.gz" | sed 's/\\-/-/g' | grep -q "^.SS \"moltact $command" || fail "the manual page leaves out $command"
done
bash "$here/completion_test.sh" "$apart/share/bash-completion/completions/moltact"
for part in $python $library $simulation; do dpkg -x "$part" "$work/apart"; done
if find "$apart" -type f \( -path '*/bin/*' -o -name '*.so' -o -name '*.a' -o -name '*.cmake' \) -exec strings -a {} + |
  grep -F "$(cd "$here/../.." && pwd)"; then fail "a package knows the folder that it was built in"; fi
# Moved, it finds its data still; nothing of the environment helps it.
mv "$apart" "$work/elsewhere"
cd /
[ "$(env -i "$work/elsewhere/bin/moltact" info 1ubq --json | grep -c '"atoms"')" = 1 ] || fail "info, under another prefix"
env -i "$work/elsewhere/bin/moltact" info 1ubq --language de | grep -q weggelassen || fail "German, under another prefix"

codename=$(. /etc/os-release && echo "$VERSION_CODENAME")
if [ "$(id -u)" != 0 ]; then
  echo "Not installed: that needs root. The package was tried under a prefix of its own alone."
  exit 0
elif command -v debootstrap >/dev/null; then
  bare=${BARE:-/var/tmp/moltact-bare-$codename}
elif dpkg-query -W -f '${Status}' moltact 2>/dev/null | grep -q 'ok installed'; then
  echo "Not installed: Moltact is on this system already. The package was tried under a prefix of its own alone."
  exit 0
fi

step "installed ${bare:+in a bare Debian ($codename) in $bare}${bare:-on this system}"
if [ -n "$bare" ]; then
  if [ ! -e "$bare/.ready" ]; then
    mirror=$(awk '/^URIs:/{print $2; exit} $1=="deb"{for(i=2;i<=NF;i++)if($i~/^http/){print $i; exit}}' \
      /etc/apt/sources.list.d/debian.sources /etc/apt/sources.list 2>/dev/null | head -n 1)
    [ -e "$bare/debootstrap" ] || [ ! -e "$bare" ] || [ -e "$bare/usr/bin/apt-get" ] || fail "$bare is no Debian; remove it"
    [ -e "$bare/usr/bin/apt-get" ] || debootstrap --variant=minbase "$codename" "$bare" "$mirror" >"$work/debootstrap.log" || fail "$(tail -n 5 "$work/debootstrap.log")"
    cp /etc/apt/apt.conf.d/*proxy* "$bare/etc/apt/apt.conf.d/" 2>/dev/null || true
    cp /etc/resolv.conf "$bare/etc/resolv.conf" 2>/dev/null || true
    touch "$bare/.ready"
  fi
  for folder in proc dev; do
    mountpoint -q "$bare/$folder" || { mount --rbind "/$folder" "$bare/$folder"; mount --make-rslave "$bare/$folder"; }
  done
  for part in package python library simulation; do
    [ -n "${!part}" ] || continue
    cp "${!part}" "$bare/var/tmp/$part.deb"
    printf -v "$part" %s "/var/tmp/$part.deb"
  done
  rm -rf "$bare/home/trial"
fi
root=${bare:-/}
chroot=$(command -v chroot)
home=/home/trial
[ -n "$bare" ] || home=$work/home
mkdir -p "$bare$home"
chown 65534:65534 "$bare$home"
# Run there, as root and as an ordinary user who may write to the home folder only.
as_root() {
  env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive ${http_proxy:+http_proxy="$http_proxy"} \
    ${https_proxy:+https_proxy="$https_proxy"} "$chroot" "$root" "$@"
}
as_user() {
  env -i PATH=/usr/bin:/bin LANG=C.UTF-8 HOME="$home" ${DISPLAY:+DISPLAY="$DISPLAY"} \
    "$chroot" --userspec=65534:65534 "$root" sh -c 'cd && exec "$@"' sh "$@"
}
# All files, and the folders of our name; caches are rebuilt by their owners (update-mime-database deletes none of chemical/).
files() {
  (cd "$root" && find etc usr opt srv home -xdev \( -path "${home#/}" -o -path usr/share/mime/chemical -o -name '*.cache' \) -prune -o \( ! -type d -o -iname '*moltact*' \) -print | sort)
}

if [ -n "$bare" ]; then
  as_root apt-get purge -y -qq moltact python3-moltact libmoltact-dev moltact-openmm >/dev/null 2>&1 || true
  as_root apt-get autoremove --purge -y -qq >/dev/null
  as_root apt-get update -qq
fi
files >"$work/before"
as_root apt-get install -y -qq --no-install-recommends "$package" >"$work/install.log" 2>&1 || fail "$(cat "$work/install.log")"
if [ -n "$bare" ]; then
  for tool in cc g++ cmake; do ! as_user sh -c "command -v $tool" || fail "a bare system has $tool"; done
fi

step "without a window"
as_user moltact --version
as_user moltact info 1ubq >"$work/info"
grep -q 'atoms' "$work/info" || fail "info: $(cat "$work/info")"
as_user moltact info 1ubq --language de | grep -q weggelassen || fail "info in German"
as_user moltact check /usr/share/moltact/lessons >"$work/check" || fail "check: $(cat "$work/check")"
as_user moltact render 1ubq --out "$home/render.png" --size 640x400 --hip 30,29,22
[ "$(identify -format '%wx%h' "$bare$home/render.png")" = 640x400 ] || fail "render: no picture of 640 x 400"
[ "$(identify -format '%k' "$bare$home/render.png")" -gt 500 ] || fail "render: an empty picture"
as_user moltact devices | grep -q mouse || fail "devices: no mouse"
as_user moltact bench feel --quick --methods exact >"$work/bench" || fail "bench: $(cat "$work/bench")"
grep -q exact "$work/bench" || fail "bench: no row of exact"
as_user moltact new-lesson trial --folder "$home" >/dev/null
as_user moltact pack "$home/trial.md" >/dev/null
[ -s "$bare$home/trial.moltact" ] || fail "pack wrote nothing"

step "in a window: the first lesson, by mouse"
# The X server is this system's; the bare one reaches it by its abstract socket.
Xvfb -displayfd 3 -screen 0 1280x800x24 -ac 3>"$work/display" >/dev/null 2>&1 & display_server=$!
for attempt in $(seq 100); do [ -s "$work/display" ] && break; sleep 0.1; done
[ -s "$work/display" ] || fail "no virtual X server"
export DISPLAY=:$(cat "$work/display")
as_user moltact /usr/share/moltact/lessons/first-touch.md 2>"$work/window.log" & program=$!
# colours_until LEAST: waits until the screen shows at least this many colours.
colours_until() {
  for attempt in $(seq 60); do
    kill -0 "$program" 2>/dev/null || fail "the program ended: $(cat "$work/window.log")"
    import -window root "$work/window.png"
    [ "$(identify -format '%k' "$work/window.png")" -gt "$1" ] && return
    sleep 1
  done
  fail "the window shows only $(identify -format '%k' "$work/window.png") colours"
}
colours_until 500
window=$(xdotool search --onlyvisible --name '^Moltact$' | head -n 1)
# Into the middle of the view, on to the atom; held, until the attempt has it.
xdotool mousemove 640 400
sleep 1
xdotool mousedown 1
attempts=$bare$home/.local/share/moltact/attempts
for attempt in $(seq 60); do grep -qs '"touch' "$attempts"/*.jsonl && break; sleep 0.5; done
xdotool mouseup 1
sleep 2
import -window root "$work/window.png"
[ -z "$picture" ] || cp "$work/window.png" "$picture"
xdotool key --window "$window" ctrl+q
wait "$program" || fail "Ctrl+Q did not end the program in order: $(cat "$work/window.log")"
[ "$(ls "$attempts" | wc -l)" = 1 ] || fail "no attempt was kept"

step "a report of that attempt"
as_user moltact report "$home/.local/share/moltact/attempts" --csv "$home/class.csv" --html "$home/class.html" >/dev/null
grep -q 'First touch' "$bare$home/class.csv" || fail "the table: $(cat "$bare$home/class.csv")"
[ "$(grep -c '' "$bare$home/class.csv")" = 2 ] || fail "the table has not two lines"
grep -q '</html>' "$bare$home/class.html" || fail "the page is not whole"

if [ -n "$python" ]; then
  step "from Python"
  as_root apt-get install -y -qq --no-install-recommends "$python" >"$work/install.log" 2>&1 || fail "$(cat "$work/install.log")"
  as_user python3 -c '
import moltact
felt = moltact.Tracker(moltact.load("argon")).feel([[0, 0, 6], [0, 0, 2]])
print(felt.forces[1], len(moltact.load("1ubq")))' >"$work/felt" || fail "the Python module"
  grep -q '1\.28.* 602$' "$work/felt" || fail "the Python module feels $(cat "$work/felt")"
  as_user python3 /usr/share/doc/python3-moltact/examples/feel_a_groove.py --save "" | grep -q '^major groove: ' || fail "the example in Python"
fi

if [ -n "$simulation" ]; then
  step "a simulation"
  as_user moltact simulate run alanine-dipeptide --ps 1 2>&1 | grep -q 'libopenmm' || fail "without OpenMM it does not say what is missing"
  as_root apt-get install -y -qq --no-install-recommends "$simulation" >"$work/install.log" 2>&1 || fail "$(cat "$work/install.log")"
  as_user moltact simulate run alanine-dipeptide --ps 1 | grep -q ' K$' || fail "the simulation"
fi

if [ -n "$library" ]; then
  step "from C++"
  # Counted as wanted by nobody, so that they leave with what they were installed for.
  as_root apt-get install -y -qq --no-install-recommends "$library" g++ cmake make >"$work/install.log" 2>&1 || fail "$(cat "$work/install.log")"
  [ -z "$bare" ] || as_root apt-mark auto g++ cmake make >/dev/null
  as_user cp -r /usr/share/doc/libmoltact-dev/examples samples
  as_user cmake -S samples -B samples/build >"$work/samples.log" 2>&1 || fail "$(cat "$work/samples.log")"
  as_user cmake --build samples/build >"$work/samples.log" 2>&1 || fail "$(cat "$work/samples.log")"
  as_user samples/build/feel_a_path /usr/share/moltact/molecules/argon.pdb exact 0,0,6 0,0,2 | grep -q ' 0.000 0.000 1.280  ' || fail "feel_a_path"
fi

step "removed"
as_root apt-get purge -y -qq moltact ${python:+python3-moltact} ${library:+libmoltact-dev} ${simulation:+moltact-openmm} >"$work/purge.log" 2>&1 || fail "$(cat "$work/purge.log")"
[ -z "$bare" ] || as_root apt-get autoremove --purge -y -qq >/dev/null
files >"$work/after"
left=$(comm -13 "$work/before" "$work/after")
[ -z "$left" ] || fail "left behind: $left"
lost=$(comm -23 "$work/before" "$work/after")
[ -z "$lost" ] || fail "taken away that was not its own: $lost"
left=$(grep -rlis moltact "$root"/usr/share/mime "$root"/usr/share/applications "$root"/var/lib/dpkg/info | head)
[ -z "$left" ] || fail "named still in: $left"
[ -n "$(ls "$attempts")" ] || fail "the user's results are gone"
echo "The packages are sound."
