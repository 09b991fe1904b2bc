// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/program_sight.hpp"

#include <chrono>
#include <thread>

#include "hmi/report/program_modes.hpp"
#include "shared/computer/process_identity.hpp"

namespace psicarve::cli {
namespace {

constexpr int kMostLooks = 10;
constexpr std::chrono::milliseconds kBetweenLooks{2};

bool lacks_modes(const ProgramReport& program) {
    return program.status.is_running != 0 &&
           !(program.modes && report::is_at_hand(*program.modes, program.status));
}

}  // namespace

bool has_living_writer(const Segment& segment) {
    const ProgramReport program = program_report(segment);
    return program.writer_pid != 0 &&
           is_process_alive(program.writer_pid, segment.header().program.claim_start_time.load());
}

ProgramSight told_sight(ProgramSight sight, const std::function<std::optional<ProgramSight>()>& look_again) {
    for (int look = 0; look < kMostLooks && lacks_modes(sight.program); ++look) {
        const auto again = look_again();
        if (!again) break;
        sight = *again;
    }
    return sight;
}

Result<ProgramSight> told_sight(machine::MachineLink& link) {
    const auto status = link.status();
    if (!status) return status.error();
    const ProgramSight first{*status, program_report(link.segment())};
    return told_sight(first, [&]() -> std::optional<ProgramSight> {
        if (!has_living_writer(link.segment())) return std::nullopt;
        std::this_thread::sleep_for(kBetweenLooks);
        return ProgramSight{link.last_status().value_or(*status), program_report(link.segment())};
    });
}

}  // namespace psicarve::cli
