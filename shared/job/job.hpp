// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve {

/// The purpose of a run of layers.
enum class PassKind : std::uint32_t { roughing = 1, finishing = 2 };

/// A run of a job's layers, carved from its lowest to its highest. Before each but the first the heads go out
/// beyond the blank, Y goes to its first layer, and the heads plunge again.
struct JobPass {
    std::uint32_t kind;         ///< PassKind
    std::uint32_t number;       ///< from 1 on; several runs that carve to one depth share it
    std::uint32_t first_layer;  ///< of the job: layers count on through all passes
    std::uint32_t layer_count;
    double allowance_mm;  ///< material that it leaves on the finished surface
    double depth_mm;      ///< it does not go below this radius; 0: as deep as the finished surface
    double clear_mm;      ///< material may stand up to this radius when the pass begins; 0: not known
};
static_assert(sizeof(JobPass) == 40, "bump kLayoutVersion in layout.hpp");

/// One point/layer table and all that is needed to carve it, as a slicer makes it (heap memory, one process).
/// Point j of every layer stands at point_angle_pulses(j) within the layer's sweep, also where zigzag carves
/// the layer backwards; rows of the radius tables are layers. See `table_angle_pulses`.
///
/// The rows of a spiral are joined: row 0 is a ring at heights[0]; row i rises from heights[i - 1] to
/// heights[i], where row i + 1 begins in the very point in which it ends; the last row closes with a ring:
/// its height is that of the row before. So L layers make L + 1 rows (one layer: one ring). Only the
/// finishing pass is a spiral: layers of roughing passes are rings.
struct JobTable {
    std::uint32_t layer_count = 0;
    std::uint32_t point_count = 0;  ///< per head and layer
    std::int64_t psi_sweep_pulses = 0;
    Joining joining = Joining::continuous;
    double feed_mm_s = 0.0;
    std::vector<std::int64_t> layer_height_pulses;  ///< [layer_count], Y at the layer's end
    std::vector<std::int32_t> r_left_pulses;        ///< [layer_count * point_count], head R1
    std::vector<std::int32_t> r_right_pulses;       ///< [layer_count * point_count], head R2
    std::string source_name;                        ///< file name without folders
    std::uint64_t source_hash = 0;                  ///< XXH3 of the source file's bytes
    std::string profile_toml;                       ///< the whole machine profile that the job was made for
    std::string report_json;                        ///< the slicer's findings
    std::vector<JobPass> passes;                    ///< in order; none: all layers are one finishing pass
};

/// Absolute table position of point `point` in layer `layer`: continuous grows on by a sweep each layer;
/// zigzag stays within one sweep. RT: yes.
std::int64_t table_angle_pulses(Joining joining, std::int64_t psi_sweep_pulses, std::int64_t point_count,
                                std::int64_t layer, std::int64_t point) noexcept;
/// Y of point `point` in layer `layer`: the layer's own, but for the rising rows of a spiral. RT: yes.
std::int64_t table_height_pulses(Joining joining, std::span<const std::int64_t> layer_heights_pulses,
                                 std::int64_t point_count, std::size_t layer, std::int64_t point) noexcept;
/// Which point of a layer is carved as its `step`-th: zigzag runs odd layers backwards. RT: yes.
std::uint32_t carved_point(Joining joining, std::uint32_t point_count, std::uint32_t layer,
                           std::uint32_t step) noexcept;

inline constexpr std::uint32_t kMaxJobCount = 1'000'000;             ///< layers, and points in a layer
inline constexpr std::int64_t kMaxSweepPulses = 50'000'000;          ///< half the greatest pulses_per_rev
inline constexpr std::int64_t kMaxHeightPulses = 1'000'000'000'000;  ///< of a spiral, up or down
inline constexpr std::uint64_t kReportTextBytes = 16 * 1024;         ///< a longer report is refused
inline constexpr std::uint32_t kMaxJobPasses = 1024;
inline constexpr double kMostPassRadius_mm = 1e6;  ///< far beyond every machine, and safe to calculate with

inline constexpr std::uint64_t kJobMagic = 0x31424f4a41435350ULL;  // "PSCAJOB1"

/// First bytes of a job blob. The blob is one contiguous piece of memory: this header, profile text, report
/// text, layer heights (int64), r_left (int32), r_right (int32), passes (JobPass), each part at a multiple of
/// 8 bytes. The same bytes stand in a segment's job slot and in a job file. A job of one finishing pass has
/// no table of passes, as in files older than passes.
struct JobHeader {
    std::uint64_t magic;
    std::uint64_t total_bytes;  ///< of the whole blob
    std::uint32_t layer_count;
    std::uint32_t point_count;
    std::int64_t psi_sweep_pulses;
    std::uint32_t joining;           ///< Joining
    std::int32_t direction_sign[4];  ///< by axis: +1 when the direction pin is high for positive, else -1
    std::uint32_t pass_count;        ///< 0: one finishing pass
    double feed_mm_s;
    std::uint64_t source_hash;
    char source_name[128];  ///< zero-terminated
    std::uint64_t profile_offset;
    std::uint64_t profile_bytes;
    std::uint64_t report_offset;
    std::uint64_t report_bytes;
    std::uint64_t heights_offset;
    std::uint64_t r_left_offset;
    std::uint64_t r_right_offset;
};
static_assert(sizeof(JobHeader) == 256, "bump kLayoutVersion in layout.hpp");

/// Requires table sizes that fit the counts. Direction signs come from the profile's text; a name that is too
/// long is cut. Whether the job can run, JobView::check and check_job say.
std::vector<std::byte> job_blob_from_table(const JobTable& table);
/// XXH3 over a blob: equal for equal jobs.
std::uint64_t job_checksum(std::span<const std::byte> blob) noexcept;
std::uint64_t job_blob_bytes(std::uint64_t layer_count, std::uint64_t point_count,
                             std::uint64_t profile_bytes, std::uint64_t report_bytes,
                             std::uint64_t pass_count = 0) noexcept;

/// A checked read-only view of a job blob in memory that no other process can change (copy first, then
/// check). Holds pointers into the blob: the blob outlives the view.
class JobView {
public:
    /// Trusts no count or offset: checks sizes, bounds, overlaps and text ends. Does not look at the machine:
    /// see check_job.
    static Result<JobView> check(std::span<const std::byte> blob);

    const JobHeader& header() const noexcept { return *header_; }
    std::uint32_t layer_count() const noexcept { return header_->layer_count; }
    std::uint32_t point_count() const noexcept { return header_->point_count; }
    std::int64_t psi_sweep_pulses() const noexcept { return header_->psi_sweep_pulses; }
    Joining joining() const noexcept { return static_cast<Joining>(header_->joining); }
    std::string_view profile_toml() const noexcept { return profile_; }
    std::string_view report_json() const noexcept { return report_; }
    std::string_view source_name() const noexcept { return header_->source_name; }
    std::uint64_t source_hash() const noexcept { return header_->source_hash; }  ///< 0: not known
    std::span<const std::int64_t> layer_heights_pulses() const noexcept { return heights_; }
    std::span<const std::int32_t> r_left_pulses(std::uint32_t layer) const noexcept {
        return r_left_.subspan(std::size_t{layer} * point_count(), point_count());
    }
    std::span<const std::int32_t> r_right_pulses(std::uint32_t layer) const noexcept {
        return r_right_.subspan(std::size_t{layer} * point_count(), point_count());
    }
    std::int64_t psi_pulses(std::uint32_t layer, std::uint32_t point) const noexcept {
        return table_angle_pulses(joining(), psi_sweep_pulses(), point_count(), layer, point);
    }
    /// Y of a point. `layer_heights_pulses` says where layers end.
    std::int64_t y_pulses(std::uint32_t layer, std::uint32_t point) const noexcept {
        if (layer <= finishing_layer_) return heights_[layer];
        return table_height_pulses(joining(), heights_, point_count(), layer, point);
    }
    /// Whether this point of a layer is the one in which the layer before ends, so that the heads are there
    /// already.
    bool is_joint(std::uint32_t layer, std::uint32_t point) const noexcept {
        return joining() == Joining::spiral && layer > finishing_layer_ && point == 0;
    }

    /// At least one; together they cover all layers; only the last is a finishing pass. Valid as long as this
    /// view.
    std::span<const JobPass> passes() const noexcept {
        return passes_.empty() ? std::span(&whole_, 1) : passes_;
    }
    /// Index of the pass that a layer belongs to. Requires a layer of the job. RT: yes.
    std::uint32_t pass_of(std::uint32_t layer) const noexcept;
    /// First layer of the finishing pass; 0 where that is the only pass.
    std::uint32_t finishing_layer() const noexcept { return finishing_layer_; }
    bool begins_pass(std::uint32_t layer) const noexcept {
        return passes()[pass_of(layer)].first_layer == layer;
    }
    /// One past the last layer of the pass that a layer belongs to.
    std::uint32_t pass_end(std::uint32_t layer) const noexcept {
        const JobPass& pass = passes()[pass_of(layer)];
        return pass.first_layer + pass.layer_count;
    }
    std::int32_t max_radius_pulses(Axis head) const noexcept;
    /// The greatest radius in the finishing pass, that is on the finished piece.
    std::int32_t max_finishing_radius_pulses(Axis head) const noexcept;

private:
    const JobHeader* header_ = nullptr;
    std::string_view profile_;
    std::string_view report_;
    std::span<const std::int64_t> heights_;
    std::span<const std::int32_t> r_left_;
    std::span<const std::int32_t> r_right_;
    std::span<const JobPass> passes_;  ///< empty: whole_ is the only pass
    JobPass whole_{};
    std::uint32_t finishing_layer_ = 0;
};

/// "roughing pass 2", "finishing pass".
std::string pass_name(const JobPass& pass);

/// Whether a machine with this profile can carve the job: travel, core radius, head clearance, at least one
/// layer and two points, heights that rise, psi_sweep; that the rows of a spiral meet. The refusal names the
/// first offending layer and point.
Result<void> check_job(const JobView& job, const Profile& profile);

/// The profile inside a job, parsed.
Result<Profile> job_profile(const JobView& job);

}  // namespace psicarve
