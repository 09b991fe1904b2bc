// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "hmi/surface/job_geometry.hpp"
#include "hmi/verify/offence_log.hpp"
#include "hmi/verify/path/path_line.hpp"
#include "hmi/verify/verify_report.hpp"

namespace psicarve::verify {

/// The largest distances from the straight lines between points.
struct LineExtent {
    double mm = 0.0;
    double pulses = 0.0;  ///< across the line; another place, maybe

    void note(const PathLine::Distance& distance, double pulse_across_mm) noexcept;
    void join(const LineExtent& other) noexcept;
};

/// Rule 1's breaches of which it is not known yet whether they count: what was found while the heads only
/// went outward does not if that was the retraction, and a head too deep on a link does not if one axis alone
/// missed the link's end.
class PendingFindings {
public:
    /// The log outlives it.
    explicit PendingFindings(OffenceLog& log) noexcept : log_(log) {}

    /// Whether this instant's motion is outward, psi and Y still. What came before and was outward counts
    /// when it is not.
    void set_outward(bool is_outward);
    void note_distance(const PathLine::Distance& distance, double pulse_across_mm) noexcept;
    /// A head off its line.
    void stray(Offence offence, const CarvePlace& place);

    /// A head's depth below what is allowed [pulses], 0 or less: none. True: its stay there begins.
    bool goes_too_deep(std::size_t h, std::int64_t too_deep_pulses) noexcept;
    /// Of the stay that begins. Counts at once where no link is on the way, or too many wait.
    void add_depth(Offence offence, const CarvePlace& place, std::int64_t too_deep_pulses, bool is_on_link);
    /// One axis alone missed the link's end: a head may have been a little too deep because that axis was
    /// where it should not be, or because its own count is off.
    void excuse_depths(Axis lost);
    /// The link has ended: what was too deep counts.
    void count_depths();

    /// The attempt has ended: what was found on the way out was the retraction.
    void forget_retraction() noexcept { retraction_ = {}; }
    /// Another attempt begins.
    void begin_anew() noexcept;

    const LineExtent& line_extent() const noexcept { return line_; }
    void set_line_extent(const LineExtent& extent) noexcept { line_ = extent; }

private:
    struct Finding {
        Offence offence;
        CarvePlace place;
        std::int64_t most_too_deep = 0;  ///< [pulses]
    };
    struct Retraction {
        std::optional<Finding> stray;
        LineExtent line;
    };
    void count(const Finding& finding);
    void keep_retraction();

    OffenceLog& log_;
    LineExtent line_;
    bool is_outward_ = false;
    Retraction retraction_;
    std::vector<Finding> depths_;  ///< on the link
    std::array<bool, kHeadCount> is_too_deep_{};
};

}  // namespace psicarve::verify
