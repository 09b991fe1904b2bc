# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# Sourced by test.sh: work for the parts to come while tests wait for clocks.
: "${root:?}" "${logs:?}"

# What a part wants done ahead is a function, ahead_PART: a build, or clang-tidy, which want a processor, and nothing
# depends on how long they take. One process does it, one part
# after the other, in the time that no other process of this session wants (the kernel weighs SCHED_IDLE within a session,
# and sessions against each other by what they ask for). It judges nothing: what it says of a part is in
# $logs/ahead-PART.log. When a part's turn comes, it does the same again, whatever was done ahead of it, and says what is
# wrong.
ahead_pid=''
ahead_parts=''
ahead_patience_s=60

# begin_ahead PART...: of these, those that there is such work for.
begin_ahead() {
    local part
    ahead_parts=''
    for part in "$@"; do
        if ! declare -F "ahead_$part" >/dev/null; then continue; fi
        ahead_parts+=" $part"
        rm -f "$logs/ahead-$part".*
    done
    if [[ -z $ahead_parts ]]; then return; fi
    set -m # it gets a process group, which ends with us
    work_ahead &
    ahead_pid=$!
    set +m
    trap end_ahead EXIT
}

work_ahead() {
    local part
    chrt --idle --pid 0 "$BASHPID" || renice -n 19 -p "$BASHPID"
    for part in $ahead_parts; do
        "ahead_$part" &>"$logs/ahead-$part.log"
        : >"$logs/ahead-$part.done"
    done
} &>/dev/null

# end_ahead: ends that process and all that it has started, and comes back when they are gone; what they had finished
# stays. A process that does not go when asked is killed.
end_ahead() {
    local pid signal tries
    if [[ -z $ahead_pid ]]; then return; fi
    for signal in TERM KILL; do
        kill "-$signal" -- "-$ahead_pid" 2>/dev/null
        # That they need not wait for a processor to go; root alone may do so.
        for pid in $(pgrep -g "$ahead_pid"); do chrt --other --pid 0 "$pid"; done &>/dev/null
        for ((tries = 0; tries < ahead_patience_s * 10; ++tries)); do
            if ! lives_ahead "$ahead_pid"; then break 2; fi
            sleep 0.1
        done
    done
    wait "$ahead_pid" 2>/dev/null
    ahead_pid=''
}

# lives_ahead GROUP: whether a process of it is there that is more than a zombie, which some containers' first process never
# takes away.
lives_ahead() {
    ps -e -o pgid=,stat= | awk -v group="$1" '$1 == group && $2 !~ /^Z/ { lives = 1 } END { exit !lives }'
}

# take_over PART: this part's turn has come, and it does not wait for work at low priority that may take for ever beside
# other programs. Where that process is not past the part, it ends here and goes on with the parts after it.
take_over() {
    local part later=()
    if [[ " $ahead_parts " != *" $1 "* || -e $logs/ahead-$1.done ]]; then return; fi
    say "$1: takes over what was begun of it beside the tests before"
    end_ahead
    for part in $ahead_parts; do
        if [[ $part != "$1" && ! -e $logs/ahead-$part.done ]]; then later+=("$part"); fi
    done
    begin_ahead "${later[@]}"
}
