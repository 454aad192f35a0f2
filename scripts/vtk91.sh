#!/usr/bin/env bash
# Unpacks Debian's VTK 9.1 into build-vtk91/vtk, because its packages conflict with those of
# ParaView. The preset vtk91 uses it, and build-vtk91/vtk/bin/python3 can import it. Returns at once
# if VTK is there already.
#
#   scripts/vtk91.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

packages=(libvtk9.1 libvtk9.1-qt libvtk9-dev python3-vtk9 vtk9)
folder=$PWD/build-vtk91/vtk
if [[ -e "$folder/complete" ]]; then
  exit 0
fi
echo "Unpacking VTK 9.1 in $folder"
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
"$folder/bin/python3" -c 'import vtk; assert vtk.VTK_VERSION == "9.1.0", vtk.VTK_VERSION'
touch "$folder/complete"
