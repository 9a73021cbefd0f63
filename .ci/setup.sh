# Functions of run.sh, test.sh and .ci/run: what is missing is installed, what has changed is built. Run from the project's root.

# install_missing [LIST]: installs the Debian packages of .ci/packages, or of another list, that are not there.
install_missing() {
  list=${1:-.ci/packages}
  command -v dpkg-query >/dev/null || {
    echo "This is not a Debian system: install what $list lists in your system's way, then run this again." >&2
    return 0
  }
  missing=
  for package in $(sed 's/#.*//' "$list"); do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing="$missing $package"
  done
  [ -z "$missing" ] && return 0
  as_root=
  if [ "$(id -u)" != 0 ]; then
    command -v sudo >/dev/null || {
      echo "These packages are missing:$missing" >&2
      echo "Install them as root: apt-get install$missing" >&2
      return 1
    }
    as_root=sudo
  fi
  echo "Installing:$missing"
  $as_root apt-get update -qq
  DEBIAN_FRONTEND=noninteractive $as_root ${as_root:+env DEBIAN_FRONTEND=noninteractive} \
    apt-get install -y -qq --no-install-recommends $missing >/dev/null
}

# build_preset PRESET [TARGET]: configures once, then builds what has changed.
build_preset() {
  [ -e "build/$1/build.ninja" ] || cmake --preset "$1" >/dev/null
  cmake --build --preset "$1" ${2:+--target "$2"}
}

# make_package: the Debian packages build/package/*moltact*.deb, and no older one beside them.
make_package() {
  build_preset package
  rm -rf build/package/*moltact*.deb build/package/_CPack_Packages
  cpack --preset package >build/package/cpack.log 2>&1 || { cat build/package/cpack.log; return 1; }
}
