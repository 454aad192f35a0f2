#!/usr/bin/env bash
# Unpacks Debian's VTK into build-vtk/vtk, because its packages conflict with those of ParaView. The
# preset vtk uses it, and build-vtk/vtk/bin/python3 can import it. Returns at once if VTK is there
# already.
#
#   scripts/vtk.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

folder=$PWD/build-vtk/vtk
if [[ -e "$folder/complete" ]]; then
  exit 0
fi

# Prints the package with the libraries of Debian's VTK, for example libvtk9.1.
find_library() {
  apt-cache depends libvtk9-dev | sed -n 's/.*Depends: \(libvtk9\.[0-9]*\)$/\1/p'
}
library=$(find_library)
if [[ -z $library ]]; then # the lists of packages are missing
  scripts/packages.sh --update
  library=$(find_library)
fi
packages=("$library" "$library-qt" libvtk9-dev python3-vtk9 vtk9)
echo "Unpacking VTK ($library) in $folder"
rm -rf "$folder"
mkdir -p "$folder/packages"

download() {
  (cd "$folder/packages" && apt-get --quiet --quiet download "${packages[@]}")
}
# Missing or outdated lists of packages name files that the mirror does not have.
download || { scripts/packages.sh --update && download; }
for package in "$folder"/packages/*.deb; do
  dpkg-deb --extract "$package" "$folder"
done
rm -r "$folder/packages"

# Lets the libraries of VTK find each other without LD_LIBRARY_PATH.
libraries=$folder/usr/lib/x86_64-linux-gnu
find "$libraries" -maxdepth 1 -name 'lib*.so*' -type f -exec patchelf --set-rpath '$ORIGIN' {} +
# A Python environment that looks for modules here before it looks in the system.
/usr/bin/python3 -m venv --without-pip --system-site-packages "$folder"
site=$("$folder/bin/python3" -c 'import sysconfig; print(sysconfig.get_path("purelib"))')
ln -s "$folder/usr/lib/python3/dist-packages/"{vtk.py,vtkmodules} "$site"
version=$("$folder/bin/python3" -c 'import vtk; print(vtk.VTK_VERSION)')
if [[ libvtk$version != "$library".* ]]; then
  echo "vtk.sh: $folder/bin/python3 imports VTK $version instead of the one of $library." >&2
  exit 1
fi
touch "$folder/complete"
