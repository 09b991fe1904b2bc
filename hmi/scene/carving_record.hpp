// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "hmi/cam/prepared_job.hpp"
#include "hmi/surface/carved_surface.hpp"
#include "hmi/surface/job_geometry.hpp"
#include "shared/machine/status.hpp"

namespace psicarve::session {

/// The machine's axes, seen from the front: R1 comes from the left (direction pi), R2 from the right.
struct MachinePose {
    struct Head {
        double direction_rad = 0.0;
        double radius_mm = 0.0;  ///< of the tip
        double height_mm = 0.0;  ///< of the tip, above the middle of the scene
    };
    double part_turn_rad = 0.0;  ///< the turn of the workpiece from its own directions
    std::array<Head, verify::kHeadCount> heads{};
};

/// The blank as the core's increments carve it, tick by tick. Layers that were finished before the window
/// looked, or while increments were lost, are taken from the job.
class CarvingRecord {
public:
    /// Takes time in proportion to the job's size.
    static Result<std::unique_ptr<CarvingRecord>> make(std::shared_ptr<const cam::PreparedJob> job);

    /// The job's layers that can be wrong, of all its passes: their rows, and about the height of a layer
    /// that is no row those that are nearer to it than to its pass' next.
    void set_doubt(std::span<const verify::LayerRange> job_layers);

    // Layers are rows of the finishing pass, from 0, unless said otherwise.

    /// Grows whenever layers come into doubt, or are freed of it.
    std::uint64_t doubt_edition() const noexcept { return doubt_edition_; }
    bool is_in_doubt(std::uint32_t layer) const noexcept {
        return !is_in_doubt_.empty() && is_in_doubt_[layer] != 0;
    }
    /// Whether any of these layers is, first .. last.
    bool is_in_doubt(std::uint32_t first, std::uint32_t last) const noexcept;

    void take(const IncrementEntry& entry);
    /// All layers of the job below this one are done, seen or not. Handles at most `most_cells`, and
    /// continues with the next call.
    void take_as_planned(std::uint32_t layers_done, std::uint64_t most_cells = ~std::uint64_t{0});
    /// For a recording: sets a cell as it was, deeper or not.
    void put(std::uint32_t layer, std::uint32_t cell, float radius_mm);

    /// Grows whenever something was carved.
    std::uint64_t edition() const noexcept { return edition_; }
    /// How many layers were taken from the job because they were not seen.
    std::uint32_t planned_layers() const noexcept { return planned_layers_; }
    bool is_carved(std::uint32_t layer, std::uint32_t cell) const noexcept {
        return layer < layers_done_ || surface_.radii_mm(layer)[cell] < uncarved_mm();
    }
    /// How far the deepest radius of a head seen in a cell lies outside of the job's radius there and the
    /// path's tolerance [pulses]; negative: too deep. 0 for a cell that was not seen. Requires a carved cell.
    std::int32_t deviation_pulses(std::uint32_t layer, std::uint32_t cell) const noexcept {
        return surface_.deviation_pulses(layer, cell);
    }
    /// The layers that have changed since the last call, in no order.
    std::vector<std::uint32_t> take_changed_layers();

    const verify::CarvedSurface& surface() const noexcept { return surface_; }
    const verify::JobGeometry& geometry() const noexcept { return geometry_; }
    double bottom_mm() const noexcept { return surface_.layer_height_mm(0); }
    double top_mm() const noexcept { return surface_.layer_height_mm(surface_.layer_count() - 1); }
    double blank_reach_mm() const noexcept;
    /// The radius up to which there is material in a cell, with the profile's blank at its place.
    float shown_mm(std::uint32_t layer, std::uint32_t cell) const noexcept;
    /// The pose with the axes at these positions; heights above `middle_mm`.
    MachinePose pose(const verify::Positions& positions_pulses, double middle_mm) const noexcept;
    const Profile& profile() const noexcept { return job_->profile; }

private:
    CarvingRecord(std::shared_ptr<const cam::PreparedJob> job, const verify::JobGeometry& geometry);
    /// The value of an uncarved cell in the surface.
    float uncarved_mm() const noexcept { return static_cast<float>(geometry_.blank_radius_mm()); }
    void note_change(std::uint32_t layer);
    void note_deviation(std::size_t h, std::uint32_t layer, const IncrementEntry& entry, double real_mm);

    std::shared_ptr<const cam::PreparedJob> job_;
    verify::JobGeometry geometry_;
    verify::CarvedSurface surface_;
    std::vector<float> blank_mm_;            ///< radius of its surface by cell; empty: not known
    std::vector<std::uint8_t> has_changed_;  ///< by layer
    std::vector<std::uint8_t> is_in_doubt_;  ///< by layer; empty: none is
    std::vector<std::uint32_t> changed_;
    std::uint32_t planned_layers_ = 0;
    std::uint32_t layers_done_ = 0;
    std::uint64_t edition_ = 0;
    std::uint64_t doubt_edition_ = 0;
};

}  // namespace psicarve::session
