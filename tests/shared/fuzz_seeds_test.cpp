// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "shared/file/atomic_file.hpp"
#include "shared/record/snapshot_file.hpp"
#include "tests/places.hpp"
#include "tests/shared/passes_fixture.hpp"

// The inputs that the fuzzer of snapshots begins with lose their worth when the layout changes: then it sees
// nothing but refusals by version. snapshot.psi, program.psi and passes.psi are made anew by
//   PSICARVE_WRITE_SEEDS=1 build/dev/tests/shared_file_test --gtest_filter='FuzzSeeds.*'
namespace psicarve {
namespace {

std::string seed(const std::string& name) {
    return in_source("tests/fuzz/corpus/snapshot/") + name;
}

/// The job of job.psi with a status and a few records, and with what a program is made of.
std::vector<std::byte> snapshot_of_today(bool has_source) {
    auto snapshot = load_snapshot(seed("job.psi"));
    EXPECT_TRUE(snapshot.has_value()) << snapshot.error().message;
    if (!snapshot) return {};
    if (has_source) {
        const std::string_view profile = "name = \"lathe\"";
        auto source = std::make_shared<RecordedSource>();
        source->taken = 12;
        source->source.program = 7;
        source->source.profile_bytes = static_cast<std::uint32_t>(profile.size());
        profile.copy(source->source.profile, profile.size());
        snapshot->source = std::move(source);
    }
    snapshot->status.emplace();
    snapshot->status->tick = 4711;
    snapshot->status->state = MachineState::ready;
    for (const RecordKind kind : {RecordKind::command, RecordKind::state_change, RecordKind::input_edge}) {
        FlightRecord record{};
        record.tick = 4000 + snapshot->records.size();
        record.kind = kind;
        snapshot->records.push_back(record);
    }
    return snapshot_bytes(*snapshot);
}

TEST(FuzzSeeds, HoldASnapshotOfThisLayout) {
    for (const std::string name : {"snapshot.psi", "program.psi"}) {
        const auto wanted = snapshot_of_today(name == "program.psi");
        if (std::getenv("PSICARVE_WRITE_SEEDS") != nullptr) {
            ASSERT_TRUE(write_file_atomically(seed(name), wanted).has_value());
        }
        const auto kept = read_whole_file(seed(name));
        ASSERT_TRUE(kept.has_value()) << kept.error().message;
        EXPECT_TRUE(*kept == wanted) << name << ": the layout has changed: make it anew, see above";
    }
}

/// Three layers of two points, the first of them a roughing pass.
std::vector<std::byte> job_of_passes() {
    JobTable table;
    table.layer_count = 3;
    table.point_count = 2;
    table.psi_sweep_pulses = 3200;
    table.feed_mm_s = 20.0;
    table.layer_height_pulses = {110, 100, 120};
    table.r_left_pulses.assign(6, 4000);
    table.r_right_pulses.assign(6, 4000);
    set_passes(table, {1, 2});
    Snapshot snapshot;
    snapshot.job_blob = job_blob_from_table(table);
    return snapshot_bytes(snapshot);
}

TEST(FuzzSeeds, HoldAJobOfSeveralPasses) {
    const auto wanted = job_of_passes();
    if (std::getenv("PSICARVE_WRITE_SEEDS") != nullptr) {
        ASSERT_TRUE(write_file_atomically(seed("passes.psi"), wanted).has_value());
    }
    const auto kept = read_whole_file(seed("passes.psi"));
    ASSERT_TRUE(kept.has_value()) << kept.error().message;
    EXPECT_TRUE(*kept == wanted) << "the layout has changed: make it anew, see above";
}

TEST(FuzzSeeds, HoldAnOldSnapshotThatIsRefusedByItsVersion) {
    const auto old = load_snapshot(seed("snapshot_layout_1.psi"));
    ASSERT_FALSE(old.has_value());
    EXPECT_THAT(old.error().message, testing::HasSubstr("layout version 1, this program knows"));
}

}  // namespace
}  // namespace psicarve
