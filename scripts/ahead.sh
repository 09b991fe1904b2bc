# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# Sourced by test.sh: work for the parts to come while the tests of dev wait for clocks.
: "${root:?}" "${logs:?}"

# Builds, and clang-tidy: what wants a processor, and nothing depends on how long it takes. One process does it, one part
# after the other, in the time that no other process of this computer wants. It judges nothing: what it says of a part is in
# $logs/ahead-PART.log, and the part does the same again when its turn comes, finds most of it done, and says what is wrong.
ahead_pid=''
ahead_parts=''

# begin_ahead PART...: of these, those that there is such work for.
begin_ahead() {
    local part
    rm -f "$logs"/ahead-*
    for part in "$@"; do
        if [[ " tsan fuzz asan tidy " == *" $part "* ]]; then ahead_parts+=" $part"; fi
    done
    if [[ -z $ahead_parts ]]; then return; fi
    set -m # it gets a process group, which ends with us
    work_ahead &
    ahead_pid=$!
    set +m
    trap 'kill -- "-$ahead_pid" 2>/dev/null' EXIT
}

work_ahead() {
    local part
    chrt --idle --pid 0 "$BASHPID" || renice -n 19 -p "$BASHPID"
    for part in $ahead_parts; do
        case "$part" in
            tsan) configure_preset tsan "$root/build/tsan" && build "$root/build/tsan" threads_tests ;;
            asan) configure_preset asan "$root/build/asan" && build "$root/build/asan" ;;
            fuzz) build_fuzz ;;
            tidy) tidy_dev ;;
        esac &>"$logs/ahead-$part.log"
        : >"$logs/ahead-$part.done"
    done
} &>/dev/null

# await_ahead PART: until that process has come past this part; at once if it has nothing to do for it.
await_ahead() {
    if [[ " $ahead_parts " != *" $1 "* || -e $logs/ahead-$1.done ]]; then return; fi
    say "$1: waits for what was begun of it beside the tests before"
    while [[ ! -e $logs/ahead-$1.done ]] && kill -0 "$ahead_pid" 2>/dev/null; do sleep 0.2; done
}
