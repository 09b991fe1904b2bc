// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/slice/best_axis.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

#include "hmi/model/mesh.hpp"
#include "hmi/slice/directions.hpp"
#include "hmi/slice/layer_buckets.hpp"
#include "hmi/slice/layer_scan.hpp"
#include "hmi/slice/placement.hpp"
#include "hmi/slice/slicer.hpp"
#include "shared/base/result.hpp"
#include "shared/base/units.hpp"

namespace psicarve::slice {
namespace {

constexpr std::size_t kSections = 48;
constexpr std::size_t kDirections = 180;
constexpr int kGrid = 12;               // steps along each side of the box
constexpr int kHalvings = 7;            // down to 1/1500 of the box
constexpr double kRadiusSlack = 1.005;  // the few directions may miss the very largest radius

/// The sections of the model at a few heights, as segments that can be seen from any axis.
class Sections {
public:
    Sections(const model::Mesh& mesh, Up up, double bottom, double height) {
        const auto origin = placed(up, mesh.origin);
        const std::vector<double> heights = layer_heights(bottom - origin[2], height, kSections);
        const LayerBuckets buckets(mesh.triangles, up, heights, heights);
        const FacetCutter cutter(up, -origin[0], -origin[1]);
        std::vector<CutFacet> reaching;
        for (std::size_t layer = 0; layer < heights.size(); ++layer) {
            for (const CutFacet& t : buckets.starting_in(layer)) reaching.push_back(t);
            for (const CutFacet& t : reaching) {
                segments_.push_back(cutter.cut(mesh.triangles[t.facet], heights[layer]));
            }
            std::erase_if(reaching, [layer](const CutFacet& t) { return t.end_layer <= layer + 1; });
            ends_.push_back(segments_.size());
        }
    }

    AxisLoss loss_at(const std::array<double, 2>& axis, LayerScan& scan) const {
        AxisLoss loss;
        double all = 0.0;
        double outer = 0.0;
        std::size_t outside = 0;
        std::size_t next = 0;
        for (const std::size_t end : ends_) {
            for (; next < end; ++next) {
                const SectionSegment& s = segments_[next];
                scan.add_segment({s.px - axis[0], s.py - axis[1], s.qx - axis[0], s.qy - axis[1]});
            }
            const LayerTotals& totals = scan.finish();
            all += totals.radius_sum;
            outer += totals.outer_sum;
            outside += totals.contains_axis ? 0 : 1;
            loss.radius_max = std::max(loss.radius_max, totals.radius_max);
        }
        loss.undercut_share = all > 0.0 ? std::max(0.0, (all - outer) / all) : 0.0;
        loss.outside_share = static_cast<double>(outside) / static_cast<double>(ends_.size());
        return loss;
    }

private:
    std::vector<SectionSegment> segments_;
    std::vector<std::size_t> ends_;
};

/// Walks through candidate positions and remembers the best.
class Search {
public:
    Search(const Sections& sections, const std::array<double, 2>& centre, double radius_limit)
        : sections_(sections),
          directions_(evenly_spaced()),
          scan_(directions_),
          centre_(centre),
          radius_limit_(radius_limit),
          best_(centre),
          best_loss_(sections.loss_at(centre, scan_)) {}

    void consider(const std::array<double, 2>& axis) {
        const AxisLoss loss = sections_.loss_at(axis, scan_);
        if (!is_better(axis, loss)) return;
        best_ = axis;
        best_loss_ = loss;
    }

    AxisLoss loss_at(const std::array<double, 2>& axis) { return sections_.loss_at(axis, scan_); }
    const std::array<double, 2>& best() const noexcept { return best_; }
    const AxisLoss& best_loss() const noexcept { return best_loss_; }

private:
    static Directions evenly_spaced() {
        std::vector<double> angles(kDirections);
        for (std::size_t k = 0; k < kDirections; ++k) {
            angles[k] = 2.0 * kPi * static_cast<double>(k) / static_cast<double>(kDirections);
        }
        return Directions(angles);
    }

    bool fits(const AxisLoss& loss) const noexcept { return loss.radius_max * kRadiusSlack <= radius_limit_; }

    bool is_better(const std::array<double, 2>& axis, const AxisLoss& loss) const noexcept {
        if (fits(loss) != fits(best_loss_)) return fits(loss);
        if (loss.total() != best_loss_.total()) return loss.total() < best_loss_.total();
        const auto from_centre = [this](const std::array<double, 2>& p) {
            return (p[0] - centre_[0]) * (p[0] - centre_[0]) + (p[1] - centre_[1]) * (p[1] - centre_[1]);
        };
        return from_centre(axis) < from_centre(best_);
    }

    const Sections& sections_;
    Directions directions_;
    LayerScan scan_;
    std::array<double, 2> centre_;
    double radius_limit_;
    std::array<double, 2> best_;
    AxisLoss best_loss_;
};

bool still_wanted(const Progress& progress, double done) {
    return !progress || progress(done);
}

}  // namespace

Result<AxisSearch> search_axis(const model::Mesh& mesh, Up up, const std::array<double, 2>& used,
                               double radius_limit, const Progress& progress) {
    try {
        const auto low = placed(up, mesh.facts.min);
        const auto high = placed(up, mesh.facts.max);
        const std::array<double, 2> size{high[0] - low[0], high[1] - low[1]};
        const Sections sections(mesh, up, low[2], high[2] - low[2]);
        Search search(sections, {low[0] + 0.5 * size[0], low[1] + 0.5 * size[1]}, radius_limit);
        AxisSearch found;
        found.centre_loss = search.best_loss();
        found.used_loss = search.loss_at(used);
        search.consider(used);
        constexpr double kGridPart = 0.8;  // of the whole work
        for (int row = 0; row <= kGrid; ++row) {
            for (int column = 0; column <= kGrid; ++column) {
                search.consider({low[0] + size[0] * column / kGrid, low[1] + size[1] * row / kGrid});
            }
            if (!still_wanted(progress, kGridPart * row / kGrid)) {
                return Error{ErrorCode::cancelled, "looking for the best axis was cancelled"};
            }
        }
        double part = 0.5 / kGrid;
        for (int halving = 0; halving < kHalvings; ++halving, part *= 0.5) {
            const auto around = search.best();
            for (int row = -1; row <= 1; ++row) {
                for (int column = -1; column <= 1; ++column) {
                    if (row == 0 && column == 0) continue;
                    search.consider({around[0] + size[0] * part * column, around[1] + size[1] * part * row});
                }
            }
        }
        found.best = search.best();
        found.best_loss = search.best_loss();
        return found;
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::out_of_room, "not enough memory to slice " + mesh.source_name};
    }
}

double largest_radius(const model::Mesh& mesh, const Placement& placement) {
    const auto from = source_coordinate(placement.up);
    double largest = 0.0;
    for (const model::Triangle& triangle : mesh.triangles) {
        for (const auto& vertex : triangle.vertices) {
            const double x = mesh.origin[from[0]] + double{vertex[from[0]]} - placement.axis_x;
            const double y = mesh.origin[from[1]] + double{vertex[from[1]]} - placement.axis_y;
            largest = std::max(largest, x * x + y * y);
        }
    }
    return std::sqrt(largest);
}

}  // namespace psicarve::slice
