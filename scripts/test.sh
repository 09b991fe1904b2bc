#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Every test, from a bare Debian 12. Later parts run even when an earlier one has failed.
# shellcheck disable=SC2317  # the parts are called by name
set -uo pipefail

root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)
logs="$root/build/logs"
all_parts="format dev tsan asan fuzz tidy"
suite_parts="dev tsan asan"  # one suite, in this order where the time is short
extra_parts="analyse"
fuzz_runs=8000  # of each target, but of record_fuzz, each of whose inputs runs a machine:
record_fuzz_runs=500
most_flaky=2    # tests of a run that may fail and then pass
slices=3        # of the suite under AddressSanitizer, where less time than this is left:
whole_suite_s=1800
long_build_s=600  # of dev: where it takes longer its tests do not wait for other builds

usage() {
    cat <<END
usage: ${0##*/} [--quick | --long | PART...]
       ${0##*/} --again N NAME [PRESET]

Installs the Debian packages that are missing, then checks the formatting, builds dev, tsan and asan and runs their tests
side by side as one suite: all in dev, under AddressSanitizer and UndefinedBehaviorSanitizer all but those that go over
the same lines as others (docs/contributing.md), those with threads under ThreadSanitizer. Then fuzzes the parsers a
little, and runs clang-tidy over the units of dev. Closes with a summary of each preset's tests. Tests that fail run again, alone, at most twice. The closing lines name those that passed then as FLAKY, and where to read what they
said first; more than $most_flaky of a run fail it. Where a failure can have no excuse (equal bytes, deaths, mutated segments,
the guard, what a sanitizer reports) there is no second chance.

  PART      only these, of: $all_parts (tidy needs the build of dev), and
            analyse: clang-tidy over each source by itself, with its static analyser (half an hour; not among "every")
  --quick   format and dev
  --long    every part, with the long forms of the tests that have one, and ten minutes of fuzzing for each parser
  --again N NAME [PRESET]
            builds PRESET (dev) and runs the test NAME, or those whose names begin so, N times each with both hands full: a busy
            loop for each processor runs beside it. Says how often it failed, and keeps what it said then

PSICARVE_SKIP_HARDWARE=1 leaves out the test that boots a PREEMPT_RT kernel in QEMU (tests/hardware); without QEMU it fails.
PSICARVE_FUZZ_SECONDS=N fuzzes each parser for N seconds instead, on from what earlier runs have found.
PSICARVE_SECONDS=N begins no part after N seconds. Where less than half an hour of them is left, the tests under
AddressSanitizer run in slices, and no slice is begun then either. The closing lines name what was left out. dev, which has
all tests, is never left out. Continuous integration sets it.

Exit codes: 0 all passed; 1 something failed (the closing lines say what); 2 wrong usage.
Builds are kept in build/; a second run does only what has changed. The fuzzers' build and tidy are begun while tests wait
for clocks.
END
}

again=()
if [[ ${1-} == --again ]]; then
    if (($# < 3 || $# > 4)) || [[ ! $2 =~ ^[1-9][0-9]*$ ]] || [[ " dev release asan tsan " != *" ${4-dev} "* ]]; then
        printf '%s: --again wants how often, the name of a test, and a preset or none\n' "${0##*/}" >&2
        usage >&2
        exit 2
    fi
    again=("$@")
    set --
fi
parts=()
for argument in "$@"; do
    case " $all_parts $extra_parts --quick --long --help -h " in
        *" $argument "*) ;;
        *) printf '%s: unknown argument: %s\n' "${0##*/}" "$argument" >&2; usage >&2; exit 2 ;;
    esac
    case "$argument" in
        -h | --help) usage; exit 0 ;;
        --quick) parts+=(format dev) ;;
        --long)
            export PSICARVE_LONG=1 PSICARVE_FUZZ_SECONDS=${PSICARVE_FUZZ_SECONDS-600}
            ;;
        *) parts+=("$argument") ;;
    esac
done
if ((${#parts[@]} == 0)); then read -ra parts <<<"$all_parts"; fi

# Sanitizers of this age stumble over kernels that spread addresses wide: switch that off where we may.
if [[ -z ${PSICARVE_STILL-} ]] && setarch "$(uname -m)" -R true 2>/dev/null; then
    PSICARVE_STILL=1 exec setarch "$(uname -m)" -R "${BASH_SOURCE[0]}" "${again[@]}" "$@"
fi

# shellcheck source=scripts/build.sh
source "$root/scripts/build.sh"
# shellcheck source=scripts/ahead.sh
source "$root/scripts/ahead.sh"
mkdir -p "$logs" || fail "cannot write to $logs"

if ((${#again[@]})); then
    preset=${again[3]-dev}
    "$root/scripts/deps.sh" test || fail "some packages could not be installed"
    configure_preset "$preset" "$root/build/$preset" && build "$root/build/$preset" || exit 1
    exec "$root/scripts/suite.py" again "$root/build/$preset" "${again[1]}" "${again[2]}"
fi
rm -f "$logs"/ctest-*.log "$logs"/flaky* "$logs"/sanitizer-* "$logs"/verdicts

run_format() { "$root/scripts/format.sh" --check; }

# run_suites PRESET...: builds each and runs the tests of all as one suite: those that compute have the processors while
# others wait for a clock. Adds to verdicts and presets what became of each.
run_suites() {
    local preset built=() others=() slice
    declare -A build_s=()
    for preset in "$@"; do
        if [[ $preset != dev ]] && is_late; then
            left_out+=("$preset")
            continue
        fi
        say "$preset"
        local begin=$SECONDS
        if build_tests "$preset"; then
            built+=("$preset")
        else
            note "$preset" FAILED $((SECONDS - begin)) ', its build'
        fi
        build_s[$preset]=$((SECONDS - begin))
        # Here nothing is in a cache, and the others' builds may take all the time that there is.
        if [[ ${built[*]} == dev && -n ${PSICARVE_SECONDS-} ]] && ((build_s[dev] > long_build_s)); then
            say "tests of dev"
            run_tests dev
            tell_verdict dev "${build_s[dev]}"
            built=()
        fi
    done
    if ((${#built[@]} == 0)); then return; fi
    begin_ahead "${parts_to_come[@]}"
    say "tests of ${built[*]}"
    if [[ " ${built[*]} " == *" asan "* && -n ${PSICARVE_SECONDS-} ]] && ((PSICARVE_SECONDS - SECONDS < whole_suite_s)); then
        mapfile -t others < <(printf '%s\n' "${built[@]}" | grep -v '^asan$')
        if ((${#others[@]})); then run_tests "${others[@]}"; fi
        # Every slice has tests of all kinds; but those by the real clock go one by one, and what could run beside all of
        # them is done long before in each.
        for ((slice = 1; slice <= slices; ++slice)); do
            if is_late; then
                left_out+=("asan: $((slices - slice + 1)) of $slices slices of its tests")
                if ((slice == 1)); then built=("${others[@]}"); fi  # none of them is no failure
                break
            fi
            run_tests asan -I "$slice,,$slices" || printf 'asan FAILED 0\n' >>"$logs/verdicts"
        done
    else
        run_tests "${built[@]}"
    fi
    for preset in "${built[@]}"; do
        tell_verdict "$preset" "${build_s[$preset]}"
    done
}
build_tests() {
    local targets=()
    if [[ $1 == tsan ]]; then targets=(threads_tests); fi
    configure_preset "$1" "$root/build/$1" && build "$root/build/$1" "${targets[@]}"
}
# run_tests PRESET... [CTEST ARGUMENTS...]: what became of each goes to $logs/verdicts.
run_tests() {
    local names=$1
    shift
    while [[ ${1-} == [a-z]* ]]; do
        names+=,$1
        shift
    done
    # One more than there are processors: some tests wait for a clock.
    "$root/scripts/suite.py" run "$names" "$logs" --parallel "$(($(nproc) + 1))" "$@"
}
# tell_verdict PRESET BUILD_S: from what the runs of its tests have left in $logs/verdicts; there are several of slices.
tell_verdict() {
    local verdict seconds
    read -r verdict seconds < <(awk -v preset="$1" '
        $1 == preset { runs += 1; seconds += $3; if ($2 != "passed") { failed += 1 } }
        END { print (runs > 0 && !failed ? "passed" : "FAILED"), seconds + 0 }' "$logs/verdicts" 2>/dev/null)
    if [[ -z $verdict ]]; then verdict=FAILED; fi
    note "$1" "$verdict" "${seconds:-0}" ", built in $2 s"
}
# note PART VERDICT SECONDS [REMARK]: for the closing lines.
note() {
    verdicts+=("$(printf '%-8s %s  %4d s%s' "$1" "$2" "$3" "${4-}")")
    if [[ $2 == FAILED ]]; then failed_parts+=("$1"); fi
    # dev, which has all tests, is to close the output.
    case "$1" in
        dev) presets+=(dev) ;;
        asan | tsan) presets=("$1" "${presets[@]}") ;;
    esac
}
# Whether the time that we were given is over.
is_late() { [[ -n ${PSICARVE_SECONDS-} ]] && ((SECONDS > PSICARVE_SECONDS)); }

# Always the same inputs, made from those kept in the tree: a change fails for what it does, not by luck. With
# PSICARVE_FUZZ_SECONDS others every time.
run_fuzz() {
    local folder="$root/build/fuzz" targets target pid running=() failed=0
    take_over fuzz
    build_fuzz || return 1
    mapfile -t targets < <(fuzz_targets "$folder")
    # As many at a time as there are processors: each has one thread.
    for target in "${targets[@]}"; do
        while (($(running_of "${running[@]}") >= $(nproc))); do sleep 0.1; done
        fuzz_one "$folder" "$target" &
        running+=("$!")
    done
    for pid in "${running[@]}"; do wait "$pid" || failed=1; done
    return "$failed"
}
build_fuzz() {
    local folder="$root/build/fuzz" targets
    configure_preset fuzz "$folder" -DCMAKE_CXX_COMPILER=clang++-14 || return 1
    mapfile -t targets < <(fuzz_targets "$folder")
    if ((${#targets[@]} == 0)); then
        printf 'fuzz: no targets in tests/fuzz\n' >&2
        return 1
    fi
    build "$folder" "${targets[@]}"
}
# running_of [PID...]: how many of them.
running_of() {
    local pid count=0
    for pid in "$@"; do
        if kill -0 "$pid" 2>/dev/null; then count=$((count + 1)); fi
    done
    printf '%s\n' "$count"
}
fuzz_targets() { ninja -C "$1" -t targets all | sed -n 's/: CXX_EXECUTABLE_LINKER.*//p' | grep fuzz; }
# fuzz_one FOLDER TARGET
fuzz_one() {
    local folder=$1 target=$2 name kept
    name=$(basename "$target")
    # What it finds goes to the first folder.
    local corpora=("$folder/found/$name") limit=(-seed=1 "-runs=$fuzz_runs")
    if [[ $name == record_fuzz ]]; then limit=(-seed=1 "-runs=$record_fuzz_runs"); fi
    if [[ -n ${PSICARVE_FUZZ_SECONDS-} ]]; then
        corpora=("$folder/corpus/$name")
        limit=("-max_total_time=$PSICARVE_FUZZ_SECONDS")
    else
        rm -rf "${corpora[0]}"
    fi
    mkdir -p "${corpora[0]}"
    kept="$root/tests/fuzz/corpus/${name%_fuzz}"
    if [[ -d $kept ]]; then corpora+=("$kept"); fi
    say "fuzz: $name"
    # What it reports of its own progress is of use only beside a finding.
    if ! (cd "$folder" && "./$target" "${limit[@]}" -timeout=10 -rss_limit_mb=2048 -print_final_stats=0 \
        -verbosity=0 "${corpora[@]}") &>"$logs/$name.log"; then
        cat "$logs/$name.log"
        return 1
    fi
}

run_tidy() {
    take_over tidy
    tidy_dev
}
# What is begun while tests wait (ahead.sh).
ahead_fuzz() { build_fuzz; }
ahead_tidy() { tidy_dev; }
tidy_dev() { python3 "$root/scripts/tidy.py" "$root" "$root/build/dev"; }
run_analyse() {
    local folder="$root/build/analyse"
    configure_preset dev "$folder" -DCMAKE_UNITY_BUILD=OFF -DPSICARVE_TESTS=OFF -DPSICARVE_HARDWARE=OFF && build "$folder" &&
        python3 "$root/scripts/tidy.py" "$root" "$folder"
}

# The closing lines of each ctest run of a preset: from its verdict to the end.
summary_of() {
    printf -- '---- ctest, preset %s\n' "$1"
    if [[ -s $logs/ctest-$1.log ]]; then
        awk '/tests passed, (.* tests failed out of|no test ran)/ { is_end = 1 } /^Test project / { is_end = 0 } is_end' "$logs/ctest-$1.log"
    else
        printf 'no test ran\n'
    fi
}

"$root/scripts/deps.sh" test || fail "some packages could not be installed"

verdicts=()
left_out=()
failed_parts=()
presets=()
parts_to_come=("${parts[@]}")
mapfile -t suites < <(for part in $suite_parts; do printf '%s\n' "${parts[@]}" | grep -xm 1 "$part"; done)
for part in "${parts[@]}"; do
    begin=$SECONDS
    parts_to_come=("${parts_to_come[@]:1}")
    if [[ " $suite_parts " == *" $part "* ]]; then
        # With the first of them all have their turn.
        if ((${#suites[@]})); then run_suites "${suites[@]}"; fi
        suites=()
        continue
    fi
    if is_late; then
        left_out+=("$part")
        continue
    fi
    say "$part"
    verdict=passed
    if ! "run_$part"; then verdict=FAILED; fi
    note "$part" "$verdict" $((SECONDS - begin))
done

printf '\n'
printf '== %s\n' "${verdicts[@]}"
printf '== %-8s         %4d s\n' altogether "$SECONDS"
if [[ -s $logs/flaky ]]; then
    sed 's/^/== /' "$logs/flaky"
    flaky=$(wc -l <"$logs/flaky")
    if ((flaky > most_flaky)); then
        failed_parts+=("$flaky flaky tests")
    fi
fi
# Also of a process that was still at it when its suite had ended.
shopt -s nullglob
reports=("$logs"/sanitizer-*)
if ((${#reports[@]})); then
    printf '== a sanitizer has reported: %s\n' "${reports[@]#"$root"/}"
    failed_parts+=("${#reports[@]} reports of sanitizers")
fi
if ((${#left_out[@]})); then printf '== LEFT OUT, the time was over: %s\n' "${left_out[@]}"; fi
if ((${#failed_parts[@]})); then printf '== failed: %s\n' "${failed_parts[*]}"; fi
# What failed stands last, where a reader of the closing lines sees it.
passed_runs=()
failed_runs=()
for preset in "${presets[@]}"; do
    if [[ " ${failed_parts[*]} " == *" $preset "* ]]; then failed_runs+=("$preset"); else passed_runs+=("$preset"); fi
done
for preset in "${passed_runs[@]}" "${failed_runs[@]}"; do summary_of "$preset"; done
exit $((${#failed_parts[@]} > 0))
