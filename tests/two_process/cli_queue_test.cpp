// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include "tests/places.hpp"
#include "tests/two_process/cli_machine_rig.hpp"

namespace psicarve::test {
namespace {

class Queue : public Machine {
protected:
    std::string model(const std::string& name, const std::string& points) const {
        const std::string path = file(name);
        EXPECT_EQ(psicarve({"slice", box_stl("box.stl"), "-o", path, "--layers", "2", "--points", points})
                      .exit_code,
                  0);
        return path;
    }
    std::uint64_t generation() const { return published_generation(Segment::attach(segment_).value()); }
};

TEST_F(Queue, CarvesOneAfterTheOtherWhenNobodyHasToBeAsked) {
    start_core();
    const Outcome outcome =
        run({"carve", model("a.job", "9"), model("b.job", "11"), "--unattended", "--json"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
    std::istringstream lines{outcome.out};
    std::vector<int> points;
    for (std::string line; std::getline(lines, line);) {
        const auto report = nlohmann::json::parse(line);
        EXPECT_EQ(report["verified"], true) << line;
        points.push_back(report["points"].get<int>());
    }
    EXPECT_EQ(points, (std::vector<int>{9, 11}));
    EXPECT_EQ(generation(), 2U);
}

TEST_F(Queue, IsRefusedWhereNobodyCanBeAsked) {
    start_core();
    const Outcome outcome = run({"carve", model("a.job", "9"), model("b.job", "11")});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.error_lines(), 1U) << outcome.error;
    EXPECT_NE(outcome.error.find("--unattended"), std::string::npos) << outcome.error;
    EXPECT_EQ(generation(), 0U);
    EXPECT_EQ(run({"carve", file("a.job"), "--unattended"}).exit_code, 2);
    EXPECT_EQ(
        run({"carve", file("a.job"), file("b.job"), "--unattended", "--trace", file("t.vcd")}).exit_code, 2);
}

TEST_F(Queue, WithAWrongOneAtItsEndIsNotBegun) {
    start_core();
    write("c.stl", "nothing");
    const Outcome outcome = run({"carve", model("a.job", "9"), file("c.stl"), "--unattended"});
    EXPECT_EQ(outcome.exit_code, 3) << outcome.error;
    EXPECT_NE(outcome.error.find("c.stl"), std::string::npos) << outcome.error;
    EXPECT_EQ(generation(), 0U) << "nothing was published";
}

/// A terminal whose operator types this.
class QueueAtATerminal : public Queue {
protected:
    int carve_two(const std::string& answer) {
        const std::string a = model("a.job", "9");
        const std::string b = model("b.job", "11");
        const int terminal = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
        EXPECT_EQ(grantpt(terminal) | unlockpt(terminal), 0);
        const std::string line = in_build("bin/psicarve") + " carve " + a + " " + b + " --segment " +
                                 segment_ + " <" + ptsname(terminal) + " >" + file("out") + " 2>" +
                                 file("err");
        EXPECT_EQ(::write(terminal, answer.data(), answer.size()), static_cast<ssize_t>(answer.size()));
        const int status = std::system(line.c_str());
        close(terminal);
        return WEXITSTATUS(status);
    }
};

TEST_F(QueueAtATerminal, GoesOnWhenTheNextBlankIsIn) {
    start_core();
    EXPECT_EQ(carve_two("yes\n"), 0) << text_of(file("err"));
    EXPECT_EQ(generation(), 2U);
    EXPECT_NE(text_of(file("err")).find("1 of 2 carved"), std::string::npos) << text_of(file("err"));
}

TEST_F(QueueAtATerminal, EndsAtAnyOtherAnswer) {
    start_core();
    EXPECT_EQ(carve_two("\n"), 4) << text_of(file("err"));
    EXPECT_EQ(generation(), 1U) << "the second is not even published";
    EXPECT_NE(text_of(file("err")).find("not carved, as was answered: " + file("b.job")), std::string::npos)
        << text_of(file("err"));
}

}  // namespace
}  // namespace psicarve::test
