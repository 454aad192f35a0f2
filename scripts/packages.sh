#!/usr/bin/env bash
# Installs the Debian 12 packages that building and testing need. Quick when nothing is missing.
#
#   scripts/packages.sh [--all] [--update]
#
#   --all      also what scripts/test.sh --all needs: for VTK 9.1, the checked build, and two kinds of tests
#   --update   fetches the lists of packages in any case
set -euo pipefail

all=no
update=no
for option in "$@"; do
  case $option in
    --all) all=yes ;;
    --update) update=yes ;;
    *)
      echo "packages.sh does not know the option $option" >&2
      exit 2
      ;;
  esac
done

packages=(
  # Compiler and tools; Rules.Format needs this very version of clang-format.
  ccache clang-format-14 cmake g++ ninja-build
  # Numerics: meshes, matrices, integers, network flows, sparse Cholesky factorisation.
  libcgal-dev libeigen3-dev libglpk-dev liblemon-dev libopenblas-dev libsuitesparse-dev
  # Program and tests; Xvfb is the screen on which pictures are drawn.
  libbenchmark-dev libcli11-dev libdeflate-dev libgtest-dev nlohmann-json3-dev python3-numpy xauth xvfb
  # ParaView, its VTK and its Python.
  paraview paraview-dev python3-dev python3-paraview
  # find_package(ParaView) asks for these; paraview-dev does not depend on them.
  libavcodec-dev libavformat-dev libdouble-conversion-dev libfreetype-dev libgdal-dev
  libgl2ps-dev libglew-dev libhdf5-openmpi-dev libqt5opengl5-dev libqt5svg5-dev libswscale-dev
  libtheora-dev libutfcpp-dev qtbase5-dev qttools5-dev
  # openmpi-bin has mpirun, for parameter studies.
  openmpi-bin python3-mpi4py
  # The plugin's help pages are made with it.
  qtxmlpatterns5-dev-tools
)
if [[ $all == yes ]]; then
  packages+=(
    # What find_package(VTK) asks for in VTK 9.1, which scripts/vtk91.sh unpacks; patchelf makes its
    # libraries find each other.
    libjsoncpp-dev libtbb-dev patchelf
    # The checked build: sanitizers, libFuzzer, OpenMP, gcov and clang-tidy of clang.
    clang-14 clang-tidy-14 gcovr libclang-rt-14-dev libomp-14-dev llvm-14
    # Tests that only --all runs: the Debian package, which cpack makes with dpkg-dev and file; memcheck.
    dpkg-dev file valgrind
  )
fi

states=$(dpkg-query --show --showformat='${db:Status-Status} ${Package}\n' "${packages[@]}" \
  2>/dev/null || true)
missing=()
for package in "${packages[@]}"; do
  if ! grep --quiet --line-regexp --fixed-strings "installed $package" <<<"$states"; then
    missing+=("$package")
  fi
done
if [[ ${#missing[@]} -eq 0 && $update == no ]]; then
  exit 0
fi

as_root=()
if [[ $(id --user) -ne 0 ]]; then
  if ! command -v sudo >/dev/null; then
    echo "Become root and run this again, or 'apt-get update' and install: ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
# Waits when another program is installing packages.
apt=(env DEBIAN_FRONTEND=noninteractive apt-get --quiet --option DPkg::Lock::Timeout=600)
"${as_root[@]}" "${apt[@]}" update
if [[ ${#missing[@]} -gt 0 ]]; then
  echo "Installing: ${missing[*]}"
  "${as_root[@]}" "${apt[@]}" install --yes --no-install-recommends "${missing[@]}"
fi
