// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdlib>

#include "shared/snapshot_file.hpp"
#include "tests/hardware/lab.hpp"
#include "tests/two_process/port_rig.hpp"

namespace psicarve::hardware {
namespace {

using fake_port::Pulse;
using std::chrono::seconds;

constexpr seconds kBootLimit{300};
constexpr seconds kRunLimit{600};
constexpr std::size_t kRuns = 4;

class Hardware : public two_process::PortRig {
protected:
    void SetUp() override {
        const char* const skip = std::getenv("PSICARVE_SKIP_HARDWARE");
        if (skip != nullptr && std::string{skip} == "1") GTEST_SKIP() << "PSICARVE_SKIP_HARDWARE=1";
        save_job(coarse_job(2), "job.psi");
        save_job(coarse_job(60), "long.psi");
        const std::string problem =
            lab_.prepare(folder_, {file("machine.toml"), file("job.psi"), file("long.psi")});
        ASSERT_EQ(problem, "");
    }
    void save_job(const JobTable& table, const std::string& name) const {
        Snapshot snapshot;
        snapshot.job_blob = job_blob_from_table(table);
        ASSERT_TRUE(save_snapshot(snapshot, file(name)));
    }
    void expect_safe_lines() {
        constexpr std::uint32_t kLines = 0x0f;  // the driver keeps the interrupt's bit as it likes
        EXPECT_EQ(port_.state().data.load(), safe().data);
        EXPECT_EQ(port_.state().control.load() & kLines, safe().control & kLines);
    }
    Lab lab_;
};

// One boot for everything: it is what takes the time.
TEST_F(Hardware, ARealKernelsDriversBringExactlyTheJobsPulsesToThePins) {
    const std::vector<Pulse> wanted = pulses_of_the_simulated_run(coarse_job(2));
    ASSERT_GT(wanted.size(), 100U);
    lab_.boot(port_);
    ASSERT_TRUE(lab_.wait_for("LAB begin ppdev", kBootLimit)) << lab_.console();
    const std::size_t drivers_writes = port_.state().write_count.load();
    ASSERT_TRUE(lab_.wait_for("LAB killed core's guard ended 137", kRunLimit)) << lab_.console();
    expect_safe_lines();
    ASSERT_TRUE(lab_.wait_for("LAB begin estop", kRunLimit)) << lab_.console();
    // Somewhere in the long job: its pulses are many more than homing and approach take.
    port_.state().flip_to.store(kEstopStatusBit);
    port_.state().flip_at_pulse.store(port_.state().pulse_count.load() + wanted.size() * 2);
    ASSERT_TRUE(lab_.wait_for("LAB begin refusals", kRunLimit)) << lab_.console();
    const std::size_t runs_writes = port_.state().write_count.load();
    EXPECT_TRUE(lab_.wait_for("LAB over", kRunLimit)) << lab_.console();
    EXPECT_TRUE(lab_.wait_for_end(seconds{60}));
    const std::string console = lab_.console();
    EXPECT_EQ(console.find("LAB failed"), std::string::npos) << console;
    EXPECT_NE(console.find("realtime 1 device /dev/parport0"), std::string::npos) << console;
    EXPECT_NE(console.find("LAB end of run on ppdev:/dev/parport0: ready"), std::string::npos) << console;
    EXPECT_NE(console.find("LAB end of run on io:0x378: ready"), std::string::npos) << console;
    EXPECT_NE(console.find("LAB end of run on ppdev:/dev/parport0: alarm"), std::string::npos) << console;
    EXPECT_NE(console.find("emergency stop"), std::string::npos) << console;
    EXPECT_NE(console.find("LAB refusal psicarve-rtcore: --port io:0x2f8"), std::string::npos) << console;
    for (const char* second : {"LAB second ", "LAB third "}) {
        const std::size_t said = console.find(second);
        ASSERT_NE(said, std::string::npos) << console;
        EXPECT_NE(console.find("busy: psicarve-guard (pid ", said), std::string::npos) << console;
    }

    const auto all_writes = port_.writes();
    ASSERT_LE(runs_writes, all_writes.size());
    const std::vector<fake_port::Write> writes(
        all_writes.begin() + static_cast<std::ptrdiff_t>(drivers_writes),
        all_writes.begin() + static_cast<std::ptrdiff_t>(runs_writes));
    const auto runs = fake_port::runs_with_spindle(fake_port::levels_of(writes, profile_));
    ASSERT_EQ(runs.size(), 2 * kRuns) << console;
    // What the kernel's claiming does to the lines until our first write: docs/hardware.md.
    const std::vector<Pulse> claiming{{static_cast<std::uint8_t>(index_of(Axis::y)), false}};
    for (std::size_t run = 0; run < kRuns; ++run) EXPECT_EQ(runs[2 * run], claiming) << run;
    EXPECT_EQ(runs[1], wanted) << "through ppdev";
    EXPECT_EQ(runs[3], wanted) << "through raw I/O";
    EXPECT_GT(runs[5].size(), 10U) << "until the core was killed";
    EXPECT_LT(runs[7].size(), wanted.size() * 2) << "into the emergency stop";
    EXPECT_GT(runs[7].size(), 10U);
    expect_safe_lines();
}

}  // namespace
}  // namespace psicarve::hardware
