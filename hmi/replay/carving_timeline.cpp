// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/replay/carving_timeline.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "hmi/replay/trace_cursor.hpp"

namespace psicarve::replay {

using verify::JobGeometry;
using verify::kHeadCount;

/// Records the cuts as they are made: a tip's way through a cell is one cut, when it leaves the cell.
class CutWriter {
public:
    CutWriter(CarvingTimeline& out, const JobGeometry& geometry)
        : out_(out),
          geometry_(geometry),
          radius_mm_(std::size_t{geometry.row_count()} * geometry.direction_count(),
                     static_cast<float>(geometry.blank_radius_mm())) {
        out_.directions_ = geometry.direction_count();
        out_.layer_begin_.assign(geometry.row_count(), -1);
    }

    void stand(const PinMoment& moment) {
        for (std::size_t h = 0; h < kHeadCount; ++h) {
            const verify::HeadGeometry& head = geometry_.head(h);
            const double real_mm = head.real_mm(moment.position_pulses[h]);
            if (real_mm >= geometry_.blank_radius_mm()) continue;
            const std::int64_t direction =
                geometry_.direction(h, moment.position_pulses[index_of(Axis::psi)]);
            const auto layer = geometry_.row_at(
                moment.position_pulses[index_of(Axis::y)] + head.height_offset_pulses, direction);
            if (!layer) continue;
            const std::uint32_t cell = *layer * out_.directions_ + geometry_.cell_of(direction);
            if (way_[h] && way_[h]->cell != cell) leave(h, moment.time_ns);
            const auto radius = static_cast<float>(real_mm);
            if (!way_[h]) way_[h] = Way{cell, radius};
            way_[h]->least_mm = std::min(way_[h]->least_mm, radius);
        }
    }
    void leave_all(std::int64_t time_ns) {
        for (std::size_t h = 0; h < kHeadCount; ++h) leave(h, time_ns);
    }
    void cut(std::int64_t time, std::uint32_t cell, float radius_mm) {
        float& now_mm = radius_mm_[cell];
        if (radius_mm >= now_mm) return;
        if (out_.time_.size() >= CarvingTimeline::kMostCuts) {
            out_.is_whole_ = false;
            return;
        }
        out_.time_.push_back(time);
        out_.cell_.push_back(cell);
        out_.before_mm_.push_back(now_mm);
        out_.after_mm_.push_back(radius_mm);
        now_mm = radius_mm;
        std::int64_t& begin = out_.layer_begin_[cell / out_.directions_];
        if (begin < 0) begin = time;
    }

private:
    struct Way {
        std::uint32_t cell;
        float least_mm;
    };
    void leave(std::size_t h, std::int64_t time_ns) {
        if (way_[h]) cut(time_ns, way_[h]->cell, way_[h]->least_mm);
        way_[h].reset();
    }

    CarvingTimeline& out_;
    const JobGeometry& geometry_;
    std::vector<float> radius_mm_;
    std::array<std::optional<Way>, kHeadCount> way_;
};

namespace {

/// How often the caller is asked whether to go on.
constexpr int kParts = 200;

Error cancelled() {
    return Error{ErrorCode::cancelled, "the carving view was cancelled"};
}

}  // namespace

Result<std::shared_ptr<const CarvingTimeline>> CarvingTimeline::of_trace(
    const JobPointer& job, std::shared_ptr<const TraceIndex> index, const Progress& progress) {
    const auto geometry = JobGeometry::make(job->view, job->profile);
    if (!geometry) return geometry.error();
    const std::shared_ptr<CarvingTimeline> made{new CarvingTimeline};
    CutWriter writer{*made, *geometry};
    const std::int64_t end_ns = index->end_ns();
    TraceCursor cursor{std::move(index)};
    // All pulses of an instant belong together: a place counts when time goes on from it.
    const auto visit = [&](const PinMoment& before, const PinMoment& after) {
        const bool is_spinning = (before.levels & bit_of(Signal::spindle)) != 0;
        const bool is_later = after.time_ns != before.time_ns;
        if (is_later && is_spinning && after.position_pulses != before.position_pulses) writer.stand(before);
        if (is_spinning && (after.levels & bit_of(Signal::spindle)) == 0) {
            writer.stand(before);
            writer.leave_all(after.time_ns);
        }
    };
    for (int part = 1; part <= kParts; ++part) {
        const auto moment =
            cursor.go_on(end_ns / kParts * part + (part == kParts ? end_ns % kParts : 0), visit);
        if (!moment) return moment.error();
        if (progress && !progress(static_cast<double>(part) / kParts)) return cancelled();
    }
    writer.leave_all(end_ns);
    return std::shared_ptr<const CarvingTimeline>{made};
}

Result<std::shared_ptr<const CarvingTimeline>> CarvingTimeline::of_job(const JobPointer& job,
                                                                       const Progress& progress) {
    const auto geometry = JobGeometry::make(job->view, job->profile);
    if (!geometry) return geometry.error();
    const std::shared_ptr<CarvingTimeline> made{new CarvingTimeline};
    CutWriter writer{*made, *geometry};
    const std::uint32_t first = geometry->first_row_layer();
    for (std::uint32_t layer = 0; layer < geometry->row_count(); ++layer) {
        for (std::uint32_t cell = 0; cell < geometry->direction_count(); ++cell) {
            const auto wanted_mm = geometry->wanted_mm(layer, geometry->direction_of(cell));
            if (wanted_mm)
                writer.cut(std::int64_t{first} + layer + 1, layer * made->directions_ + cell,
                           static_cast<float>(*wanted_mm));
        }
        if (progress && !progress(static_cast<double>(layer + 1) / geometry->row_count())) return cancelled();
    }
    return std::shared_ptr<const CarvingTimeline>{made};
}

std::optional<std::int64_t> CarvingTimeline::begin_of_layer(std::int64_t layer) const noexcept {
    if (layer < 0 || layer >= static_cast<std::int64_t>(layer_begin_.size())) return std::nullopt;
    const std::int64_t begin = layer_begin_[static_cast<std::size_t>(layer)];
    return begin < 0 ? std::nullopt : std::optional{begin};
}

std::size_t CarvingTimeline::apply(session::CarvingRecord& record, std::size_t from, std::int64_t time,
                                   std::size_t most) const {
    const auto put = [&](std::size_t cut, float radius_mm) {
        record.put(cell_[cut] / directions_, cell_[cut] % directions_, radius_mm);
    };
    std::size_t done = 0;
    for (; done < most && from < time_.size() && time_[from] <= time; ++done, ++from)
        put(from, after_mm_[from]);
    for (; done < most && from > 0 && time_[from - 1] > time; ++done, --from)
        put(from - 1, before_mm_[from - 1]);
    return from;
}

}  // namespace psicarve::replay
