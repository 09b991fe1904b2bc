// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/table_job.hpp"

#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <new>
#include <string_view>
#include <utility>

#include "hmi/cam/blank_check.hpp"
#include "hmi/cam/radius_tables.hpp"
#include "hmi/cam/rough_job.hpp"
#include "hmi/model/file_bytes.hpp"
#include "hmi/model/text_scan.hpp"
#include "hmi/tool/tool.hpp"
#include "shared/decimals.hpp"
#include "shared/trimmed.hpp"
#include "shared/units.hpp"

namespace psicarve::cam {
namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 30U;
constexpr std::array<std::string_view, 6> kExportNames{"layer",      "point",         "y_pulses",
                                                       "psi_pulses", "r_left_pulses", "r_right_pulses"};
constexpr double kFarthest = 1e9;  // mm or pulses: far beyond every machine, and safe to calculate with

enum class TableKind : std::uint8_t { none, mm, pulses, exported };

/// What a table's first line says.
struct TableHead {
    TableKind kind = TableKind::none;
    char separator = ',';
};

TableHead head_of(std::string_view line) {
    const std::size_t mark = line.find_first_of(",;\t");
    if (mark == std::string_view::npos) return {};
    const char separator = line[mark];
    std::vector<std::string_view> names;
    while (!line.empty() && names.size() <= kExportNames.size()) {
        const std::size_t end = line.find(separator);
        names.push_back(trimmed(line.substr(0, end)));
        line = end == std::string_view::npos ? std::string_view{} : line.substr(end + 1);
    }
    const auto begins = [&names](std::string_view height, std::string_view radius) {
        return names.size() >= 2 && names[0] == height && names[1].substr(0, radius.size()) == radius;
    };
    if (begins("y_mm", "r_mm")) return {TableKind::mm, separator};
    if (begins("y_pulses", "r_pulses")) return {TableKind::pulses, separator};
    if (std::equal(names.begin(), names.end(), kExportNames.begin(), kExportNames.end()))
        return {TableKind::exported, separator};
    return {TableKind::none, separator};
}

/// Lines of numbers between commas or semicolons; empty lines and those that begin with '#' are passed over.
/// Where the head has semicolons or tabs, these alone part numbers, and a comma stands before decimals, as
/// spreadsheets of half of Europe write.
class NumberLines {
public:
    NumberLines(std::string_view text, const std::string& file)
        : text_(model::without_byte_order_mark(text)), file_(file) {}

    /// The next line as it stands; empty at the end.
    std::string_view line() {
        while (!text_.empty()) {
            const std::size_t end = text_.find('\n');
            const std::string_view taken = trimmed(text_.substr(0, end));
            text_ = end == std::string_view::npos ? std::string_view{} : text_.substr(end + 1);
            ++number_;
            if (!taken.empty() && taken.front() != '#') return taken;
        }
        return {};
    }
    void part_by(char separator) { separators_ = separator == ',' ? ",;" : separator == ';' ? ";" : "\t"; }
    /// False at the end.
    Result<bool> numbers(std::vector<double>& out) {
        out.clear();
        std::string_view rest = line();
        if (rest.empty()) return false;
        while (!rest.empty()) {
            const std::size_t end = rest.find_first_of(separators_);
            std::string word(trimmed(rest.substr(0, end)));
            if (separators_.find(',') == std::string_view::npos)
                std::replace(word.begin(), word.end(), ',', '.');
            rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
            if (word.empty() && trimmed(rest).empty()) break;  // a comma at the line's end
            const auto value = model::number(word);
            if (!value || !(std::abs(*value) <= kFarthest)) {
                return wrong(model::quoted(word) + " is not a number that a table can hold");
            }
            out.push_back(*value);
        }
        return true;
    }
    Error wrong(const std::string& what) const {
        return bad_input(file_ + " line " + std::to_string(number_) + ": " + what);
    }

private:
    std::string_view text_;
    std::string file_;
    std::string_view separators_ = ",;";
    std::size_t number_ = 0;
};

JobTable empty_table(const Profile& profile) {
    JobTable table;
    table.psi_sweep_pulses = profile.psi.pulses_per_rev / 2;
    table.feed_mm_s = profile.job.feed_mm_s;
    return table;
}

constexpr int kPlaces = 4;  // of a millimetre: a tenth of a usual pulse

std::string place(const std::string& path, std::size_t layer, std::size_t point) {
    return path + ": layer " + std::to_string(layer) + ", point " + std::to_string(point) + ": ";
}

/// What check_job would refuse, said of a table, which is neither scaled nor cut into other layers.
Result<void> check_travel(const JobTable& table, const Profile& profile, const std::string& path) {
    const auto refused = [&](std::size_t at, Axis axis, std::int64_t pulses) {
        const AxisMotion motion = axis_motion(profile, axis);
        const auto text = [&motion](std::int64_t where) {
            return mm_text(mm_from_pulses(where, motion.pulses_per_unit), kPlaces);
        };
        return bad_input(place(path, at / table.point_count, at % table.point_count) + "axis " +
                         std::string(name_of(axis)) + " would have to go to " + text(pulses) +
                         ", but goes from " + text(motion.travel_min_pulses) + " to " +
                         text(motion.travel_max_pulses));
    };
    const auto is_beyond = [&profile](Axis axis) {
        return [motion = axis_motion(profile, axis)](std::int64_t pulses) {
            return pulses < motion.travel_min_pulses || pulses > motion.travel_max_pulses;
        };
    };
    const auto& heights = table.layer_height_pulses;
    for (std::size_t layer = 1; layer < heights.size(); ++layer) {
        if (heights[layer] > heights[layer - 1]) continue;
        return bad_input(path + ": layer " + std::to_string(layer) + " lies no higher than the one before");
    }
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
            return bad_input(place(path, rows.size(), static_cast<std::size_t>(low - row.begin())) +
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
    if (auto fits = check_travel(built.table, profile, path); !fits) return fits.error();
    tables.report(built.report);
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

/// Whether point `point` of `layer` stands where a job of this joining has it.
bool stands_right(const JobTable& table, Joining joining, std::size_t layer, std::size_t point, double psi,
                  double first_psi) {
    const std::int64_t wanted =
        table_angle_pulses(joining, table.psi_sweep_pulses, table.point_count,
                           static_cast<std::int64_t>(layer), static_cast<std::int64_t>(point));
    return psi - first_psi == static_cast<double>(wanted);
}

/// Rows of a point, as they were exported.
Result<BuiltJob> exported(NumberLines& lines, const Profile& profile, const std::string& path) {
    BuiltJob built;
    JobTable& table = built.table;
    table = empty_table(profile);
    std::vector<double> row;
    std::vector<double> psi;
    std::vector<double> height;
    while (true) {
        const auto more = lines.numbers(row);
        if (!more) return more.error();
        if (!*more) break;
        if (row.size() != 6) return lines.wrong(std::to_string(row.size()) + " numbers, not 6");
        for (const double number : row) {
            if (number != std::floor(number)) return lines.wrong("pulses and counts are whole numbers");
        }
        // Layers and points may begin at any layer of a longer job; within they follow each other.
        if (row[1] == 0.0) ++table.layer_count;
        if (table.layer_count <= 1) ++table.point_count;
        const std::size_t at = psi.size();
        if (table.layer_count == 0 || row[1] != static_cast<double>(at % table.point_count)) {
            return lines.wrong("points do not follow each other from 0 on, as many in each layer");
        }
        height.push_back(row[2]);
        psi.push_back(row[3]);
        table.r_left_pulses.push_back(static_cast<std::int32_t>(row[4]));
        table.r_right_pulses.push_back(static_cast<std::int32_t>(row[5]));
    }
    if (psi.empty() || psi.size() != std::size_t{table.layer_count} * table.point_count) {
        return bad_input(path + ": the table's last layer is not whole, or there is none");
    }
    table.psi_sweep_pulses = static_cast<std::int64_t>(psi[table.point_count - 1] - psi[0]);
    bool is_continuous = true;
    bool is_zigzag = true;
    for (std::size_t i = 0; i < psi.size(); ++i) {
        const std::size_t layer = i / table.point_count;
        const std::size_t point = i % table.point_count;
        is_continuous =
            is_continuous && stands_right(table, Joining::continuous, layer, point, psi[i], psi[0]);
        is_zigzag = is_zigzag && stands_right(table, Joining::zigzag, layer, point, psi[i], psi[0]);
        if (!is_continuous && !is_zigzag) {
            return bad_input(place(path, layer, point) +
                             "psi is not where a continuous or zigzag job has it");
        }
        if (point == 0) {
            const auto own = height.begin() + static_cast<std::ptrdiff_t>(i);
            const auto rises =
                std::find_if(own, own + table.point_count, [&](double y) { return y != *own; });
            if (rises != own + table.point_count) {
                return bad_input(place(path, layer, static_cast<std::size_t>(rises - own)) +
                                 "another height than the layer's first point: tables of spirals cannot be "
                                 "read back; keep "
                                 "the job file");
            }
            if (layer > 0 && height[i] <= static_cast<double>(table.layer_height_pulses.back())) {
                return bad_input(
                    path + ": layer " + std::to_string(layer) +
                    " lies no higher than the one before: a table of several passes does not say "
                    "where each begins and cannot be read back; keep the job file");
            }
            table.layer_height_pulses.push_back(static_cast<std::int64_t>(height[i]));
        }
    }
    table.joining = is_continuous ? Joining::continuous : Joining::zigzag;
    if (auto fits = check_travel(table, profile, path); !fits) return fits.error();
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
    if (head.kind != TableKind::exported && chosen == Joining::spiral) {
        return Error{ErrorCode::bad_usage,
                     path + ": a table of layers is no spiral: --joining continuous or zigzag"};
    }
    auto built = head.kind == TableKind::exported
                     ? exported(lines, profile, path)
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
    built->table.source_name = std::filesystem::path(path).filename().string();
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
    std::array<char, 256> bytes{};
    if (!file) return false;
    const auto count = static_cast<std::size_t>(std::min<std::uint64_t>(bytes.size(), file->size_bytes()));
    if (!file->read(0, std::span(bytes).first(count))) return false;
    const std::string_view head = NumberLines({bytes.data(), count}, path).line();
    if (head_of(head).kind != TableKind::none) return true;
    // With a head that is wrong, it is still what its name says.
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
        const JobTable own = built->table;
        if (auto done = rough(*built, own, profile); !done) return done.error();
        return built;
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::out_of_room, path + ": too large for this computer's memory"};
    }
}

}  // namespace psicarve::cam
