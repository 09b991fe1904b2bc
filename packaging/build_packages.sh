#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the Debian packages psicarve-core, psicarve and psicarve-hmi.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)

usage() {
    cat <<'END'
usage: packaging/build_packages.sh [--from BUILD_FOLDER] [--output FOLDER]

Builds the tree as Debian builds, without tests, and leaves the packages in FOLDER (out/packages if not given).

  --from BUILD_FOLDER   packs what is built there already, and compresses it little: for tests
  --output FOLDER       where the packages go; made if it is not there

Needs what scripts/deps.sh package installs. Exit codes: 0 done; 1 something failed; 2 wrong usage.
END
}
fail() { printf 'build_packages.sh: %s\n' "$*" >&2; exit 1; }

built=
output=$root/out/packages
while (($#)); do
    case "$1" in
        --from | --output)
            if (($# < 2)) || [[ -z $2 ]]; then usage >&2; exit 2; fi
            if [[ $1 == --from ]]; then built=$(realpath -- "$2"); else output=$(realpath -m -- "$2"); fi
            shift 2
            ;;
        -h | --help) usage; exit 0 ;;
        *) printf 'build_packages.sh: unknown argument: %s\n' "$1" >&2; usage >&2; exit 2 ;;
    esac
done
command -v dpkg-buildpackage >/dev/null && command -v dh >/dev/null ||
    fail "dpkg-buildpackage or dh is not here: scripts/deps.sh package installs them"

version=$(sed -n 's/^project(psicarve VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")
day=$(sed -n 's/^set(PSICARVE_VERSION_DATE "\([0-9-]*\)").*/\1/p' "$root/packaging/CMakeLists.txt")
if [[ -z $version || -z $day ]]; then fail "no version in CMakeLists.txt, or no date of it in packaging/CMakeLists.txt"; fi
date=$(LC_ALL=C date --utc --rfc-email --date "$day")

if [[ -n $built ]]; then
    for program in psicarve psicarve-rtcore psicarve-hmi; do
        [[ -x $built/bin/$program ]] || fail "$built has no bin/$program: build it first, with the window"
    done
    if grep -q '^PSICARVE_SANITIZE:[A-Z]*=.' "$built/CMakeCache.txt"; then fail "$built has sanitizers: no build for others"; fi
    [[ -e $built/packaging/pages/man1/psicarve.1 ]] || fail "$built has no man pages: build its target pages"
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
tree=$work/psicarve-$version
mkdir "$tree"
# What is in git, as it stands in the work tree; from an archive of the sources, all of it.
list_files() {
    if git -C "$root" rev-parse --is-inside-work-tree &>/dev/null; then
        git -C "$root" ls-files -z --cached --others --exclude-standard
    else
        (cd "$root" && find . -path ./build -prune -o -path ./out -prune -o -type f -print0)
    fi
}
# Nothing else is asked for when all is built.
if [[ -z $built ]]; then
    list_files | (cd "$root" && xargs -0 sh -c 'for file; do if [ -e "$file" ]; then printf "%s\\0" "$file"; fi; done' sh) |
        tar -C "$root" --null --files-from=- -cf - | tar -C "$tree" -xf -
fi
cp -R "$root/packaging/debian" "$tree/debian"
sed -e "s/@VERSION@/$version/" -e "s/@DATE@/$date/" "$root/packaging/debian/changelog.in" >"$tree/debian/changelog"
rm "$tree/debian/changelog.in"

options=(--build=binary --no-sign)
if [[ -n $built ]]; then
    export PSICARVE_BUILT=$built DEB_BUILD_OPTIONS="${DEB_BUILD_OPTIONS:+$DEB_BUILD_OPTIONS }noautodbgsym"
    options+=(--no-check-builddeps --no-pre-clean)
fi
log=$work/log
if ! (cd "$tree" && dpkg-buildpackage "${options[@]}" >"$log" 2>&1); then
    cat "$log" >&2
    fail "dpkg-buildpackage failed; its output is above"
fi
mkdir -p "$output"
find "$work" -maxdepth 1 -type f \( -name '*.deb' -o -name '*.changes' -o -name '*.buildinfo' \) -exec mv -t "$output" {} +
find "$output" -maxdepth 1 -name "*_${version}_*.deb" | sort
