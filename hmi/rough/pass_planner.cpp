// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/rough/pass_planner.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "hmi/tool/tool.hpp"
#include "shared/base/units.hpp"

namespace psicarve::rough {
namespace {

// Less than this, or than a twentieth of the stepdown, is left for the next pass.
constexpr double kTrifle_mm = 0.02;
constexpr double kTrifleShare = 0.05;
constexpr double kPointTrifle_mm = 0.002;
constexpr double kShareBetweenRings = 0.25;
// Over clear parts the tip keeps this far outside of its limit and of the stock, and rises and falls at most
// by this slope.
constexpr double kLift_mm = 0.3;
constexpr double kSlope = 0.4;
// Rings and cells between which nothing that the tool would notice can hide.
constexpr double kProbesAcrossTool = 6.0;

/// From the lowest to the highest, evenly, at most `stride` apart.
std::vector<std::size_t> coarse_rings(std::size_t count, std::size_t stride) {
    std::vector<std::size_t> rings{0};
    const std::size_t ways = (count - 1 + stride - 1) / stride;
    for (std::size_t i = 1; i <= ways; ++i) rings.push_back((2 * i * (count - 1) + ways) / (2 * ways));
    return rings;
}

}  // namespace

double ridge_mm(const ToolProfile& tool, double apart_mm) {
    if (tool.shape == ToolShape::point) return 0.0;
    const tool::Tool shape = tool::tool_of(tool, 1.0);
    return tool::rise(shape, std::min(0.5 * apart_mm, shape.radius));
}

/// A head's row of a layer while it is made.
struct PassPlanner::Row {
    std::size_t head;
    std::size_t ring;
    std::size_t first_cell;
    std::vector<std::int32_t> radii;
    std::vector<char> cuts;
    std::vector<double> bites_mm;  ///< by what a tip at `radii`, and between, would cut
};

PassPlanner::PassPlanner(const Rings& rings, RoughStock& stock, const Profile& profile,
                         const PassSettings& settings)
    : rings_(rings),
      stock_(stock),
      settings_(settings),
      raiser_(rings, profile, settings.feed_mm_s, settings.known_blank_mm),
      blank_mm_(profile.blank.reach_mm()),
      tool_mm_(profile.tool.shape == ToolShape::point ? 0.0 : profile.tool.diameter_mm),
      trifle_mm_(tool_mm_ > 0.0 ? std::max(kTrifle_mm, kTrifleShare * settings.stepdown_mm)
                                : kPointTrifle_mm) {
    const double pitch_mm = rings.pitch_mm();
    const double strides =
        pitch_mm > 0.0 && tool_mm_ > 0.0 ? std::floor(settings.stepover_mm / pitch_mm + 1e-9) : 1.0;
    const auto stride = static_cast<std::size_t>(
        std::clamp(strides, 1.0, static_cast<double>(std::max<std::size_t>(1, rings.ring_count()))));
    coarse_ = coarse_rings(rings.ring_count(), stride);
    ridge_mm_ = rough::ridge_mm(profile.tool, static_cast<double>(stride) * pitch_mm);
    for (std::size_t h = 0; h < kHeads; ++h)
        allowance_[h] =
            static_cast<std::int32_t>(std::ceil(settings.allowance_mm * rings.head(h).pulses_per_mm - 1e-6));
}

std::int32_t PassPlanner::target(std::size_t h, std::size_t ring, std::size_t cell) const noexcept {
    return std::max(rings_.tip(h, ring, cell) + allowance_[h], depth_[h]);
}

bool PassPlanner::has_work(std::size_t ring, double least_mm, std::size_t every) {
    for (std::size_t cell = 0; cell < rings_.cell_count(); cell += every) {
        const double tip_mm = rings_.head(0).real_mm(target(0, ring, cell));
        if (stock_.bite_mm({0, ring, cell, tip_mm}) > least_mm) return true;
    }
    return false;
}

void PassPlanner::cut_ring(std::size_t ring) {
    const std::size_t cells = rings_.cell_count();
    const auto place = [&](std::size_t cell) {
        return TipPlace{0, ring, cell, rings_.head(0).real_mm(target(0, ring, cell))};
    };
    for (std::size_t cell = 0; cell < cells; ++cell) stock_.cut(place(cell), place((cell + 1) % cells));
}

// Rings that the stepover requires first; those between them see the stock that these will have left.
std::vector<std::size_t> PassPlanner::rings_with_work() {
    const auto before = stock_.saved();
    const double probe_mm = tool_mm_ / kProbesAcrossTool;
    const double cell_mm = blank_mm_ * rings_.direction_rad(1);
    const auto every = static_cast<std::size_t>(std::max(1.0, std::floor(probe_mm / cell_mm)));
    std::vector<char> is_taken(rings_.ring_count(), 0);
    const auto look = [&](std::size_t ring, double least_mm, std::size_t cells_apart) {
        if (is_taken[ring] != 0 || !has_work(ring, least_mm, cells_apart)) return;
        is_taken[ring] = 1;
        cut_ring(ring);
    };
    for (const std::size_t ring : coarse_) look(ring, trifle_mm_, 1);
    if (coarse_.size() < rings_.ring_count()) {
        const double left_mm = ridge_mm_ + trifle_mm_ + kShareBetweenRings * settings_.stepdown_mm;
        double last_mm = -probe_mm;
        for (std::size_t ring = 0; ring < rings_.ring_count(); ++ring) {
            if (rings_.height_mm(ring) - last_mm < probe_mm) continue;
            last_mm = rings_.height_mm(ring);
            look(ring, left_mm, every);
        }
    }
    stock_.restore(before);
    std::vector<std::size_t> taken;
    for (std::size_t ring = 0; ring < is_taken.size(); ++ring) {
        if (is_taken[ring] != 0) taken.push_back(ring);
    }
    return taken;
}

RoughPass PassPlanner::plan(double depth_mm, std::size_t first_layer) {
    depth_mm_ = depth_mm;
    for (std::size_t h = 0; h < kHeads; ++h) depth_[h] = rings_.head(h).counted_outside(depth_mm);
    RoughPass pass;
    pass.depth_mm = depth_mm;
    for (const std::size_t ring : rings_with_work()) {
        const RoughPass before{depth_mm, {}, pass.cut_points, pass.air_points};
        RoughLayer layer = make_layer(pass, ring, first_layer + pass.layers.size());
        if (pass.cut_points > before.cut_points) {
            if (!pass.layers.empty())
                clear_end(pass.layers.back(), ring, first_layer + pass.layers.size() - 1);
            pass.layers.push_back(std::move(layer));
        } else {
            // A ring between the others, carved before, has left nothing for it.
            pass.air_points = before.air_points;
        }
    }
    return pass;
}

RoughLayer PassPlanner::idle_layer(const RoughPass& pass, std::size_t layer) {
    std::size_t ring = pass.layers.back().ring;
    for (std::size_t other = rings_.ring_count(); !is_in_reach(ring, layer) && other-- > 0;) {
        if (is_in_reach(other, layer)) ring = other;
    }
    RoughPass alone;
    RoughLayer idle = make_layer(alone, ring, layer);
    // A layer that is outside altogether would contradict the blank (shared/job/outside.hpp).
    idle.raised = idle.radii;
    idle.saved_s = 0.0;
    return idle;
}

bool PassPlanner::is_in_reach(std::size_t ring, std::size_t layer) const noexcept {
    const std::size_t points = rings_.point_count();
    const std::size_t first = first_cell(settings_.joining, points, layer);
    for (std::size_t h = 0; h < kHeads; ++h) {
        for (std::size_t point = 0; point < points; ++point) {
            const std::size_t cell = (first + h * (points - 1) + point) % rings_.cell_count();
            if (target(h, ring, cell) > rings_.head(h).travel) return false;
        }
    }
    return true;
}

RoughLayer PassPlanner::make_layer(RoughPass& pass, std::size_t ring, std::size_t layer) {
    const std::size_t points = rings_.point_count();
    RoughLayer made;
    made.ring = ring;
    const std::size_t first_carved = carved_point(settings_.joining, static_cast<std::uint32_t>(points),
                                                  static_cast<std::uint32_t>(layer), 0);
    ByPoint<char> cuts;
    for (std::size_t h = 0; h < kHeads; ++h) {
        Row row{h, ring, first_cell(settings_.joining, points, layer) + h * (points - 1), {}, {}, {}};
        for (std::size_t point = 0; point < points; ++point)
            row.radii.push_back(target(h, ring, (row.first_cell + point) % rings_.cell_count()));
        if (!pass.layers.empty()) clear_link(row, pass.layers.back().ring, first_carved);
        find_cuts(pass, row);
        lift_where_clear(row);
        cut_row(row);
        made.radii[h] = std::move(row.radii);
        cuts[h] = std::move(row.cuts);
    }
    // No cut happens in between, so the stock does not change.
    made.raised = made.radii;
    made.saved_s = raiser_.raise(made.raised, cuts);
    return made;
}

void PassPlanner::find_cuts(RoughPass& pass, Row& row) {
    const std::size_t points = row.radii.size();
    std::vector<char> cuts(points, 0);
    row.bites_mm.assign(points, 0.0);
    for (std::size_t point = 0; point < points; ++point) {
        row.bites_mm[point] = stock_.bite_mm(place_of(row, point));
        cuts[point] = row.bites_mm[point] > trifle_mm_ ? 1 : 0;
    }
    pass.cut_points += static_cast<std::uint64_t>(std::count(cuts.begin(), cuts.end(), 1));
    pass.air_points += static_cast<std::uint64_t>(std::count(cuts.begin(), cuts.end(), 0));
    // The way to the next point belongs to the cut.
    row.cuts = cuts;
    for (std::size_t point = 0; point < points; ++point) {
        if (point > 0 && cuts[point - 1] != 0) row.cuts[point] = 1;
        if (point + 1 < points && cuts[point + 1] != 0) row.cuts[point] = 1;
    }
    for (std::size_t point = 0; point + 1 < points; ++point) {
        if (row.cuts[point] != 0 && row.cuts[point + 1] != 0) continue;
        const double between_mm = stock_.bite_between_mm(place_of(row, point), place_of(row, point + 1));
        for (double* bite_mm : {&row.bites_mm[point], &row.bites_mm[point + 1]})
            *bite_mm = std::max(*bite_mm, between_mm);
    }
}

// The least hull over the tip's limits and over the trifles that stay there, that nowhere changes faster than
// the slope; at a cut's edge it begins low.
void PassPlanner::lift_where_clear(Row& row) const {
    const std::vector<char>& cuts = row.cuts;
    const RoughHead& head = rings_.head(row.head);
    const double step =
        kSlope * std::max(depth_mm_, 0.5 * blank_mm_) * rings_.direction_rad(1) * head.pulses_per_mm;
    const double lift = kLift_mm * head.pulses_per_mm;
    const std::size_t points = row.radii.size();
    for (std::size_t first = 0; first < points;) {
        std::size_t end = first;
        while (end < points && cuts[end] == 0) ++end;
        if (end == first) {
            ++first;
            continue;
        }
        std::vector<double> hull(end - first);
        for (std::size_t i = 0; i < hull.size(); ++i) {
            double most = lift + row.bites_mm[first + i] * head.pulses_per_mm;
            if (first > 0) most = std::min(most, step * static_cast<double>(i + 1));
            if (end < points) most = std::min(most, step * static_cast<double>(hull.size() - i));
            hull[i] = static_cast<double>(row.radii[first + i]) + most;
        }
        for (std::size_t i = 1; i < hull.size(); ++i) hull[i] = std::max(hull[i], hull[i - 1] - step);
        for (std::size_t i = hull.size() - 1; i-- > 0;) hull[i] = std::max(hull[i], hull[i + 1] - step);
        for (std::size_t i = 0; i < hull.size(); ++i) {
            const auto lifted = std::min(std::ceil(hull[i]), static_cast<double>(head.travel));
            row.radii[first + i] = std::max(row.radii[first + i], static_cast<std::int32_t>(lifted));
        }
        first = end;
    }
}

// From ring to ring Y passes those between them: no deeper than they allow. The other head ends in that
// direction, so nothing stays there.
void PassPlanner::clear_link(Row& row, std::size_t ring_before, std::size_t point) const {
    const std::size_t cell = (row.first_cell + point) % rings_.cell_count();
    for (std::size_t ring = ring_before; ring <= row.ring; ++ring)
        row.radii[point] = std::max(row.radii[point], target(row.head, ring, cell));
    // A spiral's own rows stand between the rings, and where the heads differ each at heights of its own.
    if (settings_.joining != Joining::spiral || rings_.heads_agree()) return;
    const RoughHead& head = rings_.head(row.head);
    const auto clear = head.counted_outside(rings_.most_about_mm(ring_before, row.ring, cell));
    row.radii[point] = std::max(row.radii[point], std::min(clear, head.travel));
}

// The link leaves from there: the finishing pass takes the material that this leaves in one direction.
void PassPlanner::clear_end(RoughLayer& before, std::size_t ring, std::size_t layer) const {
    const std::size_t points = rings_.point_count();
    const std::size_t last =
        carved_point(settings_.joining, static_cast<std::uint32_t>(points), static_cast<std::uint32_t>(layer),
                     static_cast<std::uint32_t>(points - 1));
    for (std::size_t h = 0; h < kHeads; ++h) {
        Row row{h,
                ring,
                first_cell(settings_.joining, points, layer) + h * (points - 1),
                std::move(before.radii[h]),
                {},
                {}};
        clear_link(row, before.ring, last);
        before.radii[h] = std::move(row.radii);
        before.raised[h][last] = std::max(before.raised[h][last], before.radii[h][last]);
    }
}

void PassPlanner::cut_row(const Row& row) {
    const std::size_t points = row.radii.size();
    for (std::size_t point = 0; point < points; ++point) {
        const std::size_t next = std::min(point + 1, points - 1);
        if (row.cuts[point] != 0 || row.cuts[next] != 0)
            stock_.cut(place_of(row, point), place_of(row, next));
    }
}

TipPlace PassPlanner::place_of(const Row& row, std::size_t point) const {
    const std::size_t cell = (row.first_cell + point) % rings_.cell_count();
    return {row.head, row.ring, cell, rings_.head(row.head).real_mm(row.radii[point])};
}

}  // namespace psicarve::rough
