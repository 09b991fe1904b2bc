// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/gap_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "hmi/slice/directions.hpp"
#include "hmi/slice/placement.hpp"
#include "hmi/tool/tool.hpp"
#include "shared/units.hpp"

namespace psicarve::cam {
namespace {

constexpr double kMostSteps = 4096.0;

/// File units throughout; z as placed.
class GapSearch {
public:
    GapSearch(const model::Mesh& mesh, const Profile& profile, const JobPlan& plan, const JobTable& table)
        : mesh_(mesh),
          plan_(plan),
          tool_(tool::tool_of(profile.tool, 1.0 / plan.scale)),
          round_(slice::full_circle_rad(plan.point_count, profile.psi.pulses_per_rev, 0.0)),
          half_(plan.point_count - 1),
          rises_(plan.joining == Joining::spiral && plan.heights.size() > 1),
          rounding_(0.5 / std::min(profile.r1.pulses_per_mm, profile.r2.pulses_per_mm) / plan.scale),
          heads_{Head{profile.r1, 0.0, 0.0, table.r_left_pulses},
                 Head{profile.r2, rad_from_deg(profile.head_r2_angle_error_deg),
                      profile.head_r2_height_error_mm / plan.scale, table.r_right_pulses}},
          gaps_(round_.size()) {
        round_.push_back(2.0 * kPi);
        const bool is_opposite = heads_[1].facing_rad == 0.0 && heads_[1].height == 0.0;
        frames_ = std::span(heads_).first(is_opposite ? 1 : 2);
        heights_ = plan.heights;
        if (rises_) heights_.pop_back();  // the ring that closes it rises no more
        pitch_ = plan.heights.size() > 1 ? plan.heights[1] - plan.heights[0] : 0.0;
    }

    std::vector<Gap> found() {
        for (const model::Triangle& facet : mesh_.triangles) {
            std::array<Place, 3> corners;
            for (std::size_t k = 0; k < 3; ++k) corners[k] = place_of(facet.vertices[k]);
            for (std::size_t k = 0; k < 3; ++k) {
                const auto& from = facet.vertices[k];
                const auto& to = facet.vertices[(k + 1) % 3];
                // A closed body's edges come twice, once each way.
                if (!mesh_.facts.closed || !mesh_.facts.same_orientation || from < to)
                    follow(corners[k], corners[(k + 1) % 3]);
            }
        }
        for (Gap& gap : gaps_) gap.sunk_mm *= plan_.scale;
        return std::move(gaps_);
    }

private:
    struct Head {
        const LinearAxisProfile& axis;
        double facing_rad;
        double height;
        const std::vector<std::int32_t>& radii;
    };
    struct Place {
        double x;
        double y;
        double z;
        double angle;  ///< 0 to a turn
    };

    /// Which gap holds a direction, as a head sees it.
    struct Seat {
        std::size_t gap;
        double along;  ///< 0 to 1
        double part;   ///< of a layer's way, half a turn
        double angle;
    };

    Place place_of(const std::array<float, 3>& vertex) const {
        const auto at = slice::placed(
            plan_.placement.up,
            {vertex[0] + mesh_.origin[0], vertex[1] + mesh_.origin[1], vertex[2] + mesh_.origin[2]});
        return placed(at[0] - plan_.placement.axis_x, at[1] - plan_.placement.axis_y, at[2]);
    }
    static Place placed(double x, double y, double z) {
        const double angle = std::atan2(y, x);
        return {x, y, z, angle < 0.0 ? angle + 2.0 * kPi : angle};
    }

    void follow(const Place& from, const Place& to) {
        const double reach = tool_.shape == tool::Shape::point ? 0.0 : tool_.radius;
        const double margin = reach + (rises_ ? pitch_ : 0.0) + std::abs(heads_[1].height);
        if (std::max(from.z, to.z) < plan_.heights.front() - margin ||
            std::min(from.z, to.z) > plan_.heights.back() + margin)
            return;
        // Of edges that are followed one way only, some corners are no edge's begin.
        if (reach > 0.0)
            for (const Head& head : frames_) around(head, to, seat_of(head, to.angle));
        const double turned = std::abs(std::remainder(to.angle - from.angle, 2.0 * kPi));
        const auto steps = static_cast<int>(
            std::clamp(std::ceil(turned * static_cast<double>(half_) / kPi), 1.0, kMostSteps));
        const auto part = [&](double t) {
            return placed(from.x + t * (to.x - from.x), from.y + t * (to.y - from.y),
                          from.z + t * (to.z - from.z));
        };
        if (!rises_) {
            for (const Head& head : frames_) cross(head, from, to);
            // Steeper ones are met by enough layers.
            if (tool_.shape == tool::Shape::point || std::abs(to.z - from.z) > steps * pitch_) return;
            for (int i = 1; i < steps; ++i) {
                const Place place = part(static_cast<double>(i) / steps);
                for (const Head& head : frames_) around(head, place, seat_of(head, place.angle));
            }
            return;
        }
        Place last = from;
        for (int i = 1; i <= steps; ++i) {
            const Place next = i < steps ? part(static_cast<double>(i) / steps) : to;
            for (const Head& head : frames_) cross(head, last, next);
            last = next;
        }
    }

    /// Rows that a piece of an edge crosses, and, of tools that have a size, those around its begin.
    void cross(const Head& head, const Place& from, const Place& to) {
        const bool has_size = tool_.shape != tool::Shape::point;
        double low = from.z - head.height;
        double high = to.z - head.height;
        if (has_size || rises_) {
            const Seat begin = seat_of(head, from.angle);
            if (has_size) around(head, from, begin);
            if (rises_) {
                const Seat end = seat_of(head, to.angle);
                // Where a spiral's rows begin.
                if (std::abs(begin.part - end.part) > 0.5) return;
                low = level_of(head, from, begin);
                high = level_of(head, to, end);
            }
        }
        auto row = std::lower_bound(heights_.begin(), heights_.end(), std::min(low, high));
        for (; row != heights_.end() && *row <= std::max(low, high); ++row) {
            const double t = high != low ? (*row - low) / (high - low) : 0.0;
            const Place at = placed(from.x + t * (to.x - from.x), from.y + t * (to.y - from.y), *row);
            note(head, seat_of(head, at.angle), static_cast<std::size_t>(row - heights_.begin()),
                 std::hypot(at.x, at.y));
        }
    }

    void around(const Head& head, const Place& at, const Seat& seat) {
        const double level = level_of(head, at, seat);
        const auto above = std::lower_bound(heights_.begin(), heights_.end(), level);
        const auto look = [&](auto row) {
            const double off = std::abs(*row - level);
            if (off > tool_.radius) return;
            note(head, seat, static_cast<std::size_t>(row - heights_.begin()),
                 std::hypot(at.x, at.y) - tool::rise(tool_, off));
        };
        if (above != heights_.end()) look(above);
        if (above != heights_.begin()) look(above - 1);
    }

    Seat seat_of(const Head& head, double angle) const {
        double seen = angle - head.facing_rad;
        seen -= 2.0 * kPi * std::floor(seen / (2.0 * kPi));
        auto gap =
            std::min(gaps_.size() - 1, static_cast<std::size_t>(seen * static_cast<double>(half_) / kPi));
        while (gap > 0 && round_[gap] > seen) --gap;
        while (gap + 1 < gaps_.size() && round_[gap + 1] <= seen) ++gap;
        const double along = std::clamp((seen - round_[gap]) / (round_[gap + 1] - round_[gap]), 0.0, 1.0);
        return {gap, along, (static_cast<double>(gap % half_) + along) / static_cast<double>(half_), seen};
    }
    /// Height, less what a spiral's row has risen there.
    double level_of(const Head& head, const Place& at, const Seat& seat) const {
        return at.z - head.height - (rises_ ? seat.part * pitch_ : 0.0);
    }

    void note(const Head& frame, const Seat& seat, std::size_t height, double least_tip) {
        const std::size_t row = rises_ ? height + 1 : height;
        const bool half_a_turn_on = plan_.joining != Joining::zigzag && row % 2 != 0;
        const bool is_left = half_a_turn_on == (seat.gap >= half_);
        const Head& head = heads_[is_left ? 0 : 1];
        // Another frame's.
        if (head.facing_rad != frame.facing_rad || head.height != frame.height) return;
        const std::int32_t* radii = head.radii.data() + row * plan_.point_count + seat.gap % half_;
        const double straight = radii[0] + seat.along * (radii[1] - radii[0]);
        const double tip = (straight / head.axis.pulses_per_mm + head.axis.tip_mm()) / plan_.scale;
        const double sunk = least_tip - tip - rounding_;
        Gap& gap = gaps_[seat.gap];
        if (sunk <= gap.sunk_mm) return;
        gap = {sunk, seat.angle};
    }

    const model::Mesh& mesh_;
    const JobPlan& plan_;
    tool::Tool tool_;
    std::vector<double> round_;
    std::size_t half_;
    bool rises_;
    double rounding_;
    std::array<Head, 2> heads_;
    std::span<const Head> frames_;  ///< heads that see directions and heights differently
    std::vector<Gap> gaps_;
    std::vector<double> heights_;
    double pitch_ = 0.0;
};

}  // namespace

std::vector<Gap> sunk_at_edges(const model::Mesh& mesh, const Profile& profile, const JobPlan& plan,
                               const JobTable& table) {
    return GapSearch(mesh, profile, plan, table).found();
}

}  // namespace psicarve::cam
