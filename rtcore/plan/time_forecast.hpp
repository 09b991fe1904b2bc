// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "rtcore/plan/machine_limits.hpp"
#include "rtcore/plan/table_program.hpp"
#include "shared/job/job.hpp"

namespace psicarve::plan {

/// About how long each layer of a job takes, long before all of it is planned: the least time of its ways,
/// times how much longer than that the nearest of a few layers take that are planned as samples; with the way
/// to it from the layer before. A job's layers differ much, but least times know of most of it. Costs some
/// 20 ns a point and the planning of the samples, 24 layers of a long job.
class TimeForecast {
public:
    TimeForecast(const MachineLimits& limits, std::shared_ptr<const JobView> job);

    /// Does a layer's part of the work; false: all is done.
    bool next();
    /// From the first point to the end of each layer [s]. Requires that all is done.
    std::vector<double> layer_ends_seconds() const;

private:
    /// Layers that are planned alone.
    struct Sample {
        std::uint32_t pass;
        LayerSpan layers;
        double ratio = 1.0;  ///< planned over least
    };
    void choose_samples(std::uint32_t pass);
    bool add_sample();
    Sample sample_from(std::uint32_t layer) const;
    double doubt_seconds(const Sample& before, const Sample& after) const;
    double least_seconds_of(const LayerSpan& layers) const;
    double way_seconds(std::uint32_t layer) const;
    double cut_seconds(std::uint32_t layer) const;
    double planned_ratio(const LayerSpan& layers) const;
    double ratio_of(std::uint32_t layer) const;

    MachineLimits limits_;
    std::shared_ptr<const JobView> job_;
    std::vector<double> way_s_;  ///< by layer: to its first point
    std::vector<double> cut_s_;  ///< by layer: the least from there to its end
    std::vector<Sample> samples_;
    std::size_t next_sample_ = 0;
    std::size_t samples_to_add_ = 0;  ///< once those chosen at first are planned
};

}  // namespace psicarve::plan
