// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "hmi/surface/job_geometry.hpp"

namespace psicarve::verify {

/// A point of a job in the order of carving.
struct CarvePoint {
    std::uint32_t layer = 0;
    std::uint32_t step = 0;  ///< of the layer's points

    friend bool operator==(const CarvePoint&, const CarvePoint&) = default;
};

/// How many points of each layer have been carved. Those of the first layer that are left out on purpose
/// count as carved in that layer, but not among `points`.
class CarveProgress {
public:
    /// The geometry outlives it.
    explicit CarveProgress(const JobGeometry& geometry);

    void count(std::uint32_t layer) noexcept;
    /// The layer's last point counted, though it had only been passed.
    void take_back(std::uint32_t layer) noexcept;
    /// What lies before this point in its layer is carved still, as far as it was; all behind it is carved
    /// anew.
    void forget_from(CarvePoint begin) noexcept;

    std::uint64_t points() const noexcept { return points_; }
    std::uint32_t points_of(std::uint32_t layer) const noexcept { return of_layer_[layer]; }
    /// The first layer of which not all points have been carved; the end of those to be carved if all have.
    std::uint32_t due_layer() const noexcept;

    /// What had been carved at some instant.
    struct Kept {
        std::vector<std::uint32_t> of_layer;
        std::uint64_t points = 0;
    };
    Kept kept() const { return {of_layer_, points_}; }
    void restore(const Kept& earlier);

private:
    const JobGeometry& geometry_;
    std::vector<std::uint32_t> of_layer_;
    std::uint64_t points_ = 0;
};

}  // namespace psicarve::verify
