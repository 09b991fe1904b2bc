// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/phrase/finding_phrase.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <set>

#include "hmi/doctor/checks.hpp"
#include "shared/computer/realtime_step.hpp"
#include "shared/segment/layout.hpp"
#include "tests/hmi/doctor/made_up_computer.hpp"
#include "tests/shared/temporary_folder.hpp"

namespace psicarve::session {
namespace {

/// Those of the tick's treatment are translated where the core's own words are.
bool is_remedy_of_a_step(const std::string& text) {
    return std::any_of(kAllRealtimeSteps.begin(), kAllRealtimeSteps.end(),
                       [&text](RealtimeStep step) { return text == remedy_of(step); });
}

/// The same in all languages: /dev/parport0, io:0x378.
bool is_name_of_a_port(const std::string& name) {
    return name.starts_with("/dev/") || name.starts_with("io:");
}

void expect_known(const std::string& text) {
    if (text.empty() || is_remedy_of_a_step(text)) return;
    const Phrase shown = finding_phrase(text);
    EXPECT_STRNE(shown.english, "%1") << text;
    EXPECT_EQ(in_english(shown), text);
}

TEST(FindingPhrase, KnowsWhatTheDoctorSaysOfAComputerWithoutAnything) {
    const psicarve::test::TemporaryFolder nothing;
    const auto findings = doctor::check_all(doctor::SystemFiles{nothing.path("")});
    ASSERT_GE(findings.size(), 10U);
    for (const doctor::Finding& finding : findings) {
        expect_known(finding.name);
        expect_known(finding.meaning);
        expect_known(finding.remedy);
    }
}

TEST(FindingPhrase, KnowsWhatTheDoctorSaysOfThisComputer) {
    for (const doctor::Finding& finding : doctor::check_all(doctor::SystemFiles{})) {
        if (!is_name_of_a_port(finding.name)) expect_known(finding.name);
        expect_known(finding.meaning);
        expect_known(finding.remedy);
    }
}

class FindingPhraseOf : public doctor::test::MadeUpComputer {
protected:
    void expect_all_known() const {
        for (const doctor::Finding& finding : doctor::check_all(files())) expect_finding_known(finding);
    }
    static void expect_finding_known(const doctor::Finding& finding) {
        // Names of versions, clocks, ports and the like are the same in all languages.
        static const std::set<std::string> kNames{"6.1.0-rt", "tsc", "hpet", "cpu1: powersave"};
        if (!is_name_of_a_port(finding.name)) expect_known(finding.name);
        if (!kNames.contains(finding.seen)) expect_known(finding.seen);
        expect_known(finding.meaning);
        expect_known(finding.remedy);
    }
};

TEST_F(FindingPhraseOf, AComputerInPerfectOrder) {
    expect_all_known();
    user("0000000000804000", 1000, "");
    limits("8388608", "0");
    expect_all_known();
}

TEST_F(FindingPhraseOf, AComputerWithoutRights) {
    limits("8388608", "0");
    mode("/dev/parport0", 0600);
    mode("/dev/cpu_dma_latency", 0600);
    user("0000000000000000", 54321, "54322");
    expect_all_known();
    limits("unlimited", "50");
    remove("/dev/cpu_dma_latency");
    expect_all_known();
}

TEST_F(FindingPhraseOf, APortInOtherHandsOrNone) {
    put("/proc/sys/dev/parport/parport0/devices/active", "lp\n");
    put("/proc/modules", "lp 20480 0 - Live 0x0\n");
    expect_all_known();
    put("/proc/sys/dev/parport/parport0/devices/active", "ppdev0\n");
    expect_all_known();
    remove("/dev/parport0");
    expect_all_known();
    remove("/proc/sys/dev/parport");
    expect_all_known();
}

TEST_F(FindingPhraseOf, AComputerWithEachWayToBeLate) {
    put("/sys/kernel/realtime", "0\n");
    put("/sys/devices/system/cpu/isolated", "\n");
    put("/sys/devices/system/cpu/cpu1/cpufreq/scaling_governor", "powersave\n");
    put("/sys/devices/system/clocksource/clocksource0/current_clocksource", "hpet\n");
    put("/proc/swaps", "Filename\tType\n/dev/sda2\tpartition\n");
    put("/proc/cpuinfo", "flags\t\t: fpu hypervisor tsc\n");
    expect_all_known();
}

TEST(FindingPhrase, KnowsEachAmountOfRoom) {
    const std::uint64_t job = segment_geometry(kDefaultCapacityLayers, kDefaultCapacityPoints).slot_bytes;
    for (const std::optional<std::uint64_t> room : {std::optional{2 * job}, std::optional{2 * job - 1},
                                                    std::optional{job - 1}, std::optional<std::uint64_t>{}}) {
        const doctor::Finding finding = doctor::check_shared_memory(room);
        for (const std::string& text : {finding.name, finding.seen, finding.meaning, finding.remedy})
            expect_known(text);
    }
}

TEST_F(FindingPhraseOf, PortsThatAreDrivenByTheirAddresses) {
    remove("/dev/parport0");
    for (const doctor::Finding& finding : doctor::check_ports(files(), true)) expect_finding_known(finding);
}

TEST(FindingPhrase, TakesNumbersAndNamesAlong) {
    EXPECT_EQ(finding_phrase("priority up to 50 only, the tick has 80").arguments,
              (std::vector<std::string>{"50", "80"}));
    EXPECT_EQ(finding_phrase("priority up to 95").arguments, (std::vector<std::string>{"95"}));
    EXPECT_STREQ(finding_phrase("6.1.0-18-amd64, not PREEMPT_RT").english, "%1, not PREEMPT_RT");
    EXPECT_STREQ(finding_phrase("the largest job takes 230 MB, two may be there").english,
                 "the largest job takes %1, two may be there");
    EXPECT_STREQ(finding_phrase("held by lp").english, "held by %1");
    EXPECT_STREQ(finding_phrase("tsc").english, "%1") << "a name is no sentence";
    EXPECT_TRUE(finding_phrase("").is_empty());
}

}  // namespace
}  // namespace psicarve::session
