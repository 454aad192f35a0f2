#!/usr/bin/env bash
# Installs the Debian package that scripts/deb.sh has made of a build below a folder with a separate dpkg
# database, which leaves the system unchanged, uses every part of it, and removes it.
#
#   test_deb.sh PACKAGE.deb BUILD FOLDER
set -euo pipefail
deb=$1
build=$2
folder=$3
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$folder/root

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

rm -rf "$folder"
mkdir -p "$root"/var/lib/dpkg/{info,updates,triggers} "$root/usr/bin"
touch "$root/var/lib/dpkg/status"
dpkg-deb --info "$deb"

echo "== Files belong to root, only root may write them, and no path points into the build"
dpkg-deb --contents "$deb" >"$folder/contents"
! grep -v ' root/root ' "$folder/contents" || fail "files of other owners"
! grep -v ' \./usr/' "$folder/contents" || fail "files outside of /usr"
! grep -E '^[-d]....w|^[-d].......w' "$folder/contents" || fail "files that other users may write"
dpkg-deb --extract "$deb" "$folder/extracted"
while read -r file; do
  paths=$(readelf --dynamic "$file" 2>/dev/null | sed -nE 's/.*R(UN)?PATH.*\[(.*)\]/\2/p' || true)
  [[ -z $paths || $paths =~ ^\$ORIGIN[^:]*(:\$ORIGIN[^:]*)*$ ]] || fail "$file has the path $paths"
done < <(find "$folder/extracted" -type f)
! grep --recursive --files-with-matches --fixed-strings "$(dirname "$build")/" "$folder/extracted" \
  --include='*.cmake' --include='*.py' --include='*.xml' --include='*.conf' || fail "paths into the build folder"

echo "== Its dependencies can be installed here"
apt-get --quiet --simulate install "$deb" | grep '^Inst crossfield' || fail "apt-get cannot install its dependencies"

echo "== Install the package"
# A script of the package calls ldconfig, which would change the system. This replaces it.
mkdir "$folder/bin"
printf '#!/bin/sh\necho ldconfig\n' >"$folder/bin/ldconfig"
chmod +x "$folder/bin/ldconfig"
dpkg=(env PATH="$folder/bin:/usr/sbin:/sbin:$PATH" dpkg --root="$root" --force-not-root --force-depends
  --force-script-chrootless --no-triggers)
"${dpkg[@]}" --install "$deb" >"$folder/install.log" 2>&1 || fail "$(cat "$folder/install.log")"
grep --quiet '^ldconfig$' "$folder/install.log" || fail "the package does not call ldconfig"
[[ -z $("${dpkg[@]}" --verify crossfield) ]] || fail "files differ from their checksums"

# pvpython reads the list of plugins in its own folder.
cp "$(readlink --canonicalize /usr/bin/pvpython)" "$root/usr/bin/pvpython"
bash "$here/use_package.sh" "$folder" "$build/tests/install/example" "$root" || fail "the package cannot be used"
rm "$root/usr/bin/pvpython"

echo "== Remove the package"
"${dpkg[@]}" --remove crossfield >"$folder/remove.log" 2>&1 || fail "$(cat "$folder/remove.log")"
[[ ! -e $root/usr/lib && ! -e $root/usr/share ]] || fail "files remain after removal: $(find "$root/usr" -type f)"
