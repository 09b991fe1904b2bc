// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "hmi/cam/prepared_job.hpp"
#include "hmi/session/mesh_scene.hpp"
#include "hmi/verify/carved_surface.hpp"
#include "hmi/verify/job_geometry.hpp"
#include "shared/status.hpp"

namespace psicarve::session {

/// The blank as the core says that it was carved: from the increments it reports, tick by tick. Layers that
/// were finished before anybody looked, or while increments were lost, are taken from the job.
class CarvingRecord {
public:
    static Result<std::unique_ptr<CarvingRecord>> make(std::shared_ptr<const cam::PreparedJob> job);

    void take(const IncrementEntry& entry);
    /// All layers below this one are done, seen or not.
    void take_as_planned(std::uint32_t layers_done);
    void start_anew();

    /// Grows whenever something was carved.
    std::uint64_t edition() const noexcept { return edition_; }
    /// How many layers were not seen but taken from the job.
    std::uint32_t planned_layers() const noexcept { return planned_layers_; }
    /// Where the tips are on the workpiece, relative to the middle of the scene's box [mm]; nothing before
    /// the first.
    std::optional<std::array<double, 3>> tip(std::size_t head) const noexcept;

    /// What stands on the table now, at most so many cells round and up. Facets carved are `done`, others
    /// `blank`.
    MeshScene scene(std::size_t most_round, std::size_t most_up, std::uint32_t done_rgb,
                    std::uint32_t blank_rgb) const;

private:
    CarvingRecord(std::shared_ptr<const cam::PreparedJob> job, const verify::JobGeometry& geometry);
    /// As the surface keeps it.
    float uncarved_mm() const noexcept { return static_cast<float>(geometry_.blank_radius_mm()); }
    double bottom_mm() const noexcept { return surface_.layer_height_mm(0); }
    double top_mm() const noexcept { return surface_.layer_height_mm(surface_.layer_count() - 1); }

    std::shared_ptr<const cam::PreparedJob> job_;
    verify::JobGeometry geometry_;
    verify::CarvedSurface surface_;
    std::optional<IncrementEntry> last_;
    std::uint32_t planned_layers_ = 0;
    std::uint32_t layers_done_ = 0;
    std::uint64_t edition_ = 0;
};

}  // namespace psicarve::session
