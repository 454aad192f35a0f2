#!/usr/bin/env bash
# Builds the Debian package of a build, installs it below a folder with a separate dpkg database,
# which leaves the system unchanged, uses every part of it, and removes it.
#
#   test_deb.sh BUILD FOLDER CONSUMER
set -euo pipefail
build=$1
folder=$2
consumer=$3
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
root=$folder/root

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

echo "== Build the package"
rm -rf "$folder"
mkdir -p "$root"/var/lib/dpkg/{info,updates,triggers} "$root/usr/bin"
touch "$root/var/lib/dpkg/status"
(cd "$build" && cpack -B "$folder/built" >"$folder/cpack.log" 2>&1) || fail "$(cat "$folder/cpack.log")"
deb=$(echo "$folder"/built/crossfield_*.deb)
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

echo "== The program"
"$root/usr/bin/crossfield" check builtin:square
"$root/usr/bin/crossfield" --paths | tee "$folder/paths"
plugin=$(sed -n 's/^plugin: //p' "$folder/paths")
[[ $plugin == "$root"/usr/* && -e $plugin ]] || fail "the program names the plugin $plugin"

echo "== The Python package"
PYTHONPATH=$root/usr/lib/python3/dist-packages /usr/bin/python3 -c '
import crossfield
field = crossfield.solve("builtin:disk", [(0, 0, 4, 0.2)])
assert field.report["converged"] and crossfield.__file__.startswith("'"$root"'"), crossfield.__file__'

echo "== The plugin, loaded by name; pvpython reads the list of plugins in its own folder"
cp "$(readlink --canonicalize /usr/bin/pvpython)" "$root/usr/bin/pvpython"
"$root/usr/bin/pvpython" "$here/use_plugin.py" "$root"
rm "$root/usr/bin/pvpython"

echo "== find_package(CrossField)"
cmake -S "$consumer" -B "$folder/consumer" "-DCMAKE_PREFIX_PATH=$root/usr" >"$folder/consumer.log" 2>&1 &&
  cmake --build "$folder/consumer" >>"$folder/consumer.log" 2>&1 || fail "$(cat "$folder/consumer.log")"
grep --fixed-strings "CrossField_DIR:PATH=$root/usr/" "$folder/consumer/CMakeCache.txt"
(cd "$folder" && consumer/example)

echo "== Remove the package"
"${dpkg[@]}" --remove crossfield >"$folder/remove.log" 2>&1 || fail "$(cat "$folder/remove.log")"
[[ ! -e $root/usr/lib && ! -e $root/usr/share ]] || fail "files remain after removal: $(find "$root/usr" -type f)"
