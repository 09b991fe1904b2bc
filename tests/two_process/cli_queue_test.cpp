// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <atomic>
#include <thread>

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

TEST_F(Queue, SaysOnceWhatIsToBeSaidOfAWorkpiece) {
    start_core();
    const std::string model_path = box_stl("box.stl");
    const std::vector<std::string> how{"--layers", "2", "--points", "9", "--height", "6", "--blank", "3x20"};
    std::vector<std::string> one{"publish", model_path};
    one.insert(one.end(), how.begin(), how.end());
    const auto warnings = [](const std::string& text) {
        std::size_t count = 0;
        for (std::size_t at = text.find("warning: "); at != std::string::npos;
             at = text.find("warning: ", at + 1))
            ++count;
        return count;
    };
    const Outcome published = run(one);
    ASSERT_EQ(published.exit_code, 0) << published.error;
    ASSERT_GT(warnings(published.error), 0U) << published.error;
    std::vector<std::string> two{"carve", model_path, model_path, "--unattended", "--no-deviation"};
    two.insert(two.end(), how.begin(), how.end());
    const Outcome carved = run(two);
    EXPECT_EQ(carved.exit_code, 0) << carved.error;
    EXPECT_EQ(warnings(carved.error), 2 * warnings(published.error)) << carved.error;
}

/// A terminal whose operator types what and when the test says.
class QueueAtATerminal : public Queue {
protected:
    int carve_two(const std::string& answer, const std::string& typed_ahead = {}) {
        return carve_two_of(model("a.job", "9"), model("b.job", "11"), answer, typed_ahead);
    }
    int carve_two_of(const std::string& a, const std::string& b, const std::string& answer,
                     const std::string& typed_ahead = {}) {
        const int terminal = posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
        EXPECT_EQ(grantpt(terminal) | unlockpt(terminal), 0);
        const std::string line = "exec '" + in_build("bin/psicarve") + "' carve '" + a + "' '" + b +
                                 "' --segment " + segment_ + " <" + ptsname(terminal) + " >" + file("out") +
                                 " 2>" + file("err");
        type(terminal, typed_ahead);
        int status = -1;
        std::atomic<bool> is_over{false};
        std::thread shell{[&] {
            status = std::system(line.c_str());
            is_over = true;
        }};
        EXPECT_TRUE(eventually([&] { return is_over || has_asked(); })) << "it neither asks nor ends";
        type(terminal, answer);
        shell.join();
        close(terminal);
        return WEXITSTATUS(status);
    }

private:
    bool has_asked() const { return text_of(file("err")).find("yes or no: ") != std::string::npos; }
    static void type(int terminal, const std::string& text) {
        EXPECT_EQ(::write(terminal, text.data(), text.size()), static_cast<ssize_t>(text.size()));
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

TEST_F(QueueAtATerminal, TakesNothingThatWasTypedBeforeItAsked) {
    start_core();
    EXPECT_EQ(carve_two("no\n", "yes\n"), 4) << text_of(file("err"));
    EXPECT_EQ(generation(), 1U) << "nobody has seen the question yet";
}

TEST_F(QueueAtATerminal, AsksInPrintableWords) {
    start_core();
    const std::string wild = model("a\x1b[31m.job", "9");
    const std::string plain = model("b.job", "11");
    EXPECT_EQ(carve_two_of(plain, wild, "no\n"), 4);
    const std::string said = text_of(file("err"));
    EXPECT_EQ(said.find('\x1b'), std::string::npos) << said;
    EXPECT_NE(said.find("psicarve: carve " + file("a\\u001b[31m.job") + " now? yes or no: "),
              std::string::npos)
        << said;
}

}  // namespace
}  // namespace psicarve::test
