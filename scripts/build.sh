# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# Sourced by demo.sh and test.sh, which set `root` first.
: "${root:?}"
# What was compiled in another folder is known again; only its debug information names that folder.
export CCACHE_BASEDIR=$root CCACHE_NOHASHDIR=1 CCACHE_DEPEND=1

say() { printf '== %s\n' "$*" >&2; }
fail() { printf '%s: %s\n' "${0##*/}" "$*" >&2; exit 1; }

# configure_preset PRESET FOLDER [CMAKE ARGUMENTS...]: quiet unless it fails.
configure_preset() {
    local preset=$1 folder=$2 argument compiler='' compiler_before
    shift 2
    mkdir -p "$folder" || return 1
    if [[ ! -w $folder ]]; then
        printf '%s: cannot write to %s (made by another user?)\n' "${0##*/}" "$folder" >&2
        return 1
    fi
    local arguments=(--preset "$preset" -B "$folder" "$@")
    if command -v ccache >/dev/null; then arguments+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
    # Quicker than GCC with these sanitizers, and a second compiler's opinion.
    if [[ $preset == asan ]] && command -v clang++-14 >/dev/null; then
        compiler=clang++-14
        arguments+=("-DCMAKE_CXX_COMPILER=$compiler")
    fi
    for argument in "$@"; do
        if [[ $argument == -DCMAKE_CXX_COMPILER=* ]]; then compiler=${argument#*=}; fi
    done
    # Where seventy test programs are linked.
    if [[ " dev asan tsan " == *" $preset "* ]] && command -v ld.lld >/dev/null; then
        arguments+=(-DCMAKE_EXE_LINKER_FLAGS=-fuse-ld=lld)
    fi
    # A tree that was copied or moved brings a cache that CMake refuses, and with another compiler than before CMake
    # forgets all other options, the sanitizers too: start afresh.
    if [[ -f $folder/CMakeCache.txt ]]; then
        compiler_before=$(sed -n 's/^CMAKE_CXX_COMPILER:[A-Z]*=//p' "$folder/CMakeCache.txt")
        if ! grep -qxF "CMAKE_HOME_DIRECTORY:INTERNAL=$root" "$folder/CMakeCache.txt" ||
            [[ -n $compiler && ${compiler_before##*/} != "${compiler##*/}" ]]; then
            arguments+=(--fresh)
        fi
    fi
    if ! (cd "$root" && cmake "${arguments[@]}" >"$folder/configure.log" 2>&1); then
        cat "$folder/configure.log" >&2
        return 1
    fi
    if [[ " asan tsan fuzz " == *" $preset "* ]] && ! grep -q '^PSICARVE_SANITIZE:[A-Z]*=.' "$folder/CMakeCache.txt"; then
        printf '%s: %s has no sanitizer; remove that folder\n' "${0##*/}" "$folder" >&2
        return 1
    fi
}

# build FOLDER [TARGETS...]: everything, or only these.
build() {
    local folder=$1
    shift
    cmake --build "$folder" --parallel "$(nproc)" ${1+--target "$@"} >&2
}
