#!/usr/bin/env bash
# Runs the tests of the numerics with different kernels of OpenBLAS, which add in different orders:
# this finds tests that hold for one rounding only. Run it manually, after a build.
#
#   scripts/kernels.sh [KERNELS ...]      default: Haswell Prescott; others: SkylakeX, Cooperlake, Zen
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

failed=()
(($#)) || set -- Haswell Prescott
for kernels in "$@"; do
  echo "== $kernels"
  OPENBLAS_CORETYPE=$kernels build/bin/crossfieldNumericsTests --gtest_brief=1 || failed+=("$kernels")
done
if ((${#failed[@]})); then
  echo "Failed with: ${failed[*]}"
  exit 1
fi
