// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/machine/snapshot_taker.hpp"

#include "shared/segment/segment_program.hpp"
#include "shared/segment/shared_record.hpp"

namespace psicarve::machine {

Result<Snapshot> take_snapshot(MachineLink& link, std::chrono::milliseconds limit) {
    Snapshot snapshot;
    auto job = copy_current_job(link.segment(), limit);
    if (!job) return job.error();
    snapshot.generation = job->generation;
    snapshot.job_blob = std::move(job->blob);
    snapshot.status = link.last_status();
    snapshot.checkpoint = link.checkpoint();
    snapshot.capacity_layers = link.segment().capacity_layers();
    snapshot.capacity_points = link.segment().capacity_points();
    RingReader reader{link.segment().header().recorder};
    // A core that goes on recording must not keep us here forever: read no more than the ring holds.
    for (std::size_t i = 0; i < kFlightRecords; ++i) {
        const auto record = reader.next();
        if (!record) break;
        snapshot.records.push_back(*record);
    }
    snapshot.source = recorded_source(link.segment());
    if (snapshot.job_blob.empty() && !snapshot.status && snapshot.records.empty()) {
        return Error{ErrorCode::no_core,
                     "segment " + link.segment_name() +
                         ": no core has served it and no job was published; nothing to save"};
    }
    return snapshot;
}

}  // namespace psicarve::machine
