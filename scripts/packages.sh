#!/usr/bin/env bash
# Installs the packages of Debian 12 or 13 that building needs. Returns at once if none is missing.
#
#   scripts/packages.sh [--tests] [--package] [--all] [--update]
#
#   --tests    also what the tests of scripts/test.sh need
#   --package  also what scripts/deb.sh needs
#   --all      also what scripts/test.sh --all needs: plain VTK, the checked build, two kinds of tests
#   --update   updates the lists of packages even if no package is missing
set -euo pipefail

tests=no
package=no
all=no
update=no
for option in "$@"; do
  case $option in
    --tests) tests=yes ;;
    --package) package=yes ;;
    --all) tests=yes package=yes all=yes ;;
    --update) update=yes ;;
    *)
      echo "packages.sh: unknown option $option. Use --tests, --package, --all or --update." >&2
      exit 2
      ;;
  esac
done

if grep --quiet '^VERSION_ID="12"' /etc/os-release; then
  # Qt of ParaView; the last package is for the help pages of the plugin.
  qt=(libqt5opengl5-dev libqt5svg5-dev qtbase5-dev qttools5-dev qtxmlpatterns5-dev-tools)
  # A solver that reads our files, and the formatter of Rules.Format.
  of_release=(calculix-ccx clang-format-14)
else
  qt=(qt6-base-dev qt6-svg-dev qt6-tools-dev qt6-tools-dev-tools qt6-5compat-dev)
  of_release=() # Debian 13 has neither; the tests that need them are skipped
fi

packages=(
  # Compiler and tools.
  ccache cmake g++ ninja-build
  # Numerics: meshes, matrices, integers, network flows, sparse Cholesky factorisation, threads.
  libcgal-dev libeigen3-dev libglpk-dev liblemon-dev libopenblas-dev libsuitesparse-dev libtbb-dev
  # Drawings: XML, and models. Without Open CASCADE the build leaves out .step and .brep files.
  libexpat1-dev libocct-data-exchange-dev libocct-modeling-algorithms-dev
  # Without CGNS the build leaves out .cgns files.
  libcgns-dev
  # The program.
  libcli11-dev libdeflate-dev nlohmann-json3-dev
  # ParaView with its VTK and Python; Xvfb is the screen on which pictures are drawn.
  paraview paraview-dev python3-dev python3-numpy python3-paraview xauth xvfb
  # find_package(ParaView) looks for these; paraview-dev does not depend on them.
  libavcodec-dev libavformat-dev libdouble-conversion-dev libfreetype-dev libgdal-dev
  libgl2ps-dev libglew-dev libhdf5-openmpi-dev libswscale-dev libtheora-dev libutfcpp-dev "${qt[@]}"
)
if [[ $tests == yes ]]; then
  packages+=(
    libbenchmark-dev libgtest-dev "${of_release[@]}"
    # Readers of the files for solvers.
    cgns-convert gmsh openfoam python3-meshio
    # Readers of the recipe of the conda package.
    python3-jinja2 python3-yaml
    # For parameter studies, which run with mpirun.
    openmpi-bin python3-mpi4py
  )
fi
if [[ $package == yes ]]; then
  # cpack needs the first two; lintian checks what it has made.
  packages+=(dpkg-dev file lintian)
fi
if [[ $all == yes ]]; then
  packages+=(
    # find_package(VTK) looks for these in plain VTK, which scripts/vtk.sh unpacks; patchelf makes
    # its libraries find each other.
    libjsoncpp-dev patchelf
    # The checked build: sanitizers, libFuzzer, OpenMP, gcov and clang-tidy of clang.
    clang-14 clang-tidy-14 gcovr libclang-rt-14-dev libomp-14-dev llvm-14
    # Tests that only --all runs: memcheck.
    valgrind
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
    echo "Packages are missing and there is no sudo. As root, run this script again, or run" >&2
    echo "apt-get update && apt-get install ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi
# Waits while another program installs packages. Packages can be installed again, so dpkg need not
# flush each file to the disk.
apt=(env DEBIAN_FRONTEND=noninteractive apt-get --quiet --option DPkg::Lock::Timeout=600
  --option Dpkg::Options::=--force-unsafe-io)
"${as_root[@]}" "${apt[@]}" update
if [[ ${#missing[@]} -gt 0 ]]; then
  echo "Installing: ${missing[*]}"
  "${as_root[@]}" "${apt[@]}" install --yes --no-install-recommends "${missing[@]}"
fi
