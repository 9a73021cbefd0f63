#!/usr/bin/env bash
# Installs the library in a folder of its own, builds docs/samples against it alone, runs them and checks what they print.
#   tests/library/run.sh BUILD_FOLDER C++_COMPILER
set -eu
here=$(cd "$(dirname "$0")/../.." && pwd)
build=$1 compiler=$2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "FAILED: $*" >&2; exit 1; }

cmake --install "$build" --component development --prefix "$work/prefix" >"$work/install.log" || fail "$(cat "$work/install.log")"
cp -r "$here/docs/samples" "$work/samples"
cmake -S "$work/samples" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER="$compiler" \
  -DCMAKE_PREFIX_PATH="$work/prefix" -DCMAKE_CXX_FLAGS="-Wall -Wextra -Werror" >"$work/configure.log" 2>&1 || fail "$(cat "$work/configure.log")"
cmake --build "$work/build" >"$work/build.log" 2>&1 || fail "$(cat "$work/build.log")"

# Every installed header stands alone, and names no file of this folder.
headers=$(cd "$work/prefix/include/moltact" && find . -name '*.h' | sed 's#^\./##')
[ "$(echo "$headers" | wc -l)" -ge 25 ] || fail "few headers: $headers"
for header in $headers; do
  echo "#include \"$header\"" | "$compiler" -std=c++20 -fsyntax-only -I "$work/prefix/include/moltact" -x c++ - || fail "$header does not stand alone"
done
! grep -rl "$here/" "$work/prefix/lib"/*/cmake "$work/prefix/lib/cmake" "$work/prefix/include" 2>/dev/null || fail "the package names the folder that it was built in"
for version in 0.1 0.1.0; do
  echo "cmake_minimum_required(VERSION 3.25)
project(wanted LANGUAGES CXX)
find_package(moltact $version REQUIRED)" >"$work/CMakeLists.txt"
  cmake -S "$work" -B "$work/version" -G Ninja -DCMAKE_PREFIX_PATH="$work/prefix" >"$work/version.log" 2>&1 || fail "$(cat "$work/version.log")"
done
sed -i 's/moltact 0.1.0/moltact 99/' "$work/CMakeLists.txt"
! cmake -S "$work" -B "$work/version" -G Ninja -DCMAKE_PREFIX_PATH="$work/prefix" >"$work/version.log" 2>&1 || fail "version 99 is found"

# One argon atom of radius 1.88 A and a probe of 1.4 A: the contact stays at z = 3.28 A, and 1.28 N push out at z = 2 A.
"$work/build/feel_a_path" "$here/molecules/argon.pdb" exact 0,0,6 0,0,2 >"$work/path"
[ "$(wc -l <"$work/path")" = 101 ] || fail "a path of 100 steps: $(cat "$work/path")"
[ "$(head -n 1 "$work/path")" = "0.000 0.000 6.000  0.000 0.000 6.000  0.000 0.000 0.000  -" ] || fail "outside: $(head -n 1 "$work/path")"
tail -n 1 "$work/path" | grep -q "^0.000 0.000 2.000  0.000 0.000 3.280  0.000 0.000 1.280  .*argon" || fail "inside: $(tail -n 1 "$work/path")"
! "$work/build/feel_a_path" "$here/molecules/argon.pdb" none 0,0,6 0,0,2 2>"$work/said" || fail "an unknown method is felt"
grep -q 'no method "none"' "$work/said" || fail "an unknown method: $(cat "$work/said")"
! "$work/build/feel_a_path" "$work/absent.pdb" exact 0,0,6 0,0,2 2>"$work/said" || fail "an absent file is felt"
grep -q 'absent.pdb' "$work/said" || fail "an absent file: $(cat "$work/said")"

"$work/build/time_a_method" "$here/molecules/1ubq.pdb" exact penalty >"$work/times"
[ "$(grep -c '^\(exact\|penalty\) .* [0-9.]* ns per tick, touching in 100.0 % of ticks$' "$work/times")" = 2 ] || fail "times: $(cat "$work/times")"

"$work/build/add_a_method" "$here/molecules/argon.pdb" >"$work/one"
grep -q '^touching in [1-9][0-9]* ticks, error of the contact 0.000 A rms$' "$work/one" || fail "the added method over one atom: $(cat "$work/one")"
"$work/build/add_a_method" "$here/molecules/argon-pair.pdb" >"$work/two"
grep -q '^touching in [1-9][0-9]* ticks, error of the contact 0\.[0-9]*[1-9][0-9]* A rms$' "$work/two" || fail "the added method over a crease: $(cat "$work/two")"
