// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/supervisor/piece_file.hpp"

#include <cstdio>
#include <span>
#include <utility>

#include "shared/base/units.hpp"
#include "shared/file/atomic_file.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::supervisor {

Result<void> put_blank_on_table(sim::Machine& machine, const sim::SimConfig& config) {
    if (config.blank.diameter_mm <= 0.0 || config.blank.height_mm <= 0.0) {
        return bad_input(
            "--piece: the simulated machine has no blank; blank.radius_mm and blank.height_mm in the profile "
            "of --machine (or --profile) say which");
    }
    auto workpiece = sim::Workpiece::make(config);
    if (workpiece == nullptr) return bad_input("--piece: no memory for a blank of this height");
    machine.set_workpiece(std::move(workpiece));
    return {};
}

Result<void> write_piece(const std::string& path, const sim::Machine& machine, const Profile& truth) {
    for (const Axis head : {Axis::r1, Axis::r2}) {
        const auto touch = machine.workpiece()->first_touch_pulses(head);
        if (!touch) continue;
        std::fprintf(stderr, "psicarve-rtcore: %s first touched the blank at %.4f mm\n",
                     std::string{name_of(head)}.c_str(),
                     mm_from_pulses(*touch, axis_motion(truth, head).pulses_per_unit));
    }
    const std::string text = sim::csv_of(machine.workpiece()->cuts());
    return write_file_atomically(path, std::as_bytes(std::span{text}));
}

}  // namespace psicarve::supervisor
