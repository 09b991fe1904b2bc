// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "rtcore/sim/sim_config.hpp"
#include "shared/machine/signal.hpp"

namespace psicarve::sim {

/// A cell of the blank's surface that a tip has cut, as a caliper would measure it.
struct Cut {
    double direction_deg;  ///< the workpiece direction of the cell's middle, 0 to 360
    double height_mm;      ///< its middle above the table
    double radius_mm;      ///< what is left
    Axis head;             ///< whose tip went deepest
};

/// The blank on the simulated table and what the two tips leave of it. Tips are points; they cut whether the
/// spindle turns or not. It uses the true positions of carriages and table, and the true mounting of the
/// heads (HeadConfig): a machine that differs from its core's profile carves another piece. cut() belongs to
/// the tick's thread; the others may be called when it has ended, first_touch_pulses() at any time.
class Workpiece {
public:
    /// Nothing when there is no memory for a blank of this size.
    static std::unique_ptr<Workpiece> make(const SimConfig& config);

    /// Tells it where carriages and table are now. RT: yes, but for a page fault where no tip has been
    /// before.
    void cut(Axis head, const std::array<std::int64_t, kAxisCount>& positions_pulses) noexcept;

    /// From the table up, each height by direction.
    std::vector<Cut> cuts() const;
    /// The head's position when its tip first met the blank.
    std::optional<std::int64_t> first_touch_pulses(Axis head) const noexcept;

private:
    struct Free {
        void operator()(std::uint32_t* cells) const noexcept { std::free(cells); }
    };
    using Cells = std::unique_ptr<std::uint32_t[], Free>;

    Workpiece(const SimConfig& config, std::size_t rows, Cells cells);

    static constexpr std::int64_t kUntouched = kForeverNs;

    std::array<HeadConfig, 2> heads_;
    std::array<double, kAxisCount> mm_per_pulse_{};
    double turns_per_pulse_;
    double blank_radius_mm_;
    std::size_t rows_;
    Cells cells_;  ///< by height, then direction; 0: as it was, else radius and head: see workpiece.cpp
    std::array<std::atomic<std::int64_t>, 2> touches_{kUntouched, kUntouched};
};

/// direction_deg,height_mm,radius_mm,head: a row for every cut.
std::string csv_of(const std::vector<Cut>& cuts);

}  // namespace psicarve::sim
