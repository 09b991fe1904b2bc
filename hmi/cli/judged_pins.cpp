// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/judged_pins.hpp"

#include <algorithm>
#include <utility>

#include "hmi/cli/exit_code.hpp"
#include "hmi/picture/picture.hpp"

namespace psicarve::cli {

namespace {

/// What the pins tell and the core's status does not: it knows the last run's whole job alone.
void add_pins_figures(RunReport& report, const verify::VerifyReport& seen) {
    report.figures.pulses = seen.pulses;
    if (report.figures.carve_seconds || seen.carve_seconds == 0.0) return;
    // Of an earlier carving than the last run.
    if (seen.carve_seconds > report.figures.total_seconds) return;
    (seen.is_complete ? report.figures.carve_seconds : report.seconds_so_far) = seen.carve_seconds;
}

}  // namespace

void add_verification(RunReport& report, Result<verify::VerifyReport> verification) {
    if (verification) add_pins_figures(report, *verification);
    if (!verification) {
        report.unverified_reason = verification.error().message;
    } else if (!report.figures.is_complete) {
        report.unverified_reason = "the job was not carved to its end";
    } else {
        report.verification = std::move(verification).value();
    }
}

void add_recorded_verification(RunReport& report, Result<verify::VerifyReport> verification) {
    if (!verification) return add_verification(report, std::move(verification));
    add_pins_figures(report, *verification);
    report.verification = std::move(verification).value();
}

void miss(RunReport& report, const std::string& what) {
    if (!report.failure)
        report.failure =
            Error{ErrorCode::machine_refused, what + ": not verified: " + report.unverified_reason};
}

void require_verification(RunReport& report) {
    if (report.verification || report.failure || !report.figures.is_complete) return;
    report.failure = Error{ErrorCode::machine_refused, "not verified: " + report.unverified_reason};
}

void add_picture(RunReport& report, const JobView& job, const verify::CarvedSurface& surface,
                 const std::string& picture_path) {
    if (picture_path.empty()) return;
    if (!report.verification) return miss(report, picture_path + ": the carved piece cannot be drawn");
    auto caption = verify::caption_of(job, *report.verification);
    caption.has_lost_steps = !report.lost_steps.empty();
    const auto drawn = verify::write_picture(picture_path, surface, caption);
    if (!drawn && !report.failure) report.failure = drawn.error();
    if (drawn) report.picture_path = picture_path;
}

void warn_of_lost_pins(const RunReport& report) {
    const std::uint64_t lost =
        report.last.trace_lost - std::min(report.before.trace_lost, report.last.trace_lost);
    if (lost == 0) return;
    print_warning(std::to_string(lost) +
                  " pin changes came faster than the trace could be written and are missing in it");
}

}  // namespace psicarve::cli
