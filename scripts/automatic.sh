#!/usr/bin/env bash
# Chooses singularities for the domains of the tests, compares them with those on finer meshes and
# from random starts, draws them and writes the page docs/automatic.md, with pictures in
# docs/automatic/. Takes several minutes.
#
#   scripts/build.sh && scripts/automatic.sh [FOLDER [NAME...]]
set -euo pipefail
exec "$(dirname "${BASH_SOURCE[0]}")/page.sh" automatic pvpython scripts/automatic.py scripts/pictures/draw_chosen.py "$@"
