#!/usr/bin/env bash
# Uses every part of an installed package: the program, its manual page, the Python package in both Pythons, the plugin
# by its name, and the library.
#
#   use_package.sh FOLDER CONSUMER [ROOT]
#
# FOLDER is for files, CONSUMER has the C++ example of README.md, and ROOT is where the package is installed, by default
# the system.
set -euo pipefail
folder=$1
consumer=$(realpath --canonicalize-missing "$2")
root=${3:-}
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
mkdir -p "$folder"
cd "$folder" # not where a source tree could be found

fail() {
  echo "FAILED: $*" >&2
  exit 1
}

if [[ -n $root ]]; then # otherwise the system must find everything
  export PATH=$root/usr/bin:$PATH PYTHONPATH=$root/usr/lib/python3/dist-packages
fi

echo "== The program"
[[ $(command -v crossfield) == "$root/usr/bin/crossfield" ]] || fail "the path finds $(command -v crossfield)"
crossfield check builtin:square
crossfield --paths | tee paths
plugin=$(sed -n 's/^plugin: //p' paths)
[[ $plugin == "$root"/usr/* && -e $plugin ]] || fail "the program names the plugin $plugin"

echo "== The manual page"
if [[ -e $root/usr/share/man/man1/crossfield.1.gz ]]; then # containers often leave out manual pages
  zgrep --quiet '^.B .*layers' "$root/usr/share/man/man1/crossfield.1.gz" || fail "the page has no options"
else
  echo "not installed"
fi

echo "== The Python package"
for python in /usr/bin/python3 pvpython; do
  "$python" -c '
import crossfield
field = crossfield.solve("builtin:disk", [(0, 0, 4, 0.2)])
assert field.report["converged"] and crossfield.__file__.startswith("'"$root"'/usr/"), crossfield.__file__
print(crossfield.__file__)'
done

echo "== The plugin, loaded by name"
in_share=$root/usr/share/paraview/plugins/CrossFieldPlugin/CrossFieldPlugin.so
if [[ -n $root && -e $in_share ]]; then
  echo "Skipped: the ParaView of Debian 13 looks for plugins in /usr/share only, not below $root."
else
  pvpython "$here/use_plugin.py" "$root/usr"
fi

echo "== find_package(CrossField)"
if [[ -e $consumer/CMakeLists.txt ]]; then
  cmake -S "$consumer" -B consumer "-DCMAKE_PREFIX_PATH=$root/usr" >consumer.log 2>&1 &&
    cmake --build consumer >>consumer.log 2>&1 || fail "$(cat consumer.log)"
  grep --fixed-strings "CrossField_DIR:PATH=$root/usr/" consumer/CMakeCache.txt
  consumer/example
else
  echo "Skipped: the build has no tests, and thus no C++ example."
fi
