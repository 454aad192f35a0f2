#!/usr/bin/env bash
# Builds everything and runs all tests; the exit status is that of the tests.
#
#   scripts/test.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/build.sh
ctest --test-dir build --output-on-failure --parallel 2
