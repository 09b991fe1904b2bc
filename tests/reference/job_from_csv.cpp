// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a job file of a table as `psicarve snapshot export --format csv` prints it, whole or some layers of
// it.
//
//   job_from_csv TABLE.csv PROFILE.toml OUT.job [FIRST-LAST]

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include "shared/job.hpp"
#include "shared/profile.hpp"
#include "shared/result.hpp"
#include "shared/snapshot_file.hpp"
#include "shared/units.hpp"

namespace {

using namespace psicarve;

struct Row {
    unsigned layer = 0;
    unsigned point = 0;
    std::int64_t y_pulses = 0;
    std::int64_t psi_pulses = 0;
    std::int32_t r_left_pulses = 0;
    std::int32_t r_right_pulses = 0;
};

struct LayerRange {
    unsigned first = 0;
    unsigned last = UINT32_MAX;
};

Result<LayerRange> parse_range(const std::string& text) {
    LayerRange range;
    if (std::sscanf(text.c_str(), "%u-%u", &range.first, &range.last) != 2 || range.last < range.first) {
        return bad_input(text + ": a range of layers looks like 3-5");
    }
    return range;
}

Result<std::vector<Row>> read_rows(const std::string& path, LayerRange range) {
    std::ifstream file(path);
    std::vector<Row> rows;
    std::string line;
    if (!std::getline(file, line) || line != "layer,point,y_pulses,psi_pulses,r_left_pulses,r_right_pulses") {
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

Result<void> convert(const std::vector<std::string>& words) {
    const auto range = words.size() > 3 ? parse_range(words[3]) : Result<LayerRange>(LayerRange{});
    if (!range) return range.error();
    const auto profile = load_profile(words[1]);
    if (!profile) return profile.error();
    const auto rows = read_rows(words[0], *range);
    if (!rows) return rows.error();
    const auto table = table_of(*rows, *profile);
    if (!table) return table.error();
    Snapshot file;
    file.job_blob = job_blob_from_table(*table);
    const auto view = JobView::check(file.job_blob);
    if (!view) return view.error();
    if (const auto fits = check_job(*view, *profile); !fits) return fits;
    return save_snapshot(file, words[2]);
}

}  // namespace

int main(int argc, char** argv) {
    const std::vector<std::string> words(argv + 1, argv + argc);
    if (words.size() < 3 || words.size() > 4) {
        std::fprintf(stderr, "usage: %s TABLE.csv PROFILE.toml OUT.job [FIRST-LAST]\n", argv[0]);
        return 2;
    }
    const auto done = convert(words);
    if (!done) std::fprintf(stderr, "job_from_csv: %s\n", done.error().message.c_str());
    return done ? 0 : 3;
}
