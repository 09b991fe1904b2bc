// SPDX-License-Identifier: GPL-3.0-or-later
// The core's tick beside cyclictest on a PREEMPT_RT kernel whose time is counted instructions: what the host
// does shows in neither. PSICARVE_LONG=1 takes the 200 000 ticks that are promised, the suite fewer.
#include <cmath>
#include <cstdlib>
#include <map>
#include <sstream>

#include "shared/record/snapshot_file.hpp"
#include "tests/hardware/lab.hpp"
#include "tests/thoroughness.hpp"
#include "tests/two_process/port_rig.hpp"

namespace psicarve::hardware {
namespace {

using std::chrono::seconds;

constexpr std::uint64_t kTicksOfTheSuite = 20'000;
constexpr std::uint64_t kTicksOfTheLongForm = 200'000;
constexpr double kShare = 0.999;
constexpr double kAllowed_us = 2.0;
constexpr int kMostBootsOfTheSuite = 3;

/// Whole microseconds late -> how often.
using Histogram = std::map<int, std::uint64_t>;

Histogram histogram_of(const std::string& console, const std::string& words) {
    Histogram histogram;
    std::istringstream lines{console};
    for (std::string line; std::getline(lines, line);) {
        const std::size_t at = line.find(words);
        if (at == std::string::npos) continue;
        std::istringstream numbers{line.substr(at + words.size())};
        int late_us = 0;
        std::uint64_t count = 0;
        if (numbers >> late_us >> count) histogram[late_us] += count;
    }
    return histogram;
}

std::uint64_t count_of(const Histogram& histogram) {
    std::uint64_t count = 0;
    for (const auto& [late_us, times] : histogram) count += times;
    return count;
}

/// Placed evenly within its microsecond.
double percentile_us(const Histogram& histogram, double share) {
    const double wanted = share * static_cast<double>(count_of(histogram));
    double before = 0.0;
    for (const auto& [late_us, times] : histogram) {
        const auto count = static_cast<double>(times);
        if (before + count >= wanted) return late_us + (wanted - before) / count;
        before += count;
    }
    return std::nan("");
}

/// What one boot of the guest found.
struct Verdict {
    double theirs_us = std::nan("");
    double ours_us = std::nan("");
    bool missed_none = false;
    std::string console;
    /// False until something was measured.
    bool holds() const { return ours_us <= theirs_us + kAllowed_us; }
};

class Lateness : public two_process::PortRig {
protected:
    void SetUp() override {
        const char* const skip = std::getenv("PSICARVE_SKIP_HARDWARE");
        if (skip != nullptr && std::string{skip} == "1") GTEST_SKIP() << "PSICARVE_SKIP_HARDWARE=1";
        profile_.tick.period_us = 50.0;
        two_process::take_sensors_away(profile_);
        // Longer than all the ticks.
        profile_.job.feed_mm_s = 5.0;
        write_profile();
        Snapshot snapshot;
        snapshot.job_blob = job_blob_from_table(coarse_job(100));
        ASSERT_TRUE(save_snapshot(snapshot, file("long.psi")));
        std::ofstream{file("ticks")} << ticks_;
        const std::string problem =
            lab_.prepare(file("."), {file("machine.toml"), file("long.psi"), file("ticks")},
                         "init_latency.sh", {"cyclictest"});
        ASSERT_EQ(problem, "");
    }
    void boot_into(Verdict& verdict) {
        lab_.boot(port_);
        ASSERT_TRUE(lab_.wait_for("LAB over", seconds{1500})) << lab_.console();
        ASSERT_TRUE(lab_.wait_for_end(seconds{300})) << lab_.console();
        verdict.console = lab_.console();
        ASSERT_EQ(verdict.console.find("LAB failed"), std::string::npos) << verdict.console;
        ASSERT_NE(verdict.console.find("realtime 1 ticks"), std::string::npos) << verdict.console;
        ASSERT_NE(verdict.console.find("state carving, missed "), std::string::npos) << verdict.console;
        verdict.missed_none = verdict.console.find("state carving, missed 0") != std::string::npos;
        const Histogram theirs = histogram_of(verdict.console, "LAB theirs ");
        const Histogram ours = histogram_of(verdict.console, "LAB ours ");
        ASSERT_GE(count_of(theirs), ticks_) << verdict.console;
        ASSERT_GE(count_of(ours), ticks_) << verdict.console;
        verdict.theirs_us = percentile_us(theirs, kShare);
        verdict.ours_us = percentile_us(ours, kShare);
        std::printf(
            "p50 %.2f / %.2f us, p99.9 %.2f / %.2f us, latest %d / %d us (ours / cyclictest), %llu ticks%s\n",
            percentile_us(ours, 0.5), percentile_us(theirs, 0.5), verdict.ours_us, verdict.theirs_us,
            ours.rbegin()->first, theirs.rbegin()->first, static_cast<unsigned long long>(count_of(ours)),
            verdict.missed_none ? "" : ", some missed");
    }
    const std::uint64_t ticks_ = test::is_long_run() ? kTicksOfTheLongForm : kTicksOfTheSuite;
    Lab lab_;
};

// The guest's time is counted instructions, but when its devices' interrupts come is the host's affair, and
// twenty samples make the last thousandth of the suite's ticks: a boot that misses the mark is followed by
// others. The long form has two hundred there, and one boot. A missed tick is one in any.
TEST_F(Lateness, OfTheTickIsThatOfCyclictestAndNoneIsMissed) {
    const int most_boots = test::is_long_run() ? 1 : kMostBootsOfTheSuite;
    Verdict verdict;
    for (int boot = 0; boot < most_boots && !verdict.holds(); ++boot) {
        ASSERT_NO_FATAL_FAILURE(boot_into(verdict));
        ASSERT_TRUE(verdict.missed_none) << verdict.console;
    }
    EXPECT_LE(verdict.ours_us, verdict.theirs_us + kAllowed_us) << verdict.console;
}

}  // namespace
}  // namespace psicarve::hardware
