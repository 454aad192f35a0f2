#!/usr/bin/env bash
# Makes the Debian package of a build for ParaView, and checks it with lintian, whose errors fail. Builds first if there
# is no build. The package is for the release of Debian on which it is made.
#
#   scripts/deb.sh [--built] [--test] [--install] [BUILD [FOLDER]]
#
#   --built     uses the existing build, and does not install the packages that this needs
#   --test      also installs the package below a folder of its own, which leaves the system unchanged, uses
#               every part of it, and removes it
#   --install   also installs the package on this system
#   BUILD       the folder of the build, default build; the package is written to FOLDER, default BUILD
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

built=no
test=no
install=no
while [[ "${1:-}" == --* ]]; do
  case $1 in
    --built) built=yes ;;
    --test) test=yes ;;
    --install) install=yes ;;
    *)
      echo "deb.sh: unknown option $1. Use --built, --test or --install." >&2
      exit 2
      ;;
  esac
  shift
done
build=$(realpath --canonicalize-missing "${1:-build}")
folder=$(realpath --canonicalize-missing "${2:-$build}")

if [[ $built == no ]]; then
  scripts/packages.sh --package
  if [[ ! -e $build/CPackConfig.cmake && $build == "$PWD/build" ]]; then
    scripts/build.sh --without-tests
  fi
fi
if [[ ! -e $build/CPackConfig.cmake ]]; then
  echo "deb.sh: $build is no build for ParaView. Build it first, with scripts/build.sh." >&2
  exit 2
fi

# Older packages have other names and would stay.
mkdir -p "$folder"
rm -f "$folder"/crossfield_*.deb
log=$folder/cpack.log
if ! (cd "$build" && cpack -G DEB -B "$folder") >"$log" 2>&1; then
  cat "$log" >&2
  exit 1
fi
rm -r "$folder/_CPack_Packages" # a copy of all files
deb=$(echo "$folder"/crossfield_*.deb)

if command -v lintian >/dev/null; then
  # Root may run it, as in a container. What lintian must accept is in cmake/debian/lintian-overrides.
  lintian --allow-root --fail-on error --tag-display-limit 0 "$deb"
  echo "lintian found no errors."
else
  echo "lintian is missing, so the package was not checked. To install it: apt-get install lintian" >&2
fi
if [[ $test == yes ]]; then
  bash tests/package/test_deb.sh "$deb" "$build" "$folder/package-test"
fi
if [[ $install == yes ]]; then
  as_root=()
  if [[ $(id --user) -ne 0 ]]; then
    as_root=(sudo)
  fi
  "${as_root[@]}" apt-get --quiet install --yes --reinstall "$deb"
fi
echo "The package is $deb"
echo "To install it: apt-get install $deb"
