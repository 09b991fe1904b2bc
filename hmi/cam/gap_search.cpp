// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/gap_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "hmi/cam/gap_finder.hpp"
#include "hmi/slice/directions.hpp"
#include "hmi/slice/layer_finder.hpp"
#include "hmi/slice/placement.hpp"
#include "hmi/tool/tool.hpp"
#include "shared/base/units.hpp"

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
          is_torn_(!mesh.facts.closed || !mesh.facts.same_orientation),
          heads_{Head(profile.r1, 0.0, 0.0, plan.scale, table.r_left_pulses),
                 Head(profile.r2, rad_from_deg(profile.head_r2_angle_error_deg),
                      profile.head_r2_height_error_mm / plan.scale, plan.scale, table.r_right_pulses)},
          gaps_(round_.size()),
          heights_(plan.heights.begin(),
                   plan.heights.end() - (rises_ ? 1 : 0)),  // the last ring rises no more
          row_finder_(heights_),
          gap_finder_(round_) {
        round_.push_back(2.0 * kPi);
        const bool is_opposite = heads_[1].facing_rad == 0.0 && heads_[1].height == 0.0;
        for (const Head& head : heads_) {
            const auto least = std::min_element(head.radii.begin(), head.radii.end());
            least_tip_ = std::min(least_tip_, *least * head.units_per_pulse + head.tip_units);
        }
        frames_ = std::span(heads_).first(is_opposite ? 1 : 2);
        pitch_ = plan.heights.size() > 1 ? plan.heights[1] - plan.heights[0] : 0.0;
    }

    /// By gap; or, with less work, only the greatest of all.
    std::vector<Gap> found(bool is_most_enough) {
        is_most_enough_ = is_most_enough;
        if (tool_.shape == tool::Shape::point && !rises_) {
            for (const model::Triangle& facet : mesh_.triangles) cross_flat_rows(facet);
        } else {
            for (const model::Triangle& facet : mesh_.triangles) follow_edges(facet);
        }
        for (Gap& gap : gaps_) gap.sunk_mm *= plan_.scale;
        return std::move(gaps_);
    }

private:
    using Vertex = std::array<float, 3>;

    struct Head {
        Head(const LinearAxisProfile& linear, double facing, double above, double scale,
             const std::vector<std::int32_t>& table)
            : axis(linear),
              facing_rad(facing),
              facing_cosine(std::cos(facing)),
              facing_sine(std::sin(facing)),
              height(above),
              units_per_pulse(1.0 / linear.pulses_per_mm / scale),
              tip_units(linear.tip_mm() / scale),
              radii(table) {}

        const LinearAxisProfile& axis;
        double facing_rad;
        double facing_cosine;
        double facing_sine;
        double height;
        double units_per_pulse;
        double tip_units;
        const std::vector<std::int32_t>& radii;
    };
    struct Place {
        double x;
        double y;
        double z;
        double angle;  ///< 0 to a turn
    };

    /// The gap that holds a direction, as a head faces it.
    struct Seat {
        std::size_t gap;
        double along;  ///< 0 to 1
        double part;   ///< of a layer's way, half a turn
        double angle;
    };

    std::array<double, 3> upright(const Vertex& vertex) const noexcept {
        const auto at = slice::placed(
            plan_.placement.up,
            {vertex[0] + mesh_.origin[0], vertex[1] + mesh_.origin[1], vertex[2] + mesh_.origin[2]});
        return {at[0] - plan_.placement.axis_x, at[1] - plan_.placement.axis_y, at[2]};
    }
    static Place placed(double x, double y, double z) {
        const double angle = std::atan2(y, x);
        return {x, y, z, angle < 0.0 ? angle + 2.0 * kPi : angle};
    }

    /// Each edge of a closed body comes twice, once each way: follows it once.
    bool is_followed(const Vertex& from, const Vertex& to) const noexcept {
        // Without branches, which no processor would guess right.
        const auto rises = [&](std::size_t k) { return unsigned{from[k] < to[k]}; };
        const auto stays = [&](std::size_t k) { return unsigned{from[k] == to[k]}; };
        return (unsigned{is_torn_} | rises(0) | (stays(0) & (rises(1) | (stays(1) & rises(2))))) != 0;
    }

    void follow_edges(const model::Triangle& facet) {
        std::array<Place, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const auto at = upright(facet.vertices[k]);
            corners[k] = placed(at[0], at[1], at[2]);
        }
        for (std::size_t k = 0; k < 3; ++k) {
            if (is_followed(facet.vertices[k], facet.vertices[(k + 1) % 3]))
                follow(corners[k], corners[(k + 1) % 3]);
        }
    }

    /// A point in flat layers meets edges where they cross these, and nowhere else.
    void cross_flat_rows(const model::Triangle& facet) {
        std::array<std::array<double, 3>, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) corners[k] = upright(facet.vertices[k]);
        // Nothing of a facet is further out than its corners.
        double square = 0.0;
        for (const auto& [x, y, z] : corners) square = std::max(square, x * x + y * y);
        if (!is_worth_a_look(square, least_tip_, most_)) return;
        for (const Head& head : frames_) {
            std::array<double, 3> level;
            std::array<std::size_t, 3> at_or_above;
            std::array<std::size_t, 3> above;
            for (std::size_t k = 0; k < 3; ++k) {
                level[k] = corners[k][2] - head.height;
                at_or_above[k] = row_finder_.first_at_or_above(level[k]);
                above[k] = at_or_above[k];
                while (above[k] < heights_.size() && heights_[above[k]] == level[k]) ++above[k];
            }
            if (std::min({at_or_above[0], at_or_above[1], at_or_above[2]}) ==
                std::max({above[0], above[1], above[2]}))
                continue;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t next = (k + 1) % 3;
                const std::size_t end = std::max(above[k], above[next]);
                std::size_t row = std::min(at_or_above[k], at_or_above[next]);
                if (row == end || !is_followed(facet.vertices[k], facet.vertices[next])) continue;
                for (; row != end; ++row) {
                    note_crossing(head, corners[k], corners[next], part_at(row, level[k], level[next]), row);
                }
            }
        }
    }
    double part_at(std::size_t row, double low, double high) const noexcept {
        return high != low ? (heights_[row] - low) / (high - low) : 0.0;
    }
    void note_crossing(const Head& head, const std::array<double, 3>& from, const std::array<double, 3>& to,
                       double part, std::size_t row) {
        const double x = from[0] + part * (to[0] - from[0]);
        const double y = from[1] + part * (to[1] - from[1]);
        if (!may_say_more(head, x, y, row)) return;
        note(head, seat_of(head, placed(x, y, 0.0).angle), row, std::hypot(x, y));
    }

    void follow(const Place& from, const Place& to) {
        const double reach = tool_.shape == tool::Shape::point ? 0.0 : tool_.radius;
        const double margin = reach + (rises_ ? pitch_ : 0.0) + std::abs(heads_[1].height);
        if (std::max(from.z, to.z) < plan_.heights.front() - margin ||
            std::min(from.z, to.z) > plan_.heights.back() + margin)
            return;
        // Where edges are followed one way only, some corners are the begin of none.
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
            // Steeper pieces cross enough layers.
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

    /// The head that passes through a gap in a row.
    const Head& head_in(std::size_t row, std::size_t gap) const noexcept {
        const bool half_a_turn_on = plan_.joining != Joining::zigzag && row % 2 != 0;
        const bool is_left = half_a_turn_on == (gap >= half_);
        return heads_[is_left ? 0 : 1];
    }
    static bool has_frame(const Head& head, const Head& frame) noexcept {
        return head.facing_rad == frame.facing_rad && head.height == frame.height;
    }
    /// Where it stands at a gap's begin, and then at its end.
    const std::int32_t* radii_at(const Head& head, std::size_t row, std::size_t gap) const noexcept {
        return head.radii.data() + row * plan_.point_count + (gap < half_ ? gap : gap - half_);
    }

    /// Whether note() could find more than is known already at this radius (its square) with the tip there or
    /// further out.
    bool is_worth_a_look(double radius_square, double tip, double known) const noexcept {
        constexpr double kRounding = 1.0 + 1e-12;
        const double least = tip + rounding_ + known;
        return least < 0.0 || radius_square * kRounding > least * least;
    }
    /// The same for an edge's crossing with a flat row: bounds first what takes trigonometry, which usually
    /// suffices.
    bool may_say_more(const Head& frame, double x, double y, std::size_t row) const noexcept {
        const double square = x * x + y * y;
        if (!is_worth_a_look(square, least_tip_, most_)) return false;
        const double seen_x = x * frame.facing_cosine + y * frame.facing_sine;
        const double seen_y = y * frame.facing_cosine - x * frame.facing_sine;
        const std::size_t gap = gap_finder_.gap_at(seen_x, seen_y);
        if (gap == GapFinder::kUnsure) return true;
        const Head& head = head_in(row, gap);
        if (!has_frame(head, frame)) return false;
        const double known = is_most_enough_ ? most_ : gaps_[gap].sunk_mm;
        const std::int32_t* radii = radii_at(head, row, gap);
        const auto tip_at = [&head](double pulses) { return pulses * head.units_per_pulse + head.tip_units; };
        if (!is_worth_a_look(square, tip_at(std::min(radii[0], radii[1])), known)) return false;
        const auto [least_along, most_along] = gap_finder_.along(gap, seen_x, seen_y);
        const double rise = static_cast<double>(radii[1] - radii[0]);
        const double straight = radii[0] + std::min(least_along * rise, most_along * rise);
        return is_worth_a_look(square, tip_at(straight), known);
    }

    void note(const Head& frame, const Seat& seat, std::size_t height, double least_tip) {
        const std::size_t row = rises_ ? height + 1 : height;
        const Head& head = head_in(row, seat.gap);
        // Another frame has this head.
        if (!has_frame(head, frame)) return;
        const std::int32_t* radii = radii_at(head, row, seat.gap);
        const double straight = radii[0] + seat.along * (radii[1] - radii[0]);
        const double tip = (straight / head.axis.pulses_per_mm + head.axis.tip_mm()) / plan_.scale;
        const double sunk = least_tip - tip - rounding_;
        Gap& gap = gaps_[seat.gap];
        if (sunk <= gap.sunk_mm) return;
        gap = {sunk, seat.angle};
        if (is_most_enough_) most_ = std::max(most_, sunk);
    }

    const model::Mesh& mesh_;
    const JobPlan& plan_;
    tool::Tool tool_;
    std::vector<double> round_;
    std::size_t half_;
    bool rises_;
    double rounding_;
    bool is_torn_;
    std::array<Head, 2> heads_;
    std::span<const Head> frames_;  ///< heads that see directions and heights differently
    std::vector<Gap> gaps_;
    std::vector<double> heights_;
    slice::LayerFinder row_finder_;
    GapFinder gap_finder_;
    double pitch_ = 0.0;
    double least_tip_ = std::numeric_limits<double>::max();  ///< of all points
    double most_ = 0.0;                                      ///< of all gaps, if that is enough
    bool is_most_enough_ = false;
};

}  // namespace

std::vector<Gap> sunk_at_edges(const model::Mesh& mesh, const Profile& profile, const JobPlan& plan,
                               const JobTable& table) {
    return GapSearch(mesh, profile, plan, table).found(false);
}

double most_sunk_at_edges_mm(const model::Mesh& mesh, const Profile& profile, const JobPlan& plan,
                             const JobTable& table) {
    double most_mm = 0.0;
    for (const Gap& gap : GapSearch(mesh, profile, plan, table).found(true))
        most_mm = std::max(most_mm, gap.sunk_mm);
    return most_mm;
}

}  // namespace psicarve::cam
