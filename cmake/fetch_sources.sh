#!/bin/sh
# Unpacks the sources of Debian packages in this system's release: fetch_sources.sh FOLDER PACKAGE… Each package is
# unpacked to FOLDER/PACKAGE. apt keeps its lists in FOLDER/apt, so that the system's settings are not changed.
set -eu
folder=$1
shift
missing=
for package; do [ -d "$folder/$package" ] || missing="$missing $package"; done
[ -n "$missing" ] || exit 0
mkdir -p "$folder/apt/lists/partial" "$folder/apt/archives/partial"
cd "$folder"
here=$PWD
. /etc/os-release
mirror=$(sed -n 's/^URIs: *\([^ ]*\).*/\1/p; s/^deb *\(\[[^]]*\] *\)\{0,1\}\([^ ]*\).*/\2/p' \
  /etc/apt/sources.list.d/debian.sources /etc/apt/sources.list 2>/dev/null | grep -v security | head -n 1)
echo "deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg] ${mirror:-http://deb.debian.org/debian}" \
  "$VERSION_CODENAME main" > apt/sources.list
own() {
  command=$1
  shift
  "$command" -q -o Dir::Etc::sourcelist="$here/apt/sources.list" -o Dir::Etc::sourceparts=/dev/null \
    -o Dir::State::lists="$here/apt/lists" -o Dir::Cache="$here/apt" -o APT::Sandbox::User= "$@"
}
own apt-get update
for package in $missing; do
  rm -rf "apt/$package"
  mkdir "apt/$package"
  (
    cd "apt/$package"
    # Some mirrors lack Debian's part of a package; the upstream part is enough then.
    if own apt-get source --download-only "$package"; then
      dpkg-source --no-check -x ./*.dsc unpacked
    else
      own apt-get source --download-only --tar-only "$package"
      mkdir unpacked
      tar -xf ./*.orig.tar.* -C unpacked --strip-components=1
    fi
  )
  mv "apt/$package/unpacked" "$package"
  rm -rf "apt/$package"
done
