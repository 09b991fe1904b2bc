// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/exported_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace psicarve::cam {
namespace {

constexpr std::size_t kRun = kExportNames.size();

/// The runs of layers that rows name, one after the other.
class PassRuns {
public:
    /// What the row says is wrong, or nothing. `begins_layer`: the row is the first of its layer.
    std::string add(std::span<const double> row, std::uint32_t layer, bool begins_layer) {
        const std::span<const double> said = row.subspan(kRun);
        if (std::equal(said.begin(), said.end(), said_.begin(), said_.end())) {
            if (begins_layer) ++passes_.back().layer_count;
            return {};
        }
        if (!begins_layer) return "another run than that of the layer's first point";
        const auto follows = [&](std::size_t column) { return said[column] == said_[column] + 1.0; };
        const bool is_next = passes_.empty() || (follows(0) && (said[1] == said_[1] || follows(1)));
        if (!is_next) return "runs and passes do not count on by one";
        for (const double length_mm : said.subspan(2)) {
            if (!(length_mm >= 0.0 && length_mm <= kMostPassRadius_mm)) return "a pass has no such length";
        }
        if (passes_.empty()) first_pass_ = said[1];
        said_.assign(said.begin(), said.end());
        passes_.push_back({static_cast<std::uint32_t>(PassKind::roughing),
                           static_cast<std::uint32_t>(said[1] - first_pass_) + 1, layer, 1, said[2], said[3],
                           said[4]});
        return {};
    }
    std::vector<JobPass> take() {
        if (!passes_.empty()) passes_.back().kind = static_cast<std::uint32_t>(PassKind::finishing);
        return std::move(passes_);
    }

private:
    std::vector<double> said_;
    double first_pass_ = 0.0;
    std::vector<JobPass> passes_;
};

/// Where each point stands, and whether a joining has it there.
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

/// What all points of a table allow.
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
                return bad_input(table_place(path, layer, point) +
                                 "psi is not where a continuous or zigzag job has it");
            }
            fits.level = fits.level && places.is_level(layer, point);
            // A spiral turns on and on.
            fits.rising = fits.rising && fits.continuous && places.rises(layer, point);
            if (!fits.level && !fits.rising) {
                return bad_input(table_place(path, layer, point) +
                                 "the height is neither its layer's nor on a spiral's way up");
            }
        }
    }
    return fits;
}

Joining joining_of(const Fits& fits, Joining chosen) {
    const auto is_possible = [&fits](Joining joining) {
        if (joining == Joining::spiral) return fits.rising;
        return fits.level && (joining == Joining::zigzag ? fits.zigzag : fits.continuous);
    };
    for (const Joining joining : {chosen, Joining::continuous, Joining::zigzag}) {
        if (is_possible(joining)) return joining;
    }
    return Joining::spiral;
}

Result<void> read_rows(NumberLines& lines, bool has_passes, JobTable& table, Places& places) {
    const std::size_t width = kRun + (has_passes ? kPassNames.size() : 0);
    const std::size_t counts = has_passes ? kRun + 2 : kRun;
    PassRuns runs;
    std::vector<double> row;
    while (true) {
        const auto more = lines.numbers(row);
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
        if (table.layer_count == 0 || row[1] != static_cast<double>(places.count() % table.point_count)) {
            return lines.wrong("points do not follow each other from 0 on, as many in each layer");
        }
        if (has_passes) {
            const std::string problem = runs.add(row, table.layer_count - 1, begins_layer);
            if (!problem.empty()) return lines.wrong(problem);
        }
        places.add(row[2], row[3]);
        table.r_left_pulses.push_back(static_cast<std::int32_t>(row[4]));
        table.r_right_pulses.push_back(static_cast<std::int32_t>(row[5]));
    }
    table.passes = runs.take();
    return {};
}

}  // namespace

Result<JobTable> exported_table(NumberLines& lines, bool has_passes, Joining chosen,
                                const std::string& path) {
    JobTable table;
    Places places(table);
    if (const auto read = read_rows(lines, has_passes, table, places); !read) return read.error();
    if (places.count() == 0 || places.count() != std::size_t{table.layer_count} * table.point_count)
        return bad_input(path + ": the table's last layer is not whole, or there is none");
    if (table.point_count < 2) return bad_input(path + ": a layer of one point goes nowhere; it needs two");
    const std::size_t last = table.point_count - 1;
    table.psi_sweep_pulses = static_cast<std::int64_t>(places.psi_at(0, last) - places.psi_at(0, 0));
    for (std::size_t layer = 0; layer < table.layer_count; ++layer)
        table.layer_height_pulses.push_back(static_cast<std::int64_t>(places.y_at(layer, last)));
    const auto fits = fits_of(table, places, path);
    if (!fits) return fits.error();
    table.joining = joining_of(*fits, chosen);
    return table;
}

}  // namespace psicarve::cam
