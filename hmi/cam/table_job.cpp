// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/table_job.hpp"

#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <new>
#include <string_view>
#include <utility>

#include "hmi/cam/blank_check.hpp"
#include "hmi/cam/core_share.hpp"
#include "hmi/cam/exported_table.hpp"
#include "hmi/cam/job_plan.hpp"
#include "hmi/cam/number_lines.hpp"
#include "hmi/cam/radius_tables.hpp"
#include "hmi/cam/rough_job.hpp"
#include "hmi/model/file_bytes.hpp"
#include "hmi/model/source_name.hpp"
#include "hmi/model/text_scan.hpp"
#include "hmi/tool/tool.hpp"
#include "shared/base/decimals.hpp"
#include "shared/base/trimmed.hpp"
#include "shared/base/units.hpp"

namespace psicarve::cam {
namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 30U;

enum class TableKind : std::uint8_t { none, mm, pulses, exported, exported_passes };

/// The content of a table's first line.
struct TableHead {
    TableKind kind = TableKind::none;
    char separator = ',';
};

TableHead head_of(std::string_view line) {
    const std::size_t mark = line.find_first_of(",;\t");
    if (mark == std::string_view::npos) return {};
    const char separator = line[mark];
    std::vector<std::string_view> names;
    while (!line.empty() && names.size() <= kExportNames.size() + kPassNames.size()) {
        const std::size_t end = line.find(separator);
        names.push_back(trimmed(line.substr(0, end)));
        line = end == std::string_view::npos ? std::string_view{} : line.substr(end + 1);
    }
    const auto begins = [&names](std::string_view height, std::string_view radius) {
        return names.size() >= 2 && names[0] == height && names[1].substr(0, radius.size()) == radius;
    };
    if (begins("y_mm", "r_mm")) return {TableKind::mm, separator};
    if (begins("y_pulses", "r_pulses")) return {TableKind::pulses, separator};
    std::vector<std::string_view> wanted(kExportNames.begin(), kExportNames.end());
    if (names == wanted) return {TableKind::exported, separator};
    wanted.insert(wanted.end(), kPassNames.begin(), kPassNames.end());
    if (names == wanted) return {TableKind::exported_passes, separator};
    return {TableKind::none, separator};
}

JobTable empty_table(const Profile& profile) {
    JobTable table;
    table.psi_sweep_pulses = profile.psi.pulses_per_rev / 2;
    table.feed_mm_s = profile.job.feed_mm_s;
    return table;
}

constexpr int kPlaces = 4;  // of a millimetre: a tenth of a usual pulse

/// Layers lie higher than those before, except where a pass begins, and where a spiral closes.
Result<void> check_rise(const JobTable& table, bool is_exported, const std::string& path) {
    const auto& heights = table.layer_height_pulses;
    auto pass = table.passes.begin();
    for (std::size_t layer = 1; layer < heights.size(); ++layer) {
        while (pass != table.passes.end() && pass->first_layer < layer) ++pass;
        const bool begins_pass = pass != table.passes.end() && pass->first_layer == layer;
        const bool closes = table.joining == Joining::spiral && layer + 1 == heights.size();
        const bool is_right =
            closes ? heights[layer] == heights[layer - 1] : heights[layer] > heights[layer - 1];
        if (is_right || begins_pass) continue;
        if (closes) return bad_input(path + ": the last row does not close the spiral");
        const bool may_have_passes = is_exported && table.passes.empty();
        return bad_input(path + ": layer " + std::to_string(layer) + " lies no higher than the one before" +
                         (may_have_passes ? ": a table of several passes needs the columns run to clear_mm; "
                                            "export the job again"
                                          : ""));
    }
    return {};
}

/// Refuses what check_job would refuse, in words for a table, which is neither scaled nor cut into other
/// layers.
Result<void> check_travel(const JobTable& table, const Profile& profile, bool is_exported,
                          const std::string& path) {
    const auto refused = [&](std::size_t at, Axis axis, std::int64_t pulses) {
        const AxisMotion motion = axis_motion(profile, axis);
        const auto text = [&motion](std::int64_t where) {
            return mm_text(mm_from_pulses(where, motion.pulses_per_unit), kPlaces);
        };
        return bad_input(table_place(path, at / table.point_count, at % table.point_count) + "axis " +
                         std::string(name_of(axis)) + " would have to go to " + text(pulses) +
                         ", but goes from " + text(motion.travel_min_pulses) + " to " +
                         text(motion.travel_max_pulses));
    };
    const auto is_beyond = [&profile](Axis axis) {
        return [motion = axis_motion(profile, axis)](std::int64_t pulses) {
            return pulses < motion.travel_min_pulses || pulses > motion.travel_max_pulses;
        };
    };
    if (auto rise = check_rise(table, is_exported, path); !rise) return rise.error();
    const auto& heights = table.layer_height_pulses;
    const auto high = std::find_if(heights.begin(), heights.end(), is_beyond(Axis::y));
    if (high != heights.end())
        return refused(static_cast<std::size_t>(high - heights.begin()) * table.point_count, Axis::y, *high);
    for (const Axis axis : {Axis::r1, Axis::r2}) {
        const auto& radii = axis == Axis::r1 ? table.r_left_pulses : table.r_right_pulses;
        const auto far = std::find_if(radii.begin(), radii.end(), is_beyond(axis));
        if (far != radii.end()) return refused(static_cast<std::size_t>(far - radii.begin()), axis, *far);
    }
    return {};
}

/// Rows of a height and the radii once round.
Result<BuiltJob> full_circles(NumberLines& lines, bool is_in_mm, const Profile& profile, Joining joining,
                              const std::string& path) {
    std::vector<std::vector<double>> rows;
    std::vector<double> row;
    BuiltJob built;
    built.table = empty_table(profile);
    built.table.joining = joining;
    std::size_t count = 0;
    while (true) {
        const auto more = lines.numbers(row);
        if (!more) return more.error();
        if (!*more) break;
        if (row.size() < 3) return lines.wrong("a layer needs its height and at least two radii");
        if (count != 0 && row.size() - 1 != count) {
            return lines.wrong(std::to_string(row.size() - 1) + " radii, but the layers before have " +
                               std::to_string(count));
        }
        count = row.size() - 1;
        built.table.layer_height_pulses.push_back(
            is_in_mm ? pulses_from_mm(row.front(), profile.y.pulses_per_mm) : round_to_pulse(row.front()));
        row.erase(row.begin());
        for (double& radius : row) radius = is_in_mm ? radius : radius / profile.r1.pulses_per_mm;
        const auto low = std::find_if(row.begin(), row.end(), [&](double radius_mm) {
            return radius_mm < profile.core_radius_mm - 0.5 / profile.r1.pulses_per_mm;
        });
        if (low != row.end()) {
            return bad_input(table_place(path, rows.size(), static_cast<std::size_t>(low - row.begin())) +
                             "a radius of " + mm_text(*low, kPlaces) + ", less than core_radius_mm, " +
                             mm_text(profile.core_radius_mm, kPlaces));
        }
        rows.push_back(row.size() % 2 == 0 ? row : evened(row));
    }
    if (rows.empty()) return bad_input(path + ": the table has no layers");
    const auto points = static_cast<std::int64_t>(rows.front().size() / 2 + 1);
    if (points > built.table.psi_sweep_pulses + 1) {
        return bad_input(path + ": more points than pulses: " + std::to_string(points) +
                         " points in half a turn of " + std::to_string(built.table.psi_sweep_pulses) +
                         " pulses");
    }
    built.table.layer_count = static_cast<std::uint32_t>(rows.size());
    built.table.point_count = static_cast<std::uint32_t>(points);
    RadiusTables tables(profile, built.table, 1.0);
    for (std::size_t layer = 0; layer < rows.size(); ++layer) {
        tables.fill_left(layer, rows[layer]);
        tables.fill_right(layer, rows[layer]);
    }
    if (auto fits = check_travel(built.table, profile, false, path); !fits) return fits.error();
    const CoreShare share = core_share(profile, built.table);
    if (share.is_all()) return core_alone(path, profile);
    warn_about_core(profile, share, built.report);
    tables.report(profile, built.report);
    if (count % 2 != 0) {
        built.report.notes.push_back("the table's " + std::to_string(count) +
                                     " points a circle are evened to " + std::to_string(count + 1));
    }
    if (profile.head_r2_angle_error_deg != 0.0 || profile.head_r2_height_error_mm != 0.0) {
        built.report.warnings.emplace_back(
            "the table is taken as it stands: R2's angle and height errors stay in it");
    }
    return built;
}

/// Notes how far in and out the finishing pass goes.
void note_radii(const Profile& profile, const JobTable& table, SliceReport& report) {
    const std::size_t first = finishing_layer(table) * table.point_count;
    report.r_min_mm = std::numeric_limits<double>::max();
    for (const Axis axis : {Axis::r1, Axis::r2}) {
        const LinearAxisProfile& head = axis == Axis::r1 ? profile.r1 : profile.r2;
        const auto& radii = axis == Axis::r1 ? table.r_left_pulses : table.r_right_pulses;
        const auto [least, most] =
            std::minmax_element(radii.begin() + static_cast<std::ptrdiff_t>(first), radii.end());
        const auto real_mm = [&head](std::int32_t counted) {
            return mm_from_pulses(counted, head.pulses_per_mm) + head.tip_mm();
        };
        report.r_min_mm = std::min(report.r_min_mm, real_mm(*least));
        report.r_max_mm = std::max(report.r_max_mm, real_mm(*most));
    }
}

/// Rows of a point, as they were exported.
Result<BuiltJob> exported(NumberLines& lines, bool has_passes, const Profile& profile,
                          std::optional<Joining> joining, const std::string& path) {
    BuiltJob built;
    auto table = exported_table(lines, has_passes, {joining, profile.job.joining},
                                reachable_radius(profile, 1.0), path);
    if (!table) return table.error();
    built.table = std::move(*table);
    built.table.feed_mm_s = profile.job.feed_mm_s;
    if (auto fits = check_travel(built.table, profile, true, path); !fits) return fits.error();
    note_radii(profile, built.table, built.report);
    const CoreShare share = core_share(profile, built.table);
    if (share.is_all()) return core_alone(path, profile);
    warn_about_core(profile, share, built.report);
    built.report.core_points = share.points;
    return built;
}

Result<BuiltJob> read(const std::vector<char>& bytes, const std::string& path, const Profile& profile,
                      std::optional<Joining> joining) {
    if (auto clear = check_heads_clear(profile.blank, profile); !clear)
        return bad_input(path + ": " + clear.error().message);
    NumberLines lines({bytes.data(), bytes.size()}, path);
    const std::string_view first = lines.line();
    const TableHead head = head_of(first);
    if (head.kind == TableKind::none) {
        return lines.wrong(model::quoted(first) +
                           " is no head of a table: y_mm,r_mm or y_pulses,r_pulses, "
                           "or what snapshot export writes");
    }
    lines.part_by(head.separator);
    const Joining chosen = joining.value_or(profile.job.joining);
    const bool has_passes = head.kind == TableKind::exported_passes;
    const bool is_exported = has_passes || head.kind == TableKind::exported;
    if (!is_exported && chosen == Joining::spiral) {
        return Error{ErrorCode::bad_usage,
                     path + ": a table of layers is no spiral: --joining continuous or zigzag"};
    }
    auto built = is_exported ? exported(lines, has_passes, profile, joining, path)
                             : full_circles(lines, head.kind == TableKind::mm, profile, chosen, path);
    if (!built) return built;
    hold_depth_limit(profile, built->table, built->report);
    warn_about_blank(profile, built->table, built->report);
    warn_about_layers(profile, built->table, built->report);
    note_what_meets_the_table(profile, built->table, built->report);
    built->report.format = kTableFormat;
    built->report.tool = tool::name_of(profile.tool);
    built->report.layers = built->table.layer_count;
    built->report.points = built->table.point_count;
    built->table.source_name = model::source_name_of(path);
    built->table.source_hash = XXH3_64bits(bytes.data(), bytes.size());
    built->table.profile_toml = profile_to_toml(profile);
    built->table.report_json = to_json(built->report);
    return built;
}

}  // namespace

std::vector<double> evened(const std::vector<double>& once_round) {
    const std::size_t n = once_round.size();
    std::vector<double> out(n + 1);
    for (std::size_t i = 0; i <= n; ++i) {
        const double at = static_cast<double>(i) * static_cast<double>(n) / static_cast<double>(n + 1);
        const auto left = static_cast<std::size_t>(at);
        const double share = at - static_cast<double>(left);
        out[i] = once_round[left] + share * (once_round[(left + 1) % n] - once_round[left]);
    }
    return out;
}

bool is_table_file(const std::string& path) {
    const auto file = model::InputFile::open(path);
    // Comments before the head may be long.
    std::vector<char> bytes(std::size_t{1} << 16U);
    if (!file) return false;
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size(), file->size_bytes()));
    if (!file->read(0, std::span(bytes).first(count))) return false;
    const std::string_view head = NumberLines({bytes.data(), count}, path).line();
    if (head_of(head).kind != TableKind::none) return true;
    // Even with a wrong head, its name shows its kind.
    const std::string extension = std::filesystem::path(path).extension().string();
    return (extension == ".csv" || extension == ".CSV") &&
           head.find_first_of(",;\t") != std::string_view::npos;
}

Result<BuiltJob> job_from_table(const std::string& path, const Profile& profile,
                                std::optional<Joining> joining) {
    const auto file = model::InputFile::open(path);
    if (!file) return file.error();
    if (file->size_bytes() > kMostBytes)
        return bad_input(path + ": more than a gigabyte, which no table needs");
    try {
        const auto bytes = file->read_all();
        if (!bytes) return bytes.error();
        auto built = read(*bytes, path, profile, joining);
        if (!built || profile.roughing.stepdown_mm == 0.0) return built;
        if (!built->table.passes.empty()) {
            built->report.notes.emplace_back("the table has roughing passes of its own: it gets no others");
            return built;
        }
        if (built->table.joining == Joining::spiral) {
            return bad_input(
                path +
                ": roughing needs level layers, which a table of a spiral does not have: slice the "
                "model with roughing, or leave it out with --finish-only");
        }
        const JobTable own = built->table;
        if (auto done = rough(*built, own, profile); !done) return done.error();
        return built;
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::out_of_room, path + ": too large for this computer's memory"};
    }
}

}  // namespace psicarve::cam
