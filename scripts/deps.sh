#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the Debian packages that are missing, and only these. docs/dependencies.md says why each is here.
#   scripts/deps.sh build    what building and carving need
#   scripts/deps.sh window   that, and what the operator's window needs
#   scripts/deps.sh package  that, and what makes Debian packages of it (packaging/build_packages.sh)
#   scripts/deps.sh test     that, and what the tests need besides
#   scripts/deps.sh bench    that, and what the benchmarks compare with
# With --list it prints the names and installs nothing.
set -euo pipefail

build_packages=(cmake ninja-build g++ libboost-dev libtomlplusplus-dev nlohmann-json3-dev libcli11-dev
    libxxhash-dev libzip-dev libexpat1-dev pkg-config libcairo2-dev libpolyclipping-dev
    libpng-dev libjpeg-dev libtiff-dev fonts-dejavu-core)
window_packages=(qt6-base-dev libqt6opengl6-dev libqcustomplot-dev qt6-l10n-tools qt6-translations-l10n)
package_packages=(debhelper fakeroot)
test_packages=(git ccache lld python3 python3-numpy python3-scipy libgtest-dev libgmock-dev sigrok-cli librecad-data libcgal-demo glmark2-data occt-misc clang-14 clang-format-14 clang-tidy-14
    libclang-rt-14-dev fonts-wqy-microhei fonts-noto-core xvfb openbox xdotool libgl1-mesa-dri
    qemu-system-x86 busybox-static cpio rt-tests systemd
    fish zsh man-db groff-base mandoc
    desktop-file-utils appstream shared-mime-info libglib2.0-bin lintian)
bench_packages=(libembree-dev admesh linuxcnc-uspace)

usage() { printf 'usage: %s build|window|package|test|bench [--list]\n' "${0##*/}"; }

if [[ ${1-} == --help ]]; then usage; exit 0; fi
case "${1-}" in
    build) wanted=("${build_packages[@]}") ;;
    window) wanted=("${build_packages[@]}" "${window_packages[@]}") ;;
    package) wanted=("${build_packages[@]}" "${window_packages[@]}" "${package_packages[@]}") ;;
    test) wanted=("${build_packages[@]}" "${window_packages[@]}" "${package_packages[@]}" "${test_packages[@]}") ;;
    bench) wanted=("${build_packages[@]}" "${window_packages[@]}" "${package_packages[@]}" "${test_packages[@]}" "${bench_packages[@]}") ;;
    *) usage >&2; exit 2 ;;
esac
case "${2-}" in
    '') ;;
    --list) printf '%s\n' "${wanted[@]}"; exit 0 ;;
    *) usage >&2; exit 2 ;;
esac

if ! command -v dpkg-query >/dev/null; then
    printf 'deps: not a Debian system; going on with what is here. Needed, by their Debian names: %s\n' \
        "${wanted[*]}" >&2
    exit 0
fi

# One query for all of them: a run with nothing to install costs a few milliseconds.
mapfile -t missing < <(
    dpkg-query --show --showformat '${db:Status-Status} ${Package}\n' "${wanted[@]}" 2>/dev/null |
        sed -n 's/^installed //p' | sort -u | comm -13 - <(printf '%s\n' "${wanted[@]}" | sort -u))
if ((${#missing[@]} == 0)); then exit 0; fi

as_root=()
if ((EUID != 0)); then
    if ! command -v sudo >/dev/null; then
        printf 'deps: missing packages, and neither root nor sudo to install them. As root, run:\n' >&2
        printf '    apt-get update && apt-get install -y --no-install-recommends %s\n' "${missing[*]}" >&2
        exit 1
    fi
    as_root=(sudo)
fi

log=$(mktemp)
trap 'rm -f "$log"' EXIT
apt() {
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq -o DPkg::Lock::Timeout=300 "$@" >>"$log" 2>&1
}
refresh_lists() { apt update || give_up; }
# Some images leave all of /usr/share/doc out; what the tests open there comes with a package.
wanted_docs=/usr/share/doc/libcgal-dev/data.tar.gz
install_missing() {
    apt install -y --no-install-recommends -o "Dpkg::Options::=--path-include=$wanted_docs" "${missing[@]}"
}
give_up() {
    cat "$log" >&2
    printf 'deps: apt-get failed; its output is above\n' >&2
    exit 1
}

printf 'deps: installing %s\n' "${missing[*]}" >&2
# A bare system has no package lists yet; others may hold lists so old that their files are gone.
known=$(apt-cache --quiet=2 --no-all-versions show "${missing[@]}" 2>/dev/null | grep -c '^Package:' || true)
if ((known < ${#missing[@]})); then
    refresh_lists
    install_missing || give_up
elif ! install_missing; then
    printf 'deps: trying once more with fresh package lists\n' >&2
    refresh_lists
    install_missing || give_up
fi
