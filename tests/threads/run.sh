#!/usr/bin/env bash
# Compiles the parallel loops and the elimination with the thread sanitizer, and runs them in several threads:
#
#   tests/threads/run.sh FOLDER       FOLDER is for the object files
#
# TBB, CHOLMOD and OpenBLAS are not instrumented, so only accesses by this project are checked. Templates of TBB's headers
# are instrumented, but not the library that orders their accesses: reports in them are left out (suppressions.txt), and
# Parts.cxx repeats the order. Exits with 0 if there is no report, except of a race that is there on purpose.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
folder=$1
mkdir -p "$folder"
flags=(-std=c++17 -O1 -g -fPIC -fsanitize=thread -fopenmp -DEIGEN_DONT_PARALLELIZE -DNDEBUG -isystem /usr/include/eigen3
  -isystem /usr/include/suitesparse)
for module in base geometry mesh algebra; do
  flags+=("-Ifilters/numerics/$module")
done
sources=(tests/threads/ThreadRun.cxx filters/numerics/base/*.cxx filters/numerics/mesh/SymmetricAssembly.cxx
  filters/numerics/algebra/{Cholmod,Dense,Diss,Fact,Gram,Nested,Partial,Serial,Sparse}*.cxx)
objects=()
for source in "${sources[@]}"; do
  object=$folder/$(basename "$source").o
  objects+=("$object")
  clang++-14 "${flags[@]}" -c "$source" -o "$object" &
  [[ $(jobs -rp | wc -l) -lt 2 ]] || wait -n
done
wait
clang++-14 -fsanitize=thread -fopenmp "${objects[@]}" -o "$folder/threadRun" -lcholmod -lopenblas -ltbb \
  -Wl,-rpath,/usr/lib/llvm-14/lib
export OPENBLAS_NUM_THREADS=1
export TSAN_OPTIONS="ignore_noninstrumented_modules=1 halt_on_error=1 suppressions=tests/threads/suppressions.txt"
if "$folder/threadRun" race >"$folder/race.txt" 2>&1; then
  echo "A race is not reported." >&2
  exit 1
fi
"$folder/threadRun"
