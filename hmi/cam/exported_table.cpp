// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/exported_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "shared/base/decimals.hpp"

namespace psicarve::cam {
namespace {

constexpr std::size_t kRun = kExportNames.size();
constexpr std::size_t kPsi = 3;
constexpr double kSameLength_mm = 1e-6;
constexpr double kFarthestPsi_pulses = 9007199254740992.0;  // 2^53: whole numbers so far are exact

/// The runs of layers that rows name, one after the other.
class PassRuns {
public:
    explicit PassRuns(double most_mm) : most_mm_(most_mm) {}
    /// Returns what is wrong with the row, or nothing. `begins_layer`: the row is the first of its layer.
    std::string add(std::span<const double> row, std::uint32_t layer, bool begins_layer) {
        const std::span<const double> said = row.subspan(kRun);
        if (std::equal(said.begin(), said.end(), said_.begin(), said_.end())) {
            if (begins_layer) ++passes_.back().layer_count;
            return {};
        }
        if (!begins_layer) return "another run than that of the layer's first point";
        const auto follows = [&](std::size_t column) { return said[column] == said_[column] + 1.0; };
        if (passes_.size() == kMaxJobPasses)
            return "more than " + std::to_string(kMaxJobPasses) + " runs, which no job has";
        const bool is_next = passes_.empty() || (follows(0) && (said[1] == said_[1] || follows(1)));
        if (!is_next) return "runs and passes do not count on by one";
        for (std::size_t column = 2; column < said.size(); ++column) {
            const std::string place = "column " + std::string(kPassNames[column]) + ": ";
            if (!(said[column] >= 0.0)) return place + "a pass has no such length";
            if (said[column] > most_mm_ + kSameLength_mm)
                return place + mm_text(said[column]) + ", but the heads clear no more than " +
                       mm_text(most_mm_);
        }
        if (passes_.empty()) first_pass_ = said[1];
        said_.assign(said.begin(), said.end());
        passes_.push_back({static_cast<std::uint32_t>(PassKind::roughing),
                           static_cast<std::uint32_t>(said[1] - first_pass_) + 1, layer, 1, said[2], said[3],
                           said[4]});
        return {};
    }
    /// Whether the last run can be the finishing pass: the job may have been cut off before it.
    bool is_finished() const {
        if (passes_.empty()) return true;
        const JobPass& last = passes_.back();
        const bool is_own_pass = passes_.size() == 1 || passes_[passes_.size() - 2].number != last.number;
        return is_own_pass && last.allowance_mm == 0.0 && last.depth_mm == 0.0;
    }
    std::vector<JobPass> take() {
        if (!passes_.empty()) passes_.back().kind = static_cast<std::uint32_t>(PassKind::finishing);
        return std::move(passes_);
    }

private:
    double most_mm_;
    std::vector<double> said_;
    double first_pass_ = 0.0;
    std::vector<JobPass> passes_;
};

/// The place of each point, and whether a joining has it there.
class Places {
public:
    explicit Places(const JobTable& table) : table_(table) {}
    void add(double y_pulses, double psi_pulses) {
        y_.push_back(y_pulses);
        psi_.push_back(psi_pulses);
    }
    std::size_t count() const noexcept { return psi_.size(); }
    double y_at(std::size_t layer, std::size_t point) const { return y_[layer * table_.point_count + point]; }
    double psi_at(std::size_t layer, std::size_t point) const {
        return psi_[layer * table_.point_count + point];
    }
    bool turns_as(Joining joining, std::size_t layer, std::size_t point) const {
        const std::int64_t wanted =
            table_angle_pulses(joining, table_.psi_sweep_pulses, table_.point_count,
                               static_cast<std::int64_t>(layer), static_cast<std::int64_t>(point));
        return psi_at(layer, point) - psi_.front() == static_cast<double>(wanted);
    }
    bool is_level(std::size_t layer, std::size_t point) const {
        return y_at(layer, point) == y_at(layer, table_.point_count - 1);
    }
    /// As a row of the spiral that the finishing pass would be.
    bool rises(std::size_t layer, std::size_t point) const {
        if (layer <= finishing_layer()) return is_level(layer, point);
        const std::int64_t wanted =
            table_height_pulses(Joining::spiral, table_.layer_height_pulses, table_.point_count, layer,
                                static_cast<std::int64_t>(point));
        return y_at(layer, point) == static_cast<double>(wanted);
    }
    std::size_t finishing_layer() const noexcept {
        return table_.passes.empty() ? 0 : table_.passes.back().first_layer;
    }

private:
    const JobTable& table_;
    std::vector<double> y_;
    std::vector<double> psi_;
};

/// The joinings that all points of a table allow.
struct Fits {
    bool continuous = true;
    bool zigzag = true;
    bool level = true;
    bool rising = true;
};

Result<Fits> fits_of(const JobTable& table, const Places& places, const std::string& path) {
    Fits fits;
    for (std::size_t layer = 0; layer < table.layer_count; ++layer) {
        for (std::size_t point = 0; point < table.point_count; ++point) {
            fits.continuous = fits.continuous && places.turns_as(Joining::continuous, layer, point);
            fits.zigzag = fits.zigzag && places.turns_as(Joining::zigzag, layer, point);
            if (!fits.continuous && !fits.zigzag) {
                return bad_input(table_place(path, layer, point) + "psi is not where any joining has it");
            }
            fits.level = fits.level && places.is_level(layer, point);
            // A spiral keeps turning.
            fits.rising = fits.rising && fits.continuous && places.rises(layer, point);
            if (!fits.level && !fits.rising) {
                return bad_input(table_place(path, layer, point) +
                                 "the height is neither its layer's nor on a spiral's way up");
            }
        }
    }
    return fits;
}

bool is_possible(const Fits& fits, Joining joining) {
    if (joining == Joining::spiral) return fits.rising;
    return fits.level && (joining == Joining::zigzag ? fits.zigzag : fits.continuous);
}

Joining joining_of(const Fits& fits, Joining usual) {
    for (const Joining joining : {usual, Joining::continuous, Joining::zigzag}) {
        if (is_possible(fits, joining)) return joining;
    }
    return Joining::spiral;
}

/// What is wrong with a row's place, or nothing.
std::string wrong_place(std::span<const double> row, double layer_before, const JobTable& table,
                        std::size_t count) {
    if (table.layer_count == 0 || row[1] != static_cast<double>(count % table.point_count))
        return "points do not follow each other from 0 on, as many in each layer";
    const bool is_first = count == 0;
    if (!is_first && row[0] != layer_before + (row[1] == 0.0 ? 1.0 : 0.0))
        return "layers do not count on by one";
    for (std::size_t column = 0; column < row.size(); ++column) {
        if (column != kPsi && std::abs(row[column]) > NumberLines::kFarthest)
            return "a number that no machine has";
    }
    return {};
}

Result<void> read_rows(NumberLines& lines, bool has_passes, double most_pass_mm, JobTable& table,
                       Places& places, const std::string& path) {
    const std::size_t width = kRun + (has_passes ? kPassNames.size() : 0);
    const std::size_t counts = has_passes ? kRun + 2 : kRun;
    PassRuns runs(most_pass_mm);
    std::vector<double> row;
    double layer_before = 0.0;
    while (true) {
        // Psi counts on through all layers.
        const auto more = lines.numbers(row, kFarthestPsi_pulses);
        if (!more) return more.error();
        if (!*more) break;
        if (row.size() != width)
            return lines.wrong(std::to_string(row.size()) + " numbers, not " + std::to_string(width));
        for (const double number : std::span(row).first(counts)) {
            if (number != std::floor(number)) return lines.wrong("pulses and counts are whole numbers");
        }
        // Layers and points may begin at any layer of a longer job; within they follow each other.
        const bool begins_layer = row[1] == 0.0;
        if (begins_layer) ++table.layer_count;
        if (table.layer_count <= 1) ++table.point_count;
        const std::string misplaced = wrong_place(row, layer_before, table, places.count());
        if (!misplaced.empty()) return lines.wrong(misplaced);
        layer_before = row[0];
        if (has_passes) {
            const std::string problem = runs.add(row, table.layer_count - 1, begins_layer);
            if (!problem.empty()) return lines.wrong(problem);
        }
        places.add(row[2], row[3]);
        table.r_left_pulses.push_back(static_cast<std::int32_t>(row[4]));
        table.r_right_pulses.push_back(static_cast<std::int32_t>(row[5]));
    }
    if (!runs.is_finished()) {
        return bad_input(path +
                         ": the finishing pass is missing: the last run is of a roughing pass, and leaves "
                         "what the model does not have");
    }
    table.passes = runs.take();
    return {};
}

}  // namespace

Result<JobTable> exported_table(NumberLines& lines, bool has_passes, const WishedJoining& wished,
                                double most_pass_mm, const std::string& path) {
    JobTable table;
    Places places(table);
    if (const auto read = read_rows(lines, has_passes, most_pass_mm, table, places, path); !read)
        return read.error();
    if (places.count() == 0 || places.count() != std::size_t{table.layer_count} * table.point_count)
        return bad_input(path + ": the table's last layer is not whole, or there is none");
    if (table.point_count < 2) return bad_input(path + ": a layer of one point goes nowhere; it needs two");
    const std::size_t last = table.point_count - 1;
    const double sweep_pulses = places.psi_at(0, last) - places.psi_at(0, 0);
    if (std::abs(sweep_pulses) > NumberLines::kFarthest)
        return bad_input(path + ": psi goes further in a layer than any machine");
    table.psi_sweep_pulses = static_cast<std::int64_t>(sweep_pulses);
    for (std::size_t layer = 0; layer < table.layer_count; ++layer)
        table.layer_height_pulses.push_back(static_cast<std::int64_t>(places.y_at(layer, last)));
    const auto fits = fits_of(table, places, path);
    if (!fits) return fits.error();
    table.joining = joining_of(*fits, wished.usual);
    if (wished.asked && !is_possible(*fits, *wished.asked)) {
        return Error{ErrorCode::bad_usage,
                     path + ": its points stand as a " + std::string(name_of(table.joining)) +
                         " job has them: not --joining " + std::string(name_of(*wished.asked))};
    }
    return table;
}

}  // namespace psicarve::cam
