#!/bin/busybox sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The one process of the guest: cyclictest, then the core while it carves through ppdev, for as many ticks of 50 us each, and the machine is off. Lines
# for the test begin with LAB.
B=/bin/busybox
$B mount -t devtmpfs dev /dev
$B mount -t proc proc /proc
$B mount -t sysfs sys /sys
$B mkdir -p /dev/shm
$B mount -t tmpfs tmp /dev/shm
export PATH=/bin LC_ALL=C
ticks=$($B cat /ticks)
say() { echo "LAB $*"; }
quietly() { "$@" >/tmp/said 2>&1 || { say "failed $*"; $B cat /tmp/said; return 1; }; }

for module in parport parport_pc ppdev; do $B insmod /$module.ko || say "failed insmod $module"; done
say "kernel $($B uname -r) realtime $($B cat /sys/kernel/realtime) ticks $ticks"
# Neither is throttled: both sleep most of the time.
say "begin cyclictest"
cyclictest --mlockall --priority=80 --interval=50 --threads=1 --loops="$ticks" --histogram=10000 --quiet >/tmp/cyclic || say "failed cyclictest"
$B sed -n 's/^\([0-9]\{6\}\) 0*\([1-9][0-9]*\)$/LAB theirs \1 \2/p' /tmp/cyclic

say "begin core"
psicarve-rtcore --port ppdev:/dev/parport0 --profile /machine.toml --capacity 100x20 --priority 80 --lateness /tmp/late.csv &
core=$!
until psicarve status >/dev/null 2>&1; do $B sleep 0.1; done
quietly psicarve home && quietly psicarve publish /long.psi && quietly psicarve start --carve
number() { psicarve status --json | $B sed -n "s/.*\"$1\": *\([0-9]*\).*/\1/p" | $B head -n 1; }
while tick=$(number tick) && [ "$tick" -lt "$ticks" ]; do $B sleep 1; done
say "after $tick ticks: state $(psicarve status --json | $B sed -n 's/.*"state": *"\([a-z]*\)".*/\1/p' | $B head -n 1), missed $(number missed_ticks)"
quietly psicarve estop
$B kill -TERM $core
$B sleep 0.2
$B kill -TERM $core 2>/dev/null
wait $core
say "core ended $?"
$B sed -n 's/^\([0-9]*\),\([0-9]*\)$/LAB ours \1 \2/p' /tmp/late.csv
say "over"
$B poweroff -f
