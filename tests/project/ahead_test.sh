#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: ahead_test.sh ROOT WORK
# Work for the parts to come (scripts/ahead.sh) with work that is none: it says that it began, and waits for a
# file, or for ever.
set -uo pipefail
source_root=$1
root=$2
logs=$root/logs
rm -rf "$root"
mkdir -p "$logs"
failures=0

say() { printf '%s\n' "$*" >>"$root/said"; }
for part in tsan fuzz asan tidy; do eval "ahead_$part() { work_on $part; }"; done
# work_on PART: takes until $root/go-PART is there; meanwhile a child of it is at work, too.
work_on() {
    if [[ -e $root/stubborn-$1 ]]; then trap '' TERM; fi
    printf '%s\n' "$BASHPID" >>"$root/began-$1"
    while [[ ! -e $root/go-$1 ]]; do sleep 0.05; done
}
# shellcheck source=scripts/ahead.sh
source "$source_root/scripts/ahead.sh"
ahead_patience_s=5
# What takes only what processors have to spare may wait for ever beside other tests; here its order is tried.
chrt() { :; }

expect() {
    if ! eval "$1"; then
        printf 'line %d: not so: %s\n' "${BASH_LINENO[0]}" "$1"
        failures=$((failures + 1))
    fi
}
comes_true() {
    local tries
    for ((tries = 0; tries < 600; ++tries)); do
        if eval "$1"; then return 0; fi
        sleep 0.05
    done
    printf 'line %d: never so: %s\n' "${BASH_LINENO[0]}" "$1"
    failures=$((failures + 1))
    return 1
}
is_gone() { [[ ! "$(ps -o stat= -p "$(tail -n 1 "$root/began-$1")")" =~ ^[^Z] ]]; }

# What is done is not done again, and nothing is ended for it.
touch "$root/go-tsan"
begin_ahead dev tsan fuzz asan tidy
comes_true '[[ -e $root/began-fuzz ]]'
worker=$ahead_pid
take_over tsan
expect '[[ $ahead_pid == "$worker" ]]'

# What is not done: its work ends with all its processes, and the parts after it are begun.
take_over fuzz
expect 'is_gone fuzz'
expect '! lives_ahead "$worker"'
expect '[[ $ahead_parts == " asan tidy" ]]'
comes_true '[[ -e $root/began-asan ]]'
expect '[[ $(wc -l <"$root/began-tsan") == 1 && $(wc -l <"$root/began-fuzz") == 1 ]]'

# A part that the work has not come to is taken out of it.
take_over tidy
expect '[[ $ahead_parts == " asan" && ! -e $root/began-tidy ]]'

# Once taken over it belongs to no other.
comes_true '[[ $(wc -l <"$root/began-asan") == 2 ]]'
worker=$ahead_pid
take_over tidy
expect '[[ $ahead_pid == "$worker" ]]'

# Also a process that does not go when asked.
touch "$root/stubborn-asan"
end_ahead
begin_ahead asan
comes_true '[[ $(wc -l <"$root/began-asan") == 3 ]]'
begin=$SECONDS
take_over asan
expect '((SECONDS - begin >= ahead_patience_s - 1))'
expect 'is_gone asan'
expect '[[ -z $ahead_pid && -z $ahead_parts ]]'

# It ends with us.
rm "$root/stubborn-asan"
(
    begin_ahead asan
    comes_true '[[ $(wc -l <"$root/began-asan") == 4 ]]'
) || failures=$((failures + 1))
expect 'is_gone asan'

exit $((failures > 0))
