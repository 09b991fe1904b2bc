// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/journal/journal_facts.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cinttypes>
#include <cstdio>
#include <string>

#include "shared/base/message_text.hpp"
#include "shared/file/partial_file.hpp"
#include "shared/machine/machine_state.hpp"
#include "shared/machine/signal.hpp"
#include "shared/wording/message_record.hpp"
#include "shared/wording/wording.hpp"

namespace psicarve::supervisor {
namespace {

std::int64_t signed_of(std::uint64_t number) noexcept {
    return static_cast<std::int64_t>(number);
}

std::string as_sent(double value) {
    std::array<char, 32> text{};
    (void)std::snprintf(text.data(), text.size(), "%.9g", value);
    return text.data();
}

void add_sender(JournalFacts& facts, std::uint32_t pid) {
    facts.add("pid", std::int64_t{pid});
    const std::string folder = "/proc/" + std::to_string(pid);
    struct stat status {};
    if (::stat(folder.c_str(), &status) == 0) facts.add("uid", std::int64_t{status.st_uid});
    const OpenFile file{::open((folder + "/comm").c_str(), O_RDONLY | O_CLOEXEC)};
    if (file.get() < 0) return;
    std::array<char, 32> name{};
    const ssize_t got = ::read(file.get(), name.data(), name.size());
    if (got <= 1) return;
    const auto length = static_cast<std::size_t>(got);
    facts.add("sender", std::string_view{name.data(), name[length - 1] == '\n' ? length - 1 : length});
}

std::string names_of_axes(std::uint32_t mask) {
    std::string names;
    for (const Axis axis : kAllAxes) {
        if ((mask >> index_of(axis) & 1U) != 0)
            names += (names.empty() ? "" : " ") + std::string{name_of(axis)};
    }
    return names;
}

void add_target(JournalFacts& facts, const Command& command) {
    std::string target;
    for (const Axis axis : kAllAxes) {
        if ((command.axis >> index_of(axis) & 1U) == 0) continue;
        target += (target.empty() ? "" : " ") + std::string{name_of(axis)} + " " +
                  as_sent(command.target[index_of(axis)]);
    }
    facts.add("target", target);
}

void add_start(JournalFacts& facts, const Command& command) {
    if ((command.axis & kStartResumes) != 0) {
        facts.add("resumes", std::int64_t{1});
    } else {
        facts.add("first_layer", as_sent(command.value));
    }
    if (const std::uint32_t number = start_point_number(command); number != 0)
        facts.add("first_point", std::int64_t{number} - 1);
    if (const std::uint32_t count = start_layers(command); count != 0)
        facts.add("layers", std::int64_t{count});
    if ((command.axis & kStartsDry) != 0) facts.add("dry", std::int64_t{1});
}

}  // namespace

void add_progress(JournalFacts& facts, const cycle::Sample& sample) {
    facts.add("layer", std::int64_t{sample.layer})
        .add("point", std::int64_t{sample.point})
        .add("points_done", signed_of(sample.points_done))
        .add("points_total", signed_of(sample.points_total));
}

void add_reason(JournalFacts& facts, const Message& why) {
    if (why.is_none()) return;
    facts.add("reason", in_words(why)).add("message", name_of(why.id));
    const std::string arguments = arguments_text(why);
    if (!arguments.empty()) facts.add("arguments", arguments);
    const std::string text = text_of(why);
    if (!text.empty()) facts.add("text", text);
}

JournalFacts facts_of_alarm(const cycle::Report& report) {
    const FlightRecord& record = report.record;
    JournalFacts facts;
    if (record.axis < kAxisCount) facts.add("axis", name_of(static_cast<Axis>(record.axis)));
    if (static_cast<AlarmCause>(record.code) == AlarmCause::steps_lost) {
        facts.add("expected", report.expected_pulses).add("seen", record.value);
        if (report.layer_count > 0) {
            facts.add("first_wrong_layer", std::int64_t{report.first_layer})
                .add("wrong_layers", std::int64_t{report.layer_count});
        }
    }
    facts.add("signals", signed_of(record.signals));
    for (const Axis axis : kAllAxes)
        facts.add(std::string{name_of(axis)} + "_pulses", record.position_pulses[index_of(axis)]);
    return facts;
}

JournalFacts facts_of_command(const ReceivedCommand& received) {
    const Command& command = received.command;
    JournalFacts facts;
    switch (command.kind) {
        case CommandKind::home:
            if (command.axis != 0) facts.add("axes", names_of_axes(command.axis));
            break;
        case CommandKind::start:
            add_start(facts, command);
            break;
        case CommandKind::jog:
        case CommandKind::jog_on:
        case CommandKind::back_off:
            if (command.axis < kAxisCount) facts.add("axis", name_of(static_cast<Axis>(command.axis)));
            if (command.kind != CommandKind::back_off) facts.add("value", as_sent(command.value));
            break;
        case CommandKind::move:
            add_target(facts, command);
            break;
        case CommandKind::spindle:
        case CommandKind::override:
        case CommandKind::rapid_override:
        case CommandKind::single:
        case CommandKind::optional_stop:
            facts.add("value", as_sent(command.value));
            break;
        default:
            break;
    }
    add_sender(facts, received.sender_pid);
    return facts;
}

JournalFacts facts_of_job(const LoadedJob& job) {
    std::array<char, 17> checksum{};
    (void)std::snprintf(checksum.data(), checksum.size(), "%016" PRIx64, job.checksum);
    JournalFacts facts;
    facts.add("source", job.view.source_name())
        .add("layers", std::int64_t{job.view.layer_count()})
        .add("layer_points", std::int64_t{job.view.point_count()})
        .add("checksum", std::string_view{checksum.data()});
    return facts;
}

}  // namespace psicarve::supervisor
