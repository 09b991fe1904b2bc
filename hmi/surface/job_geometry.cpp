// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/surface/job_geometry.hpp"

#include <algorithm>
#include <cstdlib>
#include <limits>
#include <string>

#include "shared/base/units.hpp"
#include "shared/job/outside.hpp"

namespace psicarve::verify {

namespace {

// A head's rows in one direction are two apart in a spiral.
constexpr std::uint32_t kRowsAround = 3;

std::int64_t wrapped(std::int64_t angle_pulses, std::int64_t rev_pulses) noexcept {
    const std::int64_t rest = angle_pulses % rev_pulses;
    return rest < 0 ? rest + rev_pulses : rest;
}

Result<void> check_countable(const JobView& job, const Profile& profile) {
    if (job.layer_count() < 1 || job.point_count() < 2)
        return bad_input("the job has no points to verify: " + std::to_string(job.layer_count()) +
                         " layers of " + std::to_string(job.point_count()) + " points");
    const std::int64_t rev = profile.psi.pulses_per_rev;
    if (rev < 2 || job.psi_sweep_pulses() * 2 != rev)
        return bad_input("the job sweeps " + std::to_string(job.psi_sweep_pulses()) +
                         " psi pulses a layer, but half a revolution of the profile \"" + profile.name +
                         "\" is " + std::to_string(rev / 2) +
                         "; verify with the profile that the job was made for");
    if (profile.r1.pulses_per_mm <= 0.0 || profile.r2.pulses_per_mm <= 0.0 || profile.y.pulses_per_mm <= 0.0)
        return bad_input("the profile \"" + profile.name + "\" has an axis without pulses per mm");
    return {};
}

HeadGeometry head_of(const LinearAxisProfile& axis) {
    HeadGeometry head;
    head.pulses_per_mm = axis.pulses_per_mm;
    head.tip_offset_mm = axis.tip_mm();
    return head;
}

}  // namespace

Result<JobGeometry> JobGeometry::make(const JobView& job, const Profile& profile, const LayerRange& layers) {
    auto countable = check_countable(job, profile);
    if (!countable) return countable.error();
    if (layers.first >= job.layer_count()) {
        return bad_input("the job has " + std::to_string(job.layer_count()) + " layers, from 0 on: none is " +
                         std::to_string(layers.first));
    }
    const std::uint32_t first_point = layers.first_point.value_or(0);
    const std::uint32_t step = carved_point(job.joining(), job.point_count(), layers.first, first_point);
    if (first_point >= job.point_count() || (layers.first_point && step + 1 == job.point_count())) {
        return bad_input("a layer of the job has " + std::to_string(job.point_count()) +
                         " points, from 0 on: no carving begins with point " + std::to_string(first_point) +
                         " of layer " + std::to_string(layers.first));
    }
    JobGeometry g;
    const std::uint32_t left = job.layer_count() - layers.first;
    g.first_layer_ = layers.first;
    g.first_step_ = layers.first_point ? step : 0;
    g.end_layer_ = layers.first + (layers.count == 0 ? left : std::min(layers.count, left));
    g.job_ = job;
    g.heads_ = {head_of(profile.r1), head_of(profile.r2)};
    g.rev_pulses_ = profile.psi.pulses_per_rev;
    g.heads_[1].facing_pulses =
        g.rev_pulses_ / 2 + pulses_from_deg(profile.head_r2_angle_error_deg, g.rev_pulses_);
    g.heads_[1].height_offset_pulses =
        pulses_from_mm(profile.head_r2_height_error_mm, profile.y.pulses_per_mm);
    g.rad_per_pulse_ = rad_from_pulses(1, g.rev_pulses_);
    g.y_pulses_per_mm_ = profile.y.pulses_per_mm;
    g.tolerance_mm_ = profile.job.path_tolerance_mm;
    g.blank_radius_mm_ = assumed_blank_mm(job, outside_rule(profile).heads, 0.0);
    const auto heights = g.row_heights();
    const std::int64_t base = pulses_from_mm(profile.job.base_height_mm, profile.y.pulses_per_mm);
    const std::int64_t alone = std::max<std::int64_t>(std::abs(heights.front() - base), 1);
    // The ring that closes a spiral lies as high as the row before it.
    const std::size_t count = heights.size() - (g.is_spiral() ? 1 : 0);
    const bool one = count == 1;
    g.outer_margin_low_ = one ? alone : (heights[1] - heights[0] + 1) / 2;
    g.outer_margin_high_ = one ? alone : (heights[count - 1] - heights[count - 2] + 1) / 2;
    return g;
}

Positions JobGeometry::target(std::uint32_t layer, std::uint32_t step) const noexcept {
    const std::uint32_t point = carved_point(job_.joining(), point_count(), layer, step);
    return {job_.r_left_pulses(layer)[point], job_.r_right_pulses(layer)[point],
            job_.psi_pulses(layer, point), job_.y_pulses(layer, point)};
}

std::optional<std::uint32_t> JobGeometry::step_at(std::uint32_t layer, const Positions& at) const noexcept {
    const std::uint32_t last = point_count() - 1;
    if (job_.y_pulses(layer, 0) > at[kY] || job_.y_pulses(layer, last) < at[kY]) return std::nullopt;
    const std::int64_t first_psi = target(layer, 0)[kPsi];
    const std::int64_t way = target(layer, last)[kPsi] - first_psi;
    const std::int64_t sign = way < 0 ? -1 : 1;
    const std::int64_t turned = wrapped((at[kPsi] - first_psi) * sign, rev_pulses());
    if (turned > way * sign) return std::nullopt;
    std::uint32_t step = 0;  // the first that lies as far from the layer's begin
    for (std::uint32_t end = last; step < end;) {
        const std::uint32_t middle = step + (end - step) / 2;
        if ((target(layer, middle)[kPsi] - first_psi) * sign < turned) {
            step = middle + 1;
        } else {
            end = middle;
        }
    }
    const Positions point = target(layer, step);
    const bool is_there = (point[kPsi] - first_psi) * sign == turned && point[kY] == at[kY];
    return is_there ? std::optional(step) : std::nullopt;
}

std::int64_t JobGeometry::height(std::uint32_t row, std::int64_t direction_pulses) const noexcept {
    if (!is_spiral() || row == 0) return height(row);
    // Both heads rise alike; where one of them begins, the other one ends.
    const std::int64_t sweep = job_.psi_sweep_pulses();
    const std::int64_t turned = wrapped(direction_pulses - ((first_row_layer() + row) % 2) * sweep, sweep);
    const double part = turned == 0 ? 1.0 : static_cast<double>(turned) / static_cast<double>(sweep);
    const std::int64_t below = height(row - 1);
    return below + round_to_pulse(part * static_cast<double>(height(row) - below));
}

std::optional<std::uint32_t> JobGeometry::row_at(std::int64_t height_pulses,
                                                 std::int64_t direction_pulses) const noexcept {
    const auto heights = row_heights();
    if (height_pulses < heights.front() - outer_margin_low_ ||
        height_pulses > heights.back() + outer_margin_high_)
        return std::nullopt;
    std::uint32_t above = 0;  // the first row that is not below
    for (std::uint32_t end = row_count(); above < end;) {
        const std::uint32_t middle = above + (end - above) / 2;
        if (height(middle, direction_pulses) < height_pulses) {
            above = middle + 1;
        } else {
            end = middle;
        }
    }
    if (above == 0) return 0;
    const bool is_nearer_below =
        above == row_count() || height_pulses - height(above - 1, direction_pulses) <=
                                    height(above, direction_pulses) - height_pulses;
    return is_nearer_below ? above - 1 : above;
}

std::optional<std::uint32_t> JobGeometry::row_of_point(std::size_t h, std::uint32_t layer,
                                                       std::uint32_t point) const noexcept {
    if (layer < first_row_layer()) return std::nullopt;
    const std::int64_t offset = heads_[h].height_offset_pulses;
    if (offset == 0) return layer - first_row_layer() - (job_.is_joint(layer, point) ? 1 : 0);
    return row_at(job_.y_pulses(layer, point) + offset, direction(h, job_.psi_pulses(layer, point)));
}

std::int64_t JobGeometry::direction(std::size_t h, std::int64_t psi_pulses) const noexcept {
    return wrapped(psi_pulses + heads_[h].facing_pulses, rev_pulses_);
}

std::uint32_t JobGeometry::cell_of(std::int64_t direction_pulses) const noexcept {
    const auto count = static_cast<std::int64_t>(direction_count());
    const std::int64_t cell = (2 * direction_pulses * count + rev_pulses_) / (2 * rev_pulses_);
    return static_cast<std::uint32_t>(cell == count ? 0 : cell);
}

std::int64_t JobGeometry::direction_of(std::uint32_t cell) const noexcept {
    const std::uint32_t steps = point_count() - 1;
    const std::int64_t within = point_angle_pulses(cell % steps, rev_pulses_ / 2, point_count());
    return cell < steps ? within : within + rev_pulses_ / 2;
}

std::optional<double> JobGeometry::on_row(std::size_t h, std::uint32_t row, std::int64_t direction_pulses,
                                          Gap bridging) const noexcept {
    const std::int64_t sweep = job_.psi_sweep_pulses();
    const std::uint32_t layer = first_row_layer() + row;
    const std::int64_t start = job_.psi_pulses(layer, 0);
    std::int64_t along = wrapped(direction_pulses - heads_[h].facing_pulses - start, rev_pulses_);
    if (along == 0 && job_.is_joint(layer, 0)) return std::nullopt;  // the row before has it
    // The angle error leaves a gap between the two heads' halves; the nearer end counts for it.
    const std::int64_t gap =
        bridging == Gap::bridged ? std::abs(heads_[1].facing_pulses - rev_pulses_ / 2) : 0;
    if (along > sweep && along <= sweep + gap) along = sweep;
    if (along >= rev_pulses_ - gap && along > sweep) along = 0;
    if (along > sweep) return std::nullopt;
    const auto radii = h == 0 ? job_.r_left_pulses(layer) : job_.r_right_pulses(layer);
    const auto steps = static_cast<std::int64_t>(point_count() - 1);
    std::int64_t j = std::min(along * steps / sweep, steps - 1);
    if (j > 0 && point_angle_pulses(j, sweep, steps + 1) > along) --j;
    if (j + 1 < steps && point_angle_pulses(j + 1, sweep, steps + 1) < along) ++j;
    const std::int64_t a = point_angle_pulses(j, sweep, steps + 1);
    const std::int64_t b = point_angle_pulses(j + 1, sweep, steps + 1);
    const double part = b == a ? 0.0 : static_cast<double>(along - a) / static_cast<double>(b - a);
    const auto near = heads_[h].real_mm(radii[static_cast<std::size_t>(j)]);
    const auto far = heads_[h].real_mm(radii[static_cast<std::size_t>(j) + 1]);
    return along == b ? far : near + part * (far - near);
}

std::optional<double> JobGeometry::least_near(std::size_t h, std::uint32_t row, std::int64_t y_pulses,
                                              std::int64_t direction_pulses) const noexcept {
    auto least = on_row(h, row, direction_pulses, Gap::empty);
    if (!is_spiral()) return least;
    const std::int64_t off = std::abs(height(row, direction_pulses) - y_pulses);
    const auto consider = [&](std::uint32_t other) {
        if (std::abs(height(other, direction_pulses) - y_pulses) > off + 1) return;
        const auto radius = on_row(h, other, direction_pulses, Gap::empty);
        if (radius && (!least || *radius < *least)) least = radius;
    };
    if (row > 0) consider(row - 1);
    if (row + 1 < row_count()) consider(row + 1);
    return least;
}

std::optional<double> JobGeometry::floor_mm(std::size_t h, std::int64_t y_pulses,
                                            std::int64_t direction_pulses) const noexcept {
    const auto row = row_at(y_pulses, direction_pulses);
    const auto own = row ? least_near(h, *row, y_pulses, direction_pulses) : std::nullopt;
    if (own) return own;
    const std::size_t other = 1 - h;
    const std::int64_t others_y =
        y_pulses + heads_[h].height_offset_pulses - heads_[other].height_offset_pulses;
    const auto others_row = row_at(others_y, direction_pulses);
    const auto others =
        others_row ? least_near(other, *others_row, others_y, direction_pulses) : std::nullopt;
    if (others || !row) return others;
    return on_row(h, *row, direction_pulses);
}

std::int64_t JobGeometry::tip_height(std::size_t h, std::uint32_t row,
                                     std::int64_t direction_pulses) const noexcept {
    const std::int64_t offset = heads_[h].height_offset_pulses;
    if (!is_spiral() || row == 0) return height(row) + offset;
    const std::int64_t start = job_.psi_pulses(first_row_layer() + row, 0);
    const std::int64_t along = wrapped(direction_pulses - heads_[h].facing_pulses - start, rev_pulses_);
    const double part = static_cast<double>(along) / static_cast<double>(job_.psi_sweep_pulses());
    const std::int64_t below = height(row - 1);
    return below + round_to_pulse(part * static_cast<double>(height(row) - below)) + offset;
}

std::optional<double> JobGeometry::least_around(std::int64_t tip_height_pulses, std::int64_t direction_pulses,
                                                std::span<const KnownTip> more) const noexcept {
    std::array<std::int64_t, 2> off{std::numeric_limits<std::int64_t>::max(),
                                    std::numeric_limits<std::int64_t>::max()};
    std::array<double, 2> nearest{};
    const auto consider = [&](const KnownTip& tip) {
        for (const bool is_above : {false, true}) {
            const std::int64_t away = tip.height_pulses - tip_height_pulses;
            if ((is_above ? away < 0 : away > 0) || std::abs(away) >= off[is_above ? 1 : 0]) continue;
            off[is_above ? 1 : 0] = std::abs(away);
            nearest[is_above ? 1 : 0] = tip.radius_mm;
        }
    };
    for (std::size_t h = 0; h < kHeadCount; ++h) {
        const auto row = row_at(tip_height_pulses - heads_[h].height_offset_pulses, direction_pulses);
        if (!row) continue;
        const std::uint32_t end = std::min(row_count(), *row + kRowsAround + 1);
        for (std::uint32_t near = *row - std::min(*row, kRowsAround); near < end; ++near) {
            const auto radius = on_row(h, near, direction_pulses, Gap::empty);
            if (radius) consider({tip_height(h, near, direction_pulses), *radius});
        }
    }
    for (const KnownTip& tip : more) consider(tip);
    std::optional<double> least;
    for (std::size_t i = 0; i < off.size(); ++i) {
        if (off[i] == std::numeric_limits<std::int64_t>::max()) continue;
        least = std::min(least.value_or(nearest[i]), nearest[i]);
    }
    return least;
}

std::optional<double> JobGeometry::wanted_mm(std::uint32_t row,
                                             std::int64_t direction_pulses) const noexcept {
    const auto left = on_row(0, row, direction_pulses);
    if (left && heads_[1].facing_pulses == rev_pulses_ / 2) return left;
    const auto own =
        heads_[1].height_offset_pulses == 0
            ? std::optional<std::uint32_t>(row)
            : row_at(height(row, direction_pulses) - heads_[1].height_offset_pulses, direction_pulses);
    const auto right = own ? on_row(1, *own, direction_pulses) : std::nullopt;
    if (left && right) return std::min(*left, *right);
    return left ? left : right;
}

}  // namespace psicarve::verify
