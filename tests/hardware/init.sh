#!/bin/busybox sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The one process of the guest: loads the port's drivers, carves through both kinds of port, while the clock is set to
# and fro, until the computer sleeps, until the core is killed, into an emergency stop and into a limit, and switches
# the machine off. Lines for the test begin with LAB.
B=/bin/busybox
$B mount -t devtmpfs dev /dev
$B mount -t proc proc /proc
$B mount -t sysfs sys /sys
$B mkdir -p /dev/shm
$B mount -t tmpfs tmp /dev/shm
export PATH=/bin LC_ALL=C
$B mkdir -p /etc
echo root:x:0:0:::/bin/false >/etc/passwd
echo carver:x:1000:1000:::/bin/false >>/etc/passwd
echo carver:x:1000: >/etc/group
say() { echo "LAB $*"; }
# quietly COMMAND...: what it says shows only if it fails.
quietly() { "$@" >/tmp/said 2>&1 || { say "failed $*"; $B cat /tmp/said; return 1; }; }

for module in parport parport_pc ppdev; do $B insmod /$module.ko || say "failed insmod $module"; done
say "kernel $($B uname -r) realtime $($B cat /sys/kernel/realtime) device $(echo /dev/parport*)"

# run PORT JOB PROFILE: a core on that port homes, carves the job until it is ready or in alarm, and ends in order.
run() {
    psicarve-rtcore --port "$1" --profile "$3" --capacity 100x20 &
    core=$!
    tries=0
    until psicarve status >/dev/null 2>&1; do
        tries=$((tries + 1))
        [ $tries -gt 50 ] && { say "failed no core on $1"; return; }
        $B sleep 0.1
    done
    quietly psicarve home && quietly psicarve publish "$2" && quietly psicarve start --carve
    state=carving
    while [ $state != ready ] && [ $state != alarm ]; do
        $B sleep 0.5
        state=$(psicarve status --json | $B sed -n 's/.*"state": *"\([a-z]*\)".*/\1/p' | $B head -n 1)
        [ -n "$state" ] || { say "failed status on $1"; state=alarm; }
    done
    say "end of run on $1: $state"
    psicarve status | $B sed 's/^/LAB status /'
    $B kill -TERM $core
    wait $core
    say "core on $1 ended $?"
}

# What the registers show, read past every driver: data, status, control, as numbers.
registers() { $B dd if=/dev/port bs=1 skip=$((0x378)) count=3 2>/dev/null | $B hexdump -v -e '3/1 "%u "'; }
# Status bit 3: by it the test says how far it is. This machine's sleep takes no time of the test's.
estop() { set -- $(registers); echo $(($2 & 8)); }
# Whether steps, drives and spindle are as /safe says: data, and the four lines of control.
is_safe() { set -- $(registers); [ "$1 $(($3 & 15))" = "$($B cat /safe)" ]; }
# This machine's own monotonic clock, which counts its instructions.
now_ns() { $B sed -n 's/^now at \([0-9]*\) nsecs$/\1/p' /proc/timer_list; }

# Sets the clock days and hours ahead and back, counted from the time at the start, until /tmp/clock_is_right is there.
set_clock_to_and_fro() {
    right_s=$($B date +%s)
    times=0
    until [ -e /tmp/clock_is_right ]; do
        for off_s in 432000 -3600 10800 -172800 0; do
            $B date -s "@$((right_s + off_s))" >/dev/null && times=$((times + 1))
            $B sleep 0.1
        done
    done
    say "clock was set $times times"
}

# Sends this machine to sleep (to memory, S3) while a core carves, until the alarm of its real-time clock, which is the
# host's: the test waits for as long.
sleep_while_it_carves() {
    until psicarve status 2>/dev/null | $B grep -q '^state  *carving'; do $B sleep 0.1; done
    $B sleep 1
    awake_ns=$(now_ns)
    alive_s=$($B cut -d. -f1 /proc/uptime)
    say "falls asleep"
    echo +15 >/sys/class/rtc/rtc0/wakealarm
    echo mem >/sys/power/state || say "failed to sleep"
    slept_s=$(($($B cut -d. -f1 /proc/uptime) - alive_s))
    say "slept $slept_s s, awake meanwhile $((($(now_ns) - awake_ns) / 1000000)) ms"
}

# theirs COMMAND...: psicarve, to the core of another user.
theirs() { psicarve "$@" --segment /carver --group carver; }

# kill_core PORT: kills a core that carves as another user than the root that started it; says how long its guard takes
# to switch the machine off and what the guard ends with; waits until the test has looked at the port.
kill_core() {
    psicarve-rtcore --port "$1" --profile /unsensed.toml --capacity 100x20 \
        --segment /carver --user carver --group carver &
    guard=$!
    until theirs status >/dev/null 2>&1; do $B sleep 0.1; done
    quietly theirs home && quietly theirs publish /long.psi && quietly theirs start --carve
    core=$(theirs status --json | $B sed -n 's/.*"core_pid": *\([0-9]*\).*/\1/p')
    [ "$core" != $guard ] || say "failed: the core is its own guard"
    # Started by root with every capability: what each thread of core and guard kept, and what goes on without.
    for process in core:$core guard:$guard; do
        for status in /proc/${process#*:}/task/*/status; do
            $B sed -n 's/^\(Cap[A-Z][a-z]*\|NoNewPrivs\):[^0-9]*\([0-9a-f]*\)$/\1=\2/p' "$status" |
                $B tr '\n' ' ' | $B sed "s/^/LAB rights of ${process%:*}: /"
            echo
            $B sed -n "s/^\([UG]id\):[^0-9]*/LAB \1 of ${process%:*}: /p" "$status"
        done
    done
    priority=$(theirs status --json | $B sed -n 's/.*"tick_priority": *\([0-9]*\).*/\1/p' | $B head -n 1)
    locked_kb=$($B sed -n 's/^VmLck:[^0-9]*\([0-9]*\) kB/\1/p' "/proc/$core/status")
    say "tick after that on $1: priority $priority, locked $locked_kb kB"
    $B sleep 1
    is_safe && say "failed: nothing to switch off on $1"
    before=$(now_ns)
    $B kill -KILL "$core"
    looks=0
    until is_safe || [ $looks -ge 500 ]; do looks=$((looks + 1)); done
    say "safe on $1 after $(($(now_ns) - before)) ns, looks in vain $looks"
    wait $guard
    ended=$?
    released=$(estop)
    say "killed core's guard on $1 ended $ended"
    while [ "$(estop)" = "$released" ]; do $B sleep 0.1; done
    say "port $1 was looked at"
    while [ "$(estop)" != "$released" ]; do $B sleep 0.1; done
}

say "begin ppdev"
set_clock_to_and_fro &
setter=$!
run ppdev:/dev/parport0 /job.psi /machine.toml
: >/tmp/clock_is_right
wait $setter
say "begin io"
run io:0x378 /job.psi /machine.toml
say "begin sleep"
sleep_while_it_carves &
run ppdev:/dev/parport0 /long.psi /unsensed.toml
say "begin kill"
kill_core ppdev:/dev/parport0
kill_core io:0x378
say "begin estop"
run ppdev:/dev/parport0 /long.psi /unsensed.toml
# Until the test has let go of the stop.
pressed=$(estop)
say "emergency stop is pressed: $pressed"
while [ "$(estop)" = "$pressed" ]; do $B sleep 0.1; done
say "begin limit"
run ppdev:/dev/parport0 /long.psi /unsensed.toml
say "begin refusals"
psicarve-rtcore --port io:0x2f8 --profile /machine.toml 2>&1 | $B sed 's/^/LAB refusal /'
psicarve-rtcore --port ppdev:/dev/parport0 --profile /machine.toml --segment /first &
first=$!
until psicarve status --segment /first >/dev/null 2>&1; do $B sleep 0.1; done
psicarve-rtcore --port ppdev:/dev/parport0 --profile /machine.toml --segment /second 2>&1 | $B sed 's/^/LAB second /'
psicarve-rtcore --port io:0x378 --profile /machine.toml --segment /second 2>&1 | $B sed 's/^/LAB third /'
$B kill -TERM $first
wait $first
say "over"
$B poweroff -f
