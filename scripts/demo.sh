#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# From a bare Debian 12 to a carved piece: installs what is missing, builds, carves on the simulated machine,
# verifies the pulses and draws what they made.
set -euo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)
folder="$root/build/demo"

usage() {
    cat <<END
usage: ${0##*/} [MODEL]

Installs the Debian packages that are missing, builds Psicarve (optimised, without tests) in build/demo,
carves MODEL (default: examples/figurine.stl) on the simulated machine, verifies its pulses against the job
and shows the report. The picture of the carved piece goes to build/demo/<model's name>.png.

Exit codes: 0 carved and verified; 1 installing or building failed; else those of psicarve carve.
END
}

case "${1-}" in
    -h | --help) usage; exit 0 ;;
    -*) printf '%s: unknown option %s\n' "${0##*/}" "$1" >&2; usage >&2; exit 2 ;;
esac
if (($# > 1)); then usage >&2; exit 2; fi
model=${1:-$root/examples/figurine.stl}
if [[ ! -f $model ]]; then
    printf '%s: no such file: %s\n' "${0##*/}" "$model" >&2
    exit 3
fi
model=$(realpath -- "$model")
name=$(basename -- "${model%.*}")

# shellcheck source=scripts/build.sh
source "$root/scripts/build.sh"

"$root/scripts/deps.sh" build || fail "some packages could not be installed"
say "building (the first time takes a few minutes)"
configure_preset headless "$folder" -DPSICARVE_TESTS=OFF || fail "CMake failed; its output is above"
build "$folder" || fail "the build failed; its output is above"

# A segment of its own: a machine that runs on this computer is not disturbed.
segment="/psicarve-demo-$$"
trap 'rm -f "/dev/shm$segment"' EXIT

say "carving ${model#"$root"/} on the simulated machine"
picture="$folder/$name.png"
rm -f -- "$picture"
status=0
"$folder/bin/psicarve" carve "$model" --segment "$segment" --picture "$picture" || status=$?
if [[ -f $picture ]]; then say "picture: $picture"; fi
if ((status != 0)); then say "psicarve carve ended with exit code $status"; fi
exit "$status"
