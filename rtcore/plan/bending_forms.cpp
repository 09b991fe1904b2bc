// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/plan/bending_forms.hpp"

#include <cmath>

namespace psicarve::plan {

PSICARVE_FOR_WIDE_REGISTERS
void BendingForms::set(const NodesView& nodes) {
    const std::size_t count = nodes.cell.size();
    bend.assign(count, Row{});
    value.assign(count, Row{0.0, 1.0, 0.0});
    weight.resize(count);
    for (std::size_t j = 0; j < count; ++j) load(nodes.weight[j], weight[j].axes);
    stiffness.assign(count, {});
    length = 0.0;
    double after = 1.0 / nodes.control_step[0];
    for (std::size_t j = 1; j + 1 < count; ++j) {
        const double before = after;
        after = 1.0 / nodes.control_step[j];
        const double cell = nodes.cell[j];
        length += cell;
        const double first = before / cell;
        const double last = after / cell;
        const double offset = nodes.offset[j];
        const double lift = 0.125 * cell * cell + 0.5 * offset * offset;
        const double tilt = 0.5 * offset;
        value[j] = {lift * first - tilt * before, 1.0 - lift * (first + last) + tilt * (before - after),
                    lift * last + tilt * after};
        const double root = std::sqrt(cell);
        const Row row{root * first, -root * (first + last), root * last};
        bend[j] = row;
        const Vec of_cell = weight[j].axes;
        stiffness[j - 1][0].axes += of_cell * (row.before * row.before);
        stiffness[j - 1][1].axes += of_cell * (row.before * row.at);
        stiffness[j - 1][2].axes += of_cell * (row.before * row.after);
        stiffness[j][0].axes += of_cell * (row.at * row.at);
        stiffness[j][1].axes += of_cell * (row.at * row.after);
        stiffness[j + 1][0].axes += of_cell * (row.after * row.after);
    }
}

}  // namespace psicarve::plan
