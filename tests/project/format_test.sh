#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: format_test.sh ROOT WORK
# scripts/format.sh --staged in a repository of its own: what is staged decides, and a git that fails is no "all is well".
set -uo pipefail
source_root=$1
root=$2
failures=0

rm -rf "$root"
mkdir -p "$root/scripts"
cp "$source_root/scripts/format.sh" "$root/scripts/"
cp "$source_root/.clang-format" "$root/"
unset GIT_DIR GIT_INDEX_FILE GIT_WORK_TREE
cd "$root" || exit 1
git -c init.defaultBranch=main init -q .

# expect CODE WHAT
expect() {
    local code
    scripts/format.sh --staged >said 2>&1
    code=$?
    if ((code != $1)); then
        printf '%s: %d instead of %d\n' "$2" "$code" "$1"
        cat said
        failures=$((failures + 1))
    fi
}

expect 0 "nothing is staged"
printf 'int main() {\n    return 0;\n}\n' >good.cpp
git add good.cpp
expect 0 "what is staged is laid out"
printf 'int  f( ) {return 0 ;}\n' >good.cpp
expect 0 "what is in the folder is not what is staged"
git add good.cpp
expect 1 "what is staged is not laid out"
printf 'int main() {\n    return 0;\n}\n' >good.cpp
git add good.cpp
printf 'no index' >.git/index
expect 1 "git cannot read its index"
exit $((failures > 0))
