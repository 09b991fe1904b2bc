// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/reference/table_csv.hpp"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string_view>
#include <vector>

#include "shared/base/units.hpp"

namespace psicarve {
namespace {

struct Row {
    unsigned layer = 0;
    unsigned point = 0;
    std::int64_t y_pulses = 0;
    std::int64_t psi_pulses = 0;
    std::int32_t r_left_pulses = 0;
    std::int32_t r_right_pulses = 0;
};

Result<std::vector<Row>> read_rows(const std::string& path, LayerRange range) {
    std::ifstream file(path);
    std::vector<Row> rows;
    std::string line;
    // A job with passes has more columns.
    constexpr std::string_view kHead = "layer,point,y_pulses,psi_pulses,r_left_pulses,r_right_pulses";
    if (!std::getline(file, line) || !line.starts_with(kHead)) {
        return bad_input(path + ": not an exported table");
    }
    while (std::getline(file, line)) {
        Row row;
        long long y = 0;
        long long psi = 0;
        if (std::sscanf(line.c_str(), "%u,%u,%lld,%lld,%d,%d", &row.layer, &row.point, &y, &psi,
                        &row.r_left_pulses, &row.r_right_pulses) != 6) {
            return bad_input(std::string(path).append(": not a row of a table: ").append(line));
        }
        row.y_pulses = y;
        row.psi_pulses = psi;
        if (row.layer >= range.first && row.layer <= range.last) rows.push_back(row);
    }
    if (rows.size() < 2) return bad_input(path + ": no such layers");
    return rows;
}

/// The rows become a job's layers from 0 on, its first point at psi = 0.
Result<JobTable> table_of(const std::vector<Row>& rows, const Profile& profile) {
    const auto in_layer = [&](const Row& row) { return row.layer == rows.front().layer; };
    JobTable table;
    table.point_count = static_cast<std::uint32_t>(std::ranges::count_if(rows, in_layer));
    table.layer_count = static_cast<std::uint32_t>(rows.size() / table.point_count);
    const std::int64_t first_psi = rows.front().psi_pulses;
    table.psi_sweep_pulses = rows[table.point_count - 1].psi_pulses - first_psi;
    table.feed_mm_s = profile.job.feed_mm_s;
    table.source_name = "table.csv";
    table.profile_toml = profile_to_toml(profile);
    table.report_json = "{}";
    for (std::size_t at = 0; at < rows.size(); ++at) {
        const auto layer = static_cast<std::int64_t>(at / table.point_count);
        const auto point = static_cast<std::int64_t>(at % table.point_count);
        const std::int64_t psi =
            table_angle_pulses(table.joining, table.psi_sweep_pulses, table.point_count, layer, point);
        if (rows[at].psi_pulses - first_psi != psi) {
            return bad_input("layer " + std::to_string(layer) + ", point " + std::to_string(point) +
                             ": not at its angle of a continuous job");
        }
        if (point == 0) table.layer_height_pulses.push_back(rows[at].y_pulses);
        table.r_left_pulses.push_back(rows[at].r_left_pulses);
        table.r_right_pulses.push_back(rows[at].r_right_pulses);
    }
    return table;
}

}  // namespace

Result<JobTable> table_from_csv(const std::string& path, const Profile& profile, LayerRange range) {
    const auto rows = read_rows(path, range);
    if (!rows) return rows.error();
    return table_of(*rows, profile);
}

}  // namespace psicarve
