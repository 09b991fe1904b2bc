// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hmi/rough/rings.hpp"
#include "hmi/rough/rough_stock.hpp"
#include "shared/job.hpp"
#include "shared/profile.hpp"

namespace psicarve::rough {

/// Looks where both heads stand clear of the stock, by carving the layers of a job's roughing passes once
/// more as the machine does: with the radii that the job has in the end. So a planner that counts on what is
/// not carved yet makes no air of stock.
class AirFinder {
public:
    AirFinder(const Rings& rings, const Profile& profile, Joining joining);

    /// By point: 1 where both heads are clear, and so also on the way to a neighbour that is 1 too. The job's
    /// layers in order, each with its radii by head and point, counted.
    std::vector<std::uint8_t> carve(std::size_t ring, std::size_t layer,
                                    const std::array<std::vector<std::int32_t>, kHeads>& radii);

private:
    TipPlace place(std::size_t head, std::size_t point, double in_mm) const;

    const Rings& rings_;
    RoughStock stock_;
    Joining joining_;
    std::size_t ring_ = 0;
    std::size_t first_cell_ = 0;
    const std::array<std::vector<std::int32_t>, kHeads>* radii_ = nullptr;
};

/// Ways from point to point along a layer that lead through air alone.
std::uint64_t air_ways(const std::vector<std::uint8_t>& air) noexcept;

}  // namespace psicarve::rough
