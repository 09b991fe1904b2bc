// SPDX-License-Identifier: GPL-3.0-or-later
// Programs whose corners are rounded, as the DDA makes pulses of them: every place, one iteration after the
// other.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "rtcore/cycle/dual_head_dda.hpp"
#include "rtcore/plan/record_program.hpp"
#include "shared/base/units.hpp"
#include "tests/rtcore/plan/scripted_source.hpp"

namespace psicarve::plan::test {

/// What a program's blocks come to.
struct CarvedProgram {
    struct Place {
        Pulses4 at;
        std::uint64_t line;
    };
    std::vector<Place> places;  ///< after each iteration
    std::vector<Pulses4> rests;
    double seconds = 0.0;
};

inline CarvedProgram carved(const MachineLimits& limits, const Script& script, const Pulses4& start) {
    RecordProgram program(limits, std::make_shared<ScriptedSource>(script.steps), start);
    CarvedProgram result;
    cycle::MotionBlock block;
    Pulses4 at = start;
    std::uint32_t left = 0;
    while (program.next(block)) {
        if (block.kind != cycle::BlockKind::path) continue;
        if (left == 0) left = block.group_blocks;
        result.seconds += 2.0 * block.path.length /
                          (std::sqrt(block.path.start_speed2[0]) + std::sqrt(block.path.end_speed2[0]));
        cycle::DualHeadDda dda;
        Pulses4 line{};
        for (std::size_t k = 0; k < kAxisCount; ++k) line[k] = block.line_pulses[k];
        std::int64_t count = 0;
        const bool is_part = line != Pulses4{};
        if (is_part) {
            const auto longest = static_cast<std::size_t>(
                std::max_element(line.begin(), line.end(),
                                 [](auto a, auto b) { return std::abs(a) < std::abs(b); }) -
                line.begin());
            count = std::abs(block.delta_pulses[longest]);
            dda.start_within(line, block.line_done, count);
        } else {
            dda.start(block.delta_pulses);
        }
        const Pulses4& way = is_part ? line : block.delta_pulses;
        while (dda.iterations_left() > 0) {
            const std::uint32_t axes = dda.iterate();
            for (std::size_t k = 0; k < kAxisCount; ++k)
                if ((axes >> k & 1U) != 0) at[k] += way[k] < 0 ? -1 : 1;
            result.places.push_back({at, program_line(block)});
        }
        if (--left == 0) result.rests.push_back(at);
    }
    return result;
}

/// From a place to the polyline's nearest one around a line of the program (points[line] is where it ends),
/// in a head's space (R, r * psi, Y).
inline double off_polyline_mm(const MachineLimits& limits, const std::vector<Pulses4>& points,
                              std::uint64_t line, const Pulses4& at, std::size_t head) {
    constexpr std::uint64_t kLinesBeside = 10;
    const double radius_mm =
        static_cast<double>(at[head]) / limits.axes[head].pulses_per_unit + limits.tip_offset_mm[head];
    const double psi_mm = rad_from_pulses(1, limits.pulses_per_rev) * std::max(radius_mm, 0.0);
    const auto place = [&](const Pulses4& p) {
        return std::array{static_cast<double>(p[kPsi] - at[kPsi]) * psi_mm,
                          static_cast<double>(p[head] - at[head]) / limits.axes[head].pulses_per_unit,
                          static_cast<double>(p[kY] - at[kY]) / limits.axes[kY].pulses_per_unit};
    };
    double least_mm = 1e9;
    const std::uint64_t first = line > kLinesBeside ? line - kLinesBeside : 1;
    const std::uint64_t last = std::min<std::uint64_t>(line + kLinesBeside, points.size() - 1);
    for (std::uint64_t i = first; i <= last; ++i) {
        const auto from = place(points[i - 1]), to = place(points[i]);
        double along = 0.0, length2 = 0.0, off2 = 0.0;
        for (std::size_t d = 0; d < 3; ++d) {
            along -= from[d] * (to[d] - from[d]);
            length2 += (to[d] - from[d]) * (to[d] - from[d]);
        }
        const double share = length2 > 0.0 ? std::clamp(along / length2, 0.0, 1.0) : 0.0;
        for (std::size_t d = 0; d < 3; ++d) {
            const double part = from[d] + share * (to[d] - from[d]);
            off2 += part * part;
        }
        least_mm = std::min(least_mm, std::sqrt(off2));
    }
    return least_mm;
}

/// A program of ways alone and the points that they join.
struct WayScript {
    explicit WayScript(const Pulses4& start) : script(start), points{start} {}
    WayScript& way(const Pulses4& delta_pulses, double tolerance_mm) {
        script.way(delta_pulses, tolerance_mm);
        points.push_back(script.at());
        return *this;
    }
    Script script;
    std::vector<Pulses4> points;
};

}  // namespace psicarve::plan::test
