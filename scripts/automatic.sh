#!/usr/bin/env bash
# Chooses singularities for the domains of tests, compares them with those of finer meshes and of random starts,
# draws them and writes the page docs/automatic.md, with pictures in docs/automatic/. It takes minutes.
#
#   scripts/build.sh && scripts/automatic.sh [FOLDER [NAME...]]
set -euo pipefail
exec "$(dirname "${BASH_SOURCE[0]}")/page.sh" automatic pvpython scripts/automatic.py scripts/pictures/draw_chosen.py "$@"
