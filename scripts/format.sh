#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Lays out every C++ source that git knows, or only looks at it.
set -euo pipefail

usage() {
    cat <<END
usage: ${0##*/} [--check | --staged | --install]

Lays out all C++ sources as .clang-format says.

  --check    changes nothing, and says what is not laid out so
  --staged   the same for what is about to be committed, as it will be committed
  --install  lets git look before each commit (scripts/hooks/pre-commit)

Exit codes: 0 all is well; 1 something is not laid out, or git does not say what there is; 2 wrong usage.
END
}

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)
cd "$root"
git() { command git -c safe.directory='*' "$@"; }
if (($# > 1)); then usage >&2; exit 2; fi
case "${1-}" in
    -h | --help) usage; exit 0 ;;
    --install)
        git config core.hooksPath scripts/hooks
        printf 'git looks at the layout before each commit\n'
        exit 0
        ;;
    "" | --check | --staged) ;;
    *) printf '%s: unknown argument: %s\n' "${0##*/}" "$1" >&2; usage >&2; exit 2 ;;
esac
if ! command -v clang-format-14 >/dev/null; then
    printf '%s: clang-format-14 is missing: scripts/deps.sh test installs it\n' "${0##*/}" >&2
    exit 1
fi

if [[ ${1-} == --staged ]]; then
    verdict=0
    names=$(mktemp)
    trap 'rm -f "$names"' EXIT
    # Not into the loop at once: no command would see its failure there.
    git diff --cached --name-only --diff-filter=ACMR -z -- '*.cpp' '*.hpp' >"$names" || exit 1
    while IFS= read -r -d '' file; do
        # What is in the index, which is not always what is in the folder.
        if ! git show ":$file" | clang-format-14 --dry-run -Werror --assume-filename="$file"; then verdict=1; fi
    done <"$names"
    if ((verdict)); then printf 'scripts/format.sh lays them out; then git add them again\n' >&2; fi
    exit "$verdict"
fi
if ! git rev-parse --git-dir >/dev/null 2>&1; then
    printf '%s: not a git checkout, nothing to compare with\n' "${0##*/}" >&2
    exit 0
fi
if [[ ${1-} == --check ]]; then how=(--dry-run -Werror); else how=(-i); fi
# Both processors: a thousand files take their time.
git ls-files -z -c -o --exclude-standard -- '*.cpp' '*.hpp' | xargs -0 -r -n 64 -P "$(nproc)" clang-format-14 "${how[@]}"
