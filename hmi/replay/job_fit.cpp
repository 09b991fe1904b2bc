// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/replay/job_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "hmi/replay/job_place.hpp"

namespace psicarve::replay {
namespace {

constexpr std::int64_t kInstants = 400;
/// A pulse for each of two roundings.
constexpr std::int64_t kRounding_pulses = 2;

using Interval = std::pair<std::int64_t, std::int64_t>;

/// From the first time that the spindle was on to the last.
std::optional<Interval> spinning(const TraceIndex& index) {
    const SignalWord spindle = bit_of(Signal::spindle);
    std::optional<std::int64_t> from_ns;
    if ((index.start().initial_levels & spindle) != 0) from_ns = 0;
    std::int64_t until_ns = index.end_ns();
    for (const TraceIndex::PinChange& change : index.changes()) {
        if (((change.before ^ change.after) & spindle) == 0) continue;
        if ((change.after & spindle) != 0) {
            if (!from_ns) from_ns = change.time_ns;
            until_ns = index.end_ns();
        } else {
            until_ns = change.time_ns;
        }
    }
    if (!from_ns || *from_ns >= until_ns) return std::nullopt;
    return Interval{*from_ns, until_ns};
}

/// The job's layers by their heights: several passes have layers at the same one.
class LayersByHeight {
public:
    explicit LayersByHeight(const verify::JobGeometry& geometry) {
        const auto heights = geometry.job().layer_heights_pulses();
        // Those of the finishing pass are found by their direction, too.
        for (std::uint32_t layer = 0; layer < geometry.first_row_layer(); ++layer)
            layers_.emplace_back(heights[layer], layer);
        std::sort(layers_.begin(), layers_.end());
    }
    template <typename Fits>
    bool any_at(std::int64_t height_pulses, std::int64_t slack_pulses, Fits fits) const {
        const auto first =
            std::lower_bound(layers_.begin(), layers_.end(), std::pair{height_pulses - slack_pulses, 0U});
        for (auto at = first; at != layers_.end() && at->first <= height_pulses + slack_pulses; ++at) {
            if (fits(at->second)) return true;
        }
        return false;
    }

private:
    std::vector<std::pair<std::int64_t, std::uint32_t>> layers_;
};

class FitJudge {
public:
    explicit FitJudge(const verify::JobGeometry& geometry) : geometry_(geometry), roughing_(geometry) {
        for (const std::size_t h : {std::size_t{0}, std::size_t{1}})
            slack_pulses_[h] = slack(geometry.head(h).pulses_per_mm);
        // Only a spiral rises while it carves.
        slack_pulses_[index_of(Axis::y)] =
            geometry.is_spiral() ? slack(geometry.y_pulses_per_mm()) : kRounding_pulses;
    }

    bool fits(const verify::Positions& at) const {
        const auto finishing = job_place(geometry_, at);
        if (finishing && fits_at(*finishing, at)) return true;
        return roughing_.any_at(
            at[index_of(Axis::y)], slack_pulses_[index_of(Axis::y)], [&](std::uint32_t layer) {
                return fits_at(place_in_layer(geometry_, layer, at[index_of(Axis::psi)]), at);
            });
    }

private:
    std::int64_t slack(double pulses_per_mm) const {
        return static_cast<std::int64_t>(std::ceil(geometry_.tolerance_mm() * pulses_per_mm)) +
               kRounding_pulses;
    }
    /// Between this point and the next one.
    bool fits_at(const JobPlace& place, const verify::Positions& at) const {
        const std::uint32_t last = geometry_.point_count() - 1;
        const verify::Positions from = geometry_.target(place.layer, place.point);
        const verify::Positions to = geometry_.target(place.layer, std::min(place.point + 1, last));
        for (const Axis axis : {Axis::r1, Axis::r2, Axis::y}) {
            const std::size_t k = index_of(axis);
            if (at[k] < std::min(from[k], to[k]) - slack_pulses_[k]) return false;
            if (at[k] > std::max(from[k], to[k]) + slack_pulses_[k]) return false;
        }
        return true;
    }

    const verify::JobGeometry& geometry_;
    LayersByHeight roughing_;
    std::array<std::int64_t, kAxisCount> slack_pulses_{};
};

}  // namespace

Result<JobFit> job_fit(std::shared_ptr<const TraceIndex> index, const verify::JobGeometry& geometry) {
    JobFit fit;
    const auto interval = spinning(*index);
    if (!interval) return fit;
    const FitJudge judge{geometry};
    TraceCursor cursor{std::move(index)};
    std::optional<std::int64_t> psi_before;
    for (std::int64_t i = 1; i < kInstants; ++i) {
        const std::int64_t passed_ns = (interval->second - interval->first) / kInstants * i;
        const auto moment = cursor.at(interval->first + passed_ns);
        if (!moment) return moment.error();
        const std::int64_t psi = moment->position_pulses[index_of(Axis::psi)];
        // Heads that go in or out, or wait, do so while the table stands.
        const bool turns = psi_before && *psi_before != psi;
        psi_before = psi;
        if (!turns || (moment->levels & bit_of(Signal::spindle)) == 0) continue;
        ++fit.places;
        fit.fitting += judge.fits(moment->position_pulses) ? 1 : 0;
    }
    return fit;
}

}  // namespace psicarve::replay
