// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fstream>
#include <string>
#include <vector>

#include "hmi/machine/snapshot_taker.hpp"
#include "hmi/trace/trace_reader.hpp"
#include "tests/older_trace.hpp"
#include "tests/two_process/core_rig.hpp"

namespace psicarve::replay::test {

/// A run of a real core on the virtual clock, recorded: homed, then a small job carved to its end. On the rig
/// that a test needs besides.
template <typename Rig>
class RecordedOn : public Rig {
protected:
    static constexpr std::uint32_t kLayers = 6;
    static constexpr std::uint32_t kPoints = 41;

    /// Leaves run.trace, which is of the older form and carries no job, and apart from it other.job and
    /// other.snap; and whole.trace, which carries its job.
    void record() {
        const JobTable table = two_process::lobed_job(kLayers, kPoints);
        Snapshot job_file;
        job_file.job_blob = job_blob_from_table(table);
        ASSERT_TRUE(save_snapshot(job_file, job()));
        this->start_core({"--trace", whole_trace()});
        ASSERT_EQ(this->publish(table), "");
        this->home();
        ASSERT_EQ(this->refusal_of(CommandKind::override, 80.0), "");
        this->start_carving();
        ASSERT_TRUE(this->eventually([&] { return this->status().job_end_tick != 0; }));
        end_ = this->status();
        auto link = machine::MachineLink::attach(this->segment_name_);
        ASSERT_TRUE(link);
        const auto taken = machine::take_snapshot(*link, two_process::kLimit);
        ASSERT_TRUE(taken);
        ASSERT_TRUE(save_snapshot(*taken, snapshot()));
        ASSERT_EQ(this->refusal_of(CommandKind::shutdown), "");
        ASSERT_EQ(this->core_->wait_for_exit(), 0);
        std::ofstream(trace(), std::ios::binary)
            << psicarve::test::older_trace(two_process::text_of(whole_trace()));
    }
    std::string whole_trace() const { return this->file("whole.trace"); }
    std::string trace() const { return this->file("run.trace"); }
    std::string job() const { return this->file("other.job"); }
    std::string snapshot() const { return this->file("other.snap"); }

    CoreStatus end_;  ///< of the run
};
using RecordedRun = RecordedOn<two_process::CoreRig>;

/// All of a trace, read from its begin, and what follows from it by a plain count.
struct PlainTrace {
    explicit PlainTrace(const std::string& path);
    struct At {
        std::int64_t time_ns;
        SignalWord levels;
        std::array<std::int64_t, kAxisCount> position_pulses;
        std::array<std::uint64_t, kAxisCount> pulses;
    };
    /// After everything up to and with this time.
    const At& at(std::int64_t time_ns) const;

    std::vector<At> states;  ///< the first before all events
};

}  // namespace psicarve::replay::test
