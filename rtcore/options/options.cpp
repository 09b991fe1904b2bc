// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/options/options.hpp"

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "shared/base/nearest.hpp"
#include "shared/base/printable.hpp"
#include "shared/computer/cpu_list.hpp"
#include "shared/file/distinct_files.hpp"
#include "shared/file/state_place.hpp"
#include "shared/profile/profile_place.hpp"
#include "shared/segment/segment.hpp"

namespace psicarve::supervisor {
namespace {

constexpr std::uint32_t kLargestCapacity = 1'000'000;
constexpr const char* kProgramName = "psicarve-rtcore";
constexpr const char* kAbout =
    "The real-time core of Psicarve: carves what is published in a shared-memory segment.";
constexpr int kExitUsage = 2;
constexpr int kExitBadOutput = 3;

bool parse_count(std::string_view text, std::uint32_t& count) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), count);
    return error == std::errc{} && end == text.data() + text.size() && count >= 1 &&
           count <= kLargestCapacity;
}

std::string check_segment_name(const std::string& name) {
    const bool is_plain = name.size() >= 2 && name.size() <= 200 && name.front() == '/' &&
                          name.find('/', 1) == std::string::npos;
    return is_plain ? std::string{} : "a segment's name begins with / and has no other: --segment /psicarve";
}

/// The number of one processor; nothing for other words.
std::optional<int> cpu_from(const std::string& text) {
    const auto cpus = cpus_from_list(text);
    return cpus && cpus->size() == 1 ? std::optional<int>{cpus->front()} : std::nullopt;
}
std::string check_cpu(const std::string& text) {
    if (text == "any" || cpu_from(text)) return {};
    return "'" + text + "' is not the number of a processor, nor any";
}

std::string check_not_empty(const std::string& text) {
    return text.empty() ? "the name is empty" : std::string{};
}

std::string check_ring(const std::string& text) {
    std::uint32_t records = 0;
    if (parse_count(text, records) && is_ring_capacity(records)) return {};
    return "'" + text + "' is not a power of two from 64 to 65536";
}

/// Options that are read as words and converted.
struct Texts {
    std::string port = "sim";
    std::string clock;
    std::string capacity;
    std::string cpu;
    bool keeps_no_state = false;
};

void describe(CLI::App& app, CoreOptions& options, Texts& texts) {
    app.footer(
        "Example:\n  psicarve-rtcore --port sim --clock real --profile machine.toml\n\n"
        "Exit codes: 0 done; 2 wrong usage; 3 bad input; 4 alarm (replay); 5 no segment.");
    app.add_option("--segment", options.segment_name, "Shared-memory segment to serve")
        ->type_name("NAME")
        ->capture_default_str()
        ->check(check_segment_name);
    app.add_option(
           "--port", texts.port,
           "Where the signals go: sim (a simulated machine), ppdev:/dev/parportN, or io:ADDRESS as in "
           "io:0x378 (needs CAP_SYS_RAWIO)")
        ->type_name("PORT")
        ->capture_default_str();
    app.add_flag("--allow-no-realtime", options.allow_no_realtime,
                 "Drive a real port even without the rights for real-time scheduling");
    app.add_option(
           "--clock", texts.clock,
           "real: ticks by the wall clock; virtual: the same code as fast as it goes, the same every time")
        ->type_name("real|virtual")
        ->check(CLI::Validator{CLI::IsMember(std::vector<std::string>{"real", "virtual"})}.description(""))
        ->default_str("real");
    app.add_option("--profile", options.profile_path,
                   "Machine profile (TOML), or a job file whose profile is meant; without it the one that "
                   "'psicarve profile path' tells")
        ->type_name("FILE")
        ->check(check_not_empty);
    app.add_option(
           "--machine", options.machine_path,
           "What the simulated machine really is, as a profile: motors, sensors, wiring, how its heads "
           "stand, its blank; without it the core's own profile, with some reserve in its motors")
        ->type_name("FILE")
        ->check(check_not_empty);
    app.add_option("--piece", options.piece_path,
                   "At the end, write what the tips left of the simulated machine's blank (CSV)")
        ->type_name("FILE.csv")
        ->check(check_not_empty);
    app.add_option(
           "--trace", options.trace_paths,
           "Record every pin: .vcd is a value-change dump, anything else compact binary; fd:N an open "
           "descriptor; may be given more than once")
        ->type_name("FILE")
        ->check(check_not_empty);
    app.add_option("--capacity", texts.capacity, "Largest job of a new segment, layers x points")
        ->type_name("LAYERSxPOINTS")
        ->default_str("4000x3600");
    app.add_option(
           "--program-ring", options.capacity_records,
           "Records of a program in G-code that wait for the core in a new segment: a power of two, 64 "
           "to 65536")
        ->type_name("RECORDS")
        ->capture_default_str()
        ->check(check_ring);
    app.add_option("--group", options.group, "Members of this group may use the segment, too (mode 0660)")
        ->type_name("NAME");
    app.add_option("--user", options.user,
                   "Started by root: be this user instead, who then owns segment and outputs")
        ->type_name("NAME")
        ->check(check_not_empty);
    app.add_option("--replay", options.replay_path,
                   "Run this job or snapshot file from the home positions, then exit")
        ->type_name("JOB")
        ->check(check_not_empty);
    app.add_flag("--replay-program", options.replays_program,
                 "With --replay: run the snapshot's G-code program, whose records another process writes");
    app.add_flag("--assume-homed", options.assume_homed,
                 "With --replay on a real port: the machine stands at its home positions");
    app.add_flag(
        "--no-guard", options.no_guard,
        "Drive a real port without the process that switches drives and spindle off when the core dies "
        "(for debuggers)");
    app.add_flag("--exit-with-parent", options.exit_with_parent, "End in order when the parent process ends");
    app.add_option("--cpu", texts.cpu,
                   "The tick's processor: its number, or any; without it the last of those that the kernel "
                   "keeps free (isolcpus), else any")
        ->type_name("N|any")
        ->check(check_cpu);
    app.add_option("--priority", options.priority, "The tick's real-time priority (SCHED_FIFO)")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::Range(1, 99).description(""));
    app.add_option("--lateness", options.lateness_path,
                   "At the end, write how many ticks were how many microseconds late (CSV; real clock)")
        ->type_name("FILE.csv")
        ->check(check_not_empty);
    app.add_option(
           "--layer-times", options.layer_times_path,
           "Whenever a job is planned, write when each of its layers is over, in seconds from its first "
           "point (CSV); fd:N: into an open descriptor")
        ->type_name("FILE.csv")
        ->check(check_not_empty);
    app.add_option("--point-times", options.point_times_path,
                   "Likewise, write what the way to each point takes, in seconds, and what bounds it "
                   "(binary); fd:N: into an "
                   "open descriptor")
        ->type_name("FILE")
        ->check(check_not_empty);
    app.add_option(
           "--state", options.state_folder,
           "Keep in this folder how far the piece is carved, a copy of its job and what happens to "
           "the machine, for when the computer is switched off; without it in /var/lib/psicarve (root) or "
           "~/.local/state/psicarve, and on the virtual clock nowhere")
        ->type_name("FOLDER")
        ->check(check_not_empty);
    app.add_flag("--no-state", texts.keeps_no_state, "Keep nothing of that");
    app.add_flag("--no-estimate", options.no_estimate,
                 "Do not plan a job ahead to know how long it takes; the time left stays unknown");
    app.add_flag("--measure-latency", options.measures_latency,
                 "Only measure how late an empty tick is, and print it as JSON; see psicarve latency");
    app.add_option("--seconds", options.measure_seconds, "With --measure-latency: how long")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::Range(1, 1'000'000).description(""));
    app.add_option("--period-us", options.measure_period_us, "With --measure-latency: the tick's period")
        ->type_name("N")
        ->capture_default_str()
        ->check(CLI::Range(10, 1'000'000).description(""));
    app.set_version_flag("--version", PSICARVE_VERSION);
}

/// Help, or the version.
int print_what_was_asked(const CLI::App& app, const CLI::Success& success) {
    std::ostringstream text;
    app.exit(success, text, text);
    std::fputs(text.str().c_str(), stdout);
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return 0;
    std::fprintf(stderr, "psicarve-rtcore: standard output: %s\n", std::strerror(errno));
    return kExitBadOutput;
}

/// Descriptors among the traces belong to the process that gave them.
Result<void> check_files(const CoreOptions& options) {
    std::vector<NamedFile> files{{"--profile", options.profile_path, false},
                                 {"profile", options.unnamed_profile_path, false},
                                 {"--machine", options.machine_path, false},
                                 {"--replay", options.replay_path, false},
                                 {"--piece", options.piece_path, true},
                                 {"--lateness", options.lateness_path, true},
                                 {"--layer-times", options.layer_times_path, true},
                                 {"--point-times", options.point_times_path, true}};
    for (const std::string& path : options.trace_paths)
        if (!path.starts_with("fd:")) files.push_back({"--trace", path, true});
    return check_distinct(files);
}

/// Refuses options that would be ignored silently.
Result<void> check_meant(const CLI::App& app, const CoreOptions& options) {
    const auto wrong = [](const char* option, const char* why) {
        return Error{ErrorCode::bad_usage, std::string{option} + ": " + why};
    };
    const bool ticks_really = options.clock == ClockKind::real || options.measures_latency;
    for (const char* option : {"--lateness", "--cpu"}) {
        if (!ticks_really && app.count(option) > 0)
            return wrong(option, "on the virtual clock nothing is late; --clock real");
    }
    if (options.assume_homed && options.replay_path.empty())
        return wrong("--assume-homed", "is for --replay on a real port; home the machine instead");
    if (options.no_estimate && !options.point_times_path.empty())
        return wrong("--point-times", "is of the estimate; leave out --no-estimate");
    if (options.replays_program && (options.replay_path.empty() || options.clock == ClockKind::real))
        return wrong("--replay-program", "is for --replay on the virtual clock");
    if (app.count("--state") > 0 && app.count("--no-state") > 0)
        return wrong("--state", "and --no-state contradict each other");
    if (!options.replay_path.empty() && app.count("--state") > 0)
        return wrong("--state", "a replay carves no piece that anybody goes on with");
    if (options.measures_latency && app.count("--user") > 0)
        return wrong("--user", "--measure-latency has neither segment nor port, and is whose start it was");
    const long processors = sysconf(_SC_NPROCESSORS_CONF);
    if (options.cpu && *options.cpu >= processors) {
        const std::string why = "this computer has no such processor, but 0 to ";
        return wrong("--cpu", (why + std::to_string(processors - 1)).c_str());
    }
    for (const char* option : {"--seconds", "--period-us"}) {
        if (!options.measures_latency && app.count(option) > 0)
            return wrong(option, "is for --measure-latency");
    }
    return {};
}

/// A core on the real clock carves a real piece, and keeps its state. Chosen for the user who starts it:
/// --user makes it the system's.
void choose_state_folder(const Texts& texts, CoreOptions& options) {
    const bool keeps_none = options.clock == ClockKind::virtual_time || !options.replay_path.empty() ||
                            options.measures_latency || texts.keeps_no_state;
    if (options.state_folder.empty() && !keeps_none)
        options.state_folder = state_folder_of_core(geteuid() == 0);
}

Result<void> take_port(const std::string& text, CoreOptions& options) {
    auto port = port::parse_port_address(text);
    if (!port) return port.error();
    options.port = std::move(*port);
    if (options.port.is_simulated()) return {};
    const auto wrong = [&](const std::string& problem) {
        return Error{ErrorCode::bad_usage, "--port " + text + ": " + problem};
    };
    if (options.clock == ClockKind::virtual_time) {
        return wrong("a real machine keeps real time; --clock real, or --port sim");
    }
    if (!options.machine_path.empty()) return wrong("--machine is for the simulated machine, --port sim");
    if (!options.piece_path.empty()) return wrong("--piece is for the simulated machine, --port sim");
    if (!options.replay_path.empty() && !options.assume_homed) {
        return wrong(
            "--replay takes the machine to stand at its home positions; home it, carve instead, or say "
            "--assume-homed");
    }
    return {};
}

/// One line, as psicarve says it.
int report_usage(const std::string& what) {
    std::fprintf(stderr, "psicarve-rtcore: %s (see: psicarve-rtcore --help)\n", printable(what).c_str());
    return kExitUsage;
}

std::string usage_error(const CLI::App& app, const CLI::ParseError& error) {
    const std::vector<std::string> unknown = app.remaining(true);
    const auto is_option = [](const std::string& word) { return word.size() > 1 && word.front() == '-'; };
    // A mistyped option explains more than the words that are left over because of it.
    auto culprit = std::ranges::find_if(unknown, is_option);
    if (culprit == unknown.end()) culprit = unknown.begin();
    if (culprit == unknown.end()) return error.what();
    if (!is_option(*culprit)) return "unexpected argument '" + *culprit + "'";
    const std::string name = culprit->substr(0, culprit->find('='));
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options())
        for (const std::string& known : option->get_lnames()) names.push_back("--" + known);
    const auto meant = nearest(name, names);
    return "unknown option '" + name + "'" + (meant ? "; did you mean '" + *meant + "'?" : "");
}

}  // namespace

Result<void> parse_capacity(const std::string& text, CoreOptions& options) {
    const std::size_t cross = text.find('x');
    if (cross == std::string::npos ||
        !parse_count(std::string_view{text}.substr(0, cross), options.capacity_layers) ||
        !parse_count(std::string_view{text}.substr(cross + 1), options.capacity_points)) {
        return Error{ErrorCode::bad_usage,
                     "--capacity: '" + text + "' is not LAYERSxPOINTS, as in 4000x3600, each 1 to 1000000"};
    }
    return {};
}

void show_command_line(const std::function<void(const CLI::App&)>& look) {
    CoreOptions options;
    Texts texts;
    CLI::App app{kAbout, kProgramName};
    describe(app, options, texts);
    look(app);
}

std::variant<CoreOptions, int> parse_options(int argc, char** argv) {
    CoreOptions options;
    Texts texts;
    CLI::App app{kAbout, kProgramName};
    describe(app, options, texts);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& success) {
        return print_what_was_asked(app, success);
    } catch (const CLI::ParseError& error) {
        return report_usage(usage_error(app, error));
    }
    if (!texts.clock.empty()) {
        options.clock = texts.clock == "real" ? ClockKind::real : ClockKind::virtual_time;
    }
    options.takes_any_cpu = texts.cpu == "any";
    options.cpu = cpu_from(texts.cpu);
    auto taken = take_port(texts.port, options);
    if (taken) taken = check_meant(app, options);
    choose_state_folder(texts, options);
    if (options.profile_path.empty()) options.unnamed_profile_path = default_profile_path();
    if (taken) taken = check_files(options);
    if (!taken) return report_usage(taken.error().message);
    if (!texts.capacity.empty()) {
        auto parsed = parse_capacity(texts.capacity, options);
        if (parsed) parsed = check_shared_memory_for(options.capacity_layers, options.capacity_points);
        if (!parsed) return report_usage(parsed.error().message);
    }
    return options;
}

}  // namespace psicarve::supervisor
