// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "hmi/tool/tool.hpp"
#include "shared/base/units.hpp"
#include "shared/job/job.hpp"

namespace psicarve::rough::brute {

/// What is left of a blank, by the definition of the tool alone: a place of the material is gone when it lies
/// within the solid { x >= tip + rise(s), s = hypot(z, dy) <= R }, x along the tool's axis. Slow, and shares
/// nothing with what it judges.
class Stock {
public:
    /// A point tool's stock has one place for each cell of each layer's height; `rows` is for other tools.
    Stock(const Profile& profile, const JobTable& job, std::size_t rows, std::size_t columns)
        : profile_(profile),
          tool_(tool::tool_of(profile.tool, 1.0)),
          is_point_(profile.tool.shape == ToolShape::point),
          columns_(is_point_ ? 2 * (job.point_count - 1) : columns) {
        const auto [low, high] =
            std::minmax_element(job.layer_height_pulses.begin(), job.layer_height_pulses.end());
        const double reach_mm = is_point_ ? 0.0 : tool_.radius;
        bottom_mm_ = mm(*low) - reach_mm;
        if (is_point_) {
            heights_ = job.layer_height_pulses;
            std::sort(heights_.begin(), heights_.end());
            heights_.erase(std::unique(heights_.begin(), heights_.end()), heights_.end());
            rows = heights_.size();
        }
        rows_ = rows;
        row_mm_ = (mm(*high) + reach_mm - bottom_mm_) / static_cast<double>(rows);
        for (std::size_t i = 0; i < rows * columns_; ++i) {
            const auto column = static_cast<double>(i % columns_);
            radius_mm.push_back(profile.blank.surface_mm(2.0 * kPi * column / static_cast<double>(columns_)));
        }
    }

    /// Carves the layers [first, end) of a job whose layers belong to one pass, with the ways between them.
    void carve(const JobView& job, std::uint32_t first, std::uint32_t end) {
        for (std::uint32_t layer = first; layer < end; ++layer) {
            for (std::uint32_t step = 0; step + 1 < job.point_count(); ++step)
                go(at(job, layer, step), at(job, layer, step + 1), is_point_ ? 1 : 3);
            if (is_point_) stand(at(job, layer, job.point_count() - 1));
            if (layer + 1 < end && !is_point_ && !job.is_joint(layer + 1, 0)) link(job, layer);
        }
    }

    /// One head alone along a layer, its tip so much further in than the job has it.
    void carve_head(const JobView& job, std::uint32_t layer, Axis head, double in_mm) {
        constexpr double kFarAway_mm = 1e6;
        const auto place = [&](std::uint32_t step) {
            Place found = at(job, layer, step);
            found.r1_mm = head == Axis::r1 ? found.r1_mm - in_mm : kFarAway_mm;
            found.r2_mm = head == Axis::r2 ? found.r2_mm - in_mm : kFarAway_mm;
            return found;
        };
        for (std::uint32_t step = 0; step + 1 < job.point_count(); ++step)
            go(place(step), place(step + 1), is_point_ ? 1 : 3);
        if (is_point_) stand(place(job.point_count() - 1));
    }

    /// One head alone from a point of a layer to the next, its tip so much further in than the job has it.
    void carve_line(const JobView& job, std::uint32_t layer, std::uint32_t point, Axis head, double in_mm) {
        constexpr double kFarAway_mm = 1e6;
        std::array<Place, 2> ends{};
        for (std::uint32_t end = 0; end < 2; ++end) {
            ends[end] = at(job, layer, carved_point(job.joining(), job.point_count(), layer, point + end));
            ends[end].r1_mm = head == Axis::r1 ? ends[end].r1_mm - in_mm : kFarAway_mm;
            ends[end].r2_mm = head == Axis::r2 ? ends[end].r2_mm - in_mm : kFarAway_mm;
        }
        go(ends[0], ends[1], 4);
    }

    std::size_t rows() const { return rows_; }
    std::size_t columns() const { return columns_; }
    double removed_mm() const {
        double sum = 0.0;
        for (std::size_t i = 0; i < radius_mm.size(); ++i) {
            const auto column = static_cast<double>(i % columns_);
            sum +=
                profile_.blank.surface_mm(2.0 * kPi * column / static_cast<double>(columns_)) - radius_mm[i];
        }
        return sum;
    }

    std::vector<double> radius_mm;  ///< row by row

private:
    struct Place {
        double r1_mm, r2_mm, psi_rad, y_mm;
    };
    double mm(std::int64_t pulses) const { return static_cast<double>(pulses) / profile_.y.pulses_per_mm; }
    Place at(const JobView& job, std::uint32_t layer, std::uint32_t step) const {
        const std::uint32_t point = carved_point(job.joining(), job.point_count(), layer, step);
        return {job.r_left_pulses(layer)[point] / profile_.r1.pulses_per_mm + profile_.r1.tip_mm(),
                job.r_right_pulses(layer)[point] / profile_.r2.pulses_per_mm + profile_.r2.tip_mm(),
                2.0 * kPi * static_cast<double>(job.psi_pulses(layer, point)) /
                    static_cast<double>(profile_.psi.pulses_per_rev),
                mm(job.y_pulses(layer, point))};
    }
    /// Axes that go out, then Y, then those that go in.
    void link(const JobView& job, std::uint32_t layer) {
        Place from = at(job, layer, job.point_count() - 1);
        Place to = at(job, layer + 1, 0);
        from.r1_mm = to.r1_mm = std::max(from.r1_mm, to.r1_mm);
        from.r2_mm = to.r2_mm = std::max(from.r2_mm, to.r2_mm);
        go(from, to, 12);
    }
    void go(const Place& a, const Place& b, int steps) {
        for (int i = 0; i < steps; ++i) {
            const double p = static_cast<double>(i) / steps;
            stand({a.r1_mm + p * (b.r1_mm - a.r1_mm), a.r2_mm + p * (b.r2_mm - a.r2_mm),
                   a.psi_rad + p * (b.psi_rad - a.psi_rad), a.y_mm + p * (b.y_mm - a.y_mm)});
        }
        if (!is_point_) stand(b);
    }
    void stand(const Place& at) {
        cut(at.psi_rad, at.y_mm, at.r1_mm);
        cut(at.psi_rad + kPi + profile_.head_r2_angle_error_deg * kPi / 180.0,
            at.y_mm + profile_.head_r2_height_error_mm, at.r2_mm);
    }
    bool is_gone(double rho, double turn, double dy, double tip_mm) const {
        const double x = rho * std::cos(turn);
        const double s = std::hypot(rho * std::sin(turn), dy);
        return x > 0.0 && s <= tool_.radius && x >= tip_mm + tool::rise(tool_, s);
    }
    void cut(double direction, double y_mm, double tip_mm) {
        if (is_point_) return prick(direction, y_mm, tip_mm);
        constexpr double kStep_mm = 0.01;
        for (std::size_t row = 0; row < rows_; ++row) {
            const double dy = bottom_mm_ + (static_cast<double>(row) + 0.5) * row_mm_ - y_mm;
            if (std::abs(dy) > tool_.radius) continue;
            for (std::size_t column = 0; column < columns_; ++column) {
                const double turn = std::remainder(
                    2.0 * kPi * static_cast<double>(column) / static_cast<double>(columns_) - direction,
                    2.0 * kPi);
                if (std::abs(turn) > 1.5) continue;
                double& radius = radius_mm[row * columns_ + column];
                while (radius > kStep_mm && is_gone(radius, turn, dy, tip_mm)) radius -= kStep_mm;
            }
        }
    }
    void prick(double direction, double y_mm, double tip_mm) {
        const double turned = direction / (2.0 * kPi);
        const auto column = static_cast<std::size_t>(
                                std::llround((turned - std::floor(turned)) * static_cast<double>(columns_))) %
                            columns_;
        const auto row = std::find_if(heights_.begin(), heights_.end(), [&](std::int64_t height) {
            return std::abs(mm(height) - y_mm) < 1e-6;
        });
        if (row == heights_.end()) return;
        double& radius = radius_mm[static_cast<std::size_t>(row - heights_.begin()) * columns_ + column];
        radius = std::min(radius, tip_mm);
    }

    const Profile& profile_;
    tool::Tool tool_;
    bool is_point_;
    std::size_t rows_ = 0;
    std::size_t columns_;
    double bottom_mm_ = 0.0;
    double row_mm_ = 1.0;
    std::vector<std::int64_t> heights_;
};

}  // namespace psicarve::rough::brute
