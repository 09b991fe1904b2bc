// SPDX-License-Identifier: GPL-3.0-or-later
// The examples of docs/commands.md and those of docs/tutorial.md, in their order, on one machine.
#include <cstddef>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "tests/places.hpp"
#include "tests/thoroughness.hpp"
#include "tests/two_process/cli_machine_rig.hpp"

namespace psicarve::test {
namespace {

/// The lines between the fences of a page.
std::vector<std::string> documented_examples(const std::string& page) {
    std::ifstream in(in_source(page));
    std::vector<std::string> examples;
    bool is_inside = false;
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with("```"))
            is_inside = !is_inside;
        else if (is_inside)
            examples.push_back(line);
    }
    return examples;
}

/// How an example is run, where that is not just as it stands.
struct Terms {
    std::string begins{};             ///< of which examples: those that begin so; the first that fits counts
    std::vector<std::string> with{};  ///< options and values, in place of its own: so that it takes seconds
    std::function<void()> before{};   ///< what the page's reader has done before
    int exit_code = 0;                ///< what it ends with here,
    std::string says{};               ///< and with which words
    bool goes_on = false;             ///< until Ctrl-C
    bool may_find_problems = false;   ///< of this computer: exit code 4 then
    bool is_used = false;
};

class DocumentedExamples : public Machine {
protected:
    DocumentedExamples() : folder_before_(std::filesystem::current_path()) {
        std::filesystem::current_path(folder_);
        for (const char* name : {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME"}) {
            const char* const value = std::getenv(name);
            variables_before_.emplace_back(
                name, value != nullptr ? std::optional<std::string>{value} : std::nullopt);
            ::setenv(name, folder_.c_str(), 1);
        }
        for (const char* folder :
             {".local/share/bash-completion/completions", ".config/fish/completions", ".zfunc"})
            std::filesystem::create_directories(folder_ / folder);
        for (const char* name : {"figurine.stl", "letter.stl"})
            std::filesystem::copy_file(example(name), folder_ / name);
        write("pocket.ngc", "G0 X20 Y30 Z40\nG1 X18 F200\nG2 Y40 J5\nM2\n");
    }
    ~DocumentedExamples() override {
        std::filesystem::current_path(folder_before_);
        for (const auto& [name, value] : variables_before_) {
            if (value)
                ::setenv(name.c_str(), value->c_str(), 1);
            else
                ::unsetenv(name.c_str());
        }
    }

    void run_example(const std::string& line);

    std::vector<Terms> terms_;

private:
    Terms terms_of(const std::string& line) {
        for (Terms& terms : terms_) {
            if (!line.starts_with(terms.begins)) continue;
            terms.is_used = true;
            return terms;
        }
        return {};
    }
    /// Until it has something to say, then Ctrl-C.
    Outcome run_and_interrupt(const std::vector<std::string>& arguments) const {
        RunningProgram program("psicarve", arguments);
        EXPECT_TRUE(eventually([&] {
            return program.has_ended() || !program.out_so_far().empty() || state() == MachineState::moving;
        }));
        program.send(SIGINT);
        return program.outcome();
    }

    std::filesystem::path folder_before_;
    std::vector<std::pair<std::string, std::optional<std::string>>> variables_before_;
};

void DocumentedExamples::run_example(const std::string& line) {
    SCOPED_TRACE(line);
    const Terms terms = terms_of(line);
    if (terms.before) terms.before();
    std::vector<std::string> arguments = words_of(line);
    ASSERT_EQ(arguments.at(0), "psicarve");
    arguments.erase(arguments.begin());
    std::optional<std::string> target;
    const auto arrow = std::ranges::find(arguments, ">");
    if (arrow != arguments.end()) {
        target = arrow[1].starts_with("~/") ? folder_ / arrow[1].substr(2) : folder_ / arrow[1];
        arguments.erase(arrow, arguments.end());
    }
    for (std::size_t i = 0; i + 1 < terms.with.size(); i += 2) {
        const auto given = std::ranges::find(arguments, terms.with[i]);
        arguments.erase(given, given == arguments.end() ? given : given + 2);
        arguments.insert(arguments.end(), {terms.with[i], terms.with[i + 1]});
    }
    const bool has_segment = arguments[0] != "completion";
    if (has_segment) arguments.insert(arguments.begin(), {"--segment", segment_});
    const Outcome outcome = terms.goes_on ? run_and_interrupt(arguments) : psicarve(arguments);
    if (terms.may_find_problems && outcome.exit_code == 4) {
        EXPECT_NE(outcome.out.find("real-time scheduling"), std::string::npos) << outcome.out;
        return;
    }
    EXPECT_EQ(outcome.exit_code, terms.exit_code) << outcome.error;
    EXPECT_NE(outcome.error.find(terms.says), std::string::npos) << outcome.error;
    if (!target) return;
    EXPECT_FALSE(outcome.out.empty());
    std::ofstream(*target, std::ios::binary) << outcome.out;
}

TEST_F(DocumentedExamples, RunInTheirOrder) {
    const auto done = [this](std::vector<std::string> arguments) {
        const Outcome outcome = run(std::move(arguments));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    };
    const auto stopped = [&] { done({"stop"}); };
    const auto homed = [&] { done({"home"}); };
    const std::vector<std::string> small{"--layers", "20", "--points", "60"};
    const auto stopped_behind_a_layer = [&] {
        EXPECT_TRUE(eventually([&] {
            return run({"status", "--json"}).json()["checkpoint"]["next_layer"] > 0;
        }));
        stopped();
    };
    const auto with_its_profile = [&] {
        core_->send(SIGTERM);
        (void)core_->wait();
        start_core({"--profile", file("machine.toml")});
        homed();
        done({"move", "r1=3.1"});
    };
    const auto two_snapshots = [&] {
        done({"snapshot", "save", "before.snap"});
        done({"reset-height"});
        done({"snapshot", "save", "after.snap"});
    };
    const auto recorded_program = [&] {
        homed();
        done({"gcode", "run", "pocket.ngc"});
        done({"snapshot", "save", "run.snap"});
    };
    const auto short_job = [&] {
        done({"slice", "figurine.stl", "-o", "figurine.job", "--layers", "20", "--points", "60"});
    };
    terms_ = {
        {.begins = "psicarve carve", .with = small},
        {.begins = "psicarve estimate", .with = small},
        {.begins = "psicarve inspect", .with = small},
        // Long enough to be disturbed by what follows.
        {.begins = "psicarve slice", .with = {"--layers", "1000", "--points", "100"}},
        {.begins = "psicarve status --watch", .goes_on = true},
        {.begins = "psicarve forget",
         .with = {"--state", file("state")},
         .exit_code = 3,
         .says = "unfinished"},
        {.begins = "psicarve log --follow", .with = {"--state", file("state")}, .goes_on = true},
        {.begins = "psicarve log", .with = {"--state", file("state")}},
        {.begins = "psicarve start --resume", .before = stopped_behind_a_layer},
        {.begins = "psicarve start --from-layer", .before = stopped},
        {.begins = "psicarve start --dry-run", .before = stopped},
        {.begins = "psicarve start-interpolation",
         .before =
             [&] {
                 stopped();
                 done({"start"});
             }},
        {.begins = "psicarve single on", .exit_code = 4, .says = "no program runs"},
        {.begins = "psicarve optional-stop on", .exit_code = 4, .says = "no program runs"},
        {.begins = "psicarve back-off", .exit_code = 4, .says = "there is no alarm"},
        {.begins = "psicarve jog r1", .before = homed},
        {.begins = "psicarve jog psi +", .goes_on = true},
        {.begins = "psicarve pins --watch", .goes_on = true},
        {.begins = "psicarve pins spindle", .goes_on = true},
        {.begins = "psicarve snapshot diff", .before = two_snapshots, .exit_code = 6},
        {.begins = "psicarve replay run.snap", .before = recorded_program},
        {.begins = "psicarve replay", .before = short_job},
        {.begins = "psicarve gcode run", .before = homed},
        {.begins = "psicarve gcode offsets set", .exit_code = 3, .says = "nothing is kept"},
        {.begins = "psicarve gcode offsets clear", .exit_code = 3, .says = "nothing is kept"},
        {.begins = "psicarve calibrate --profile machine.toml --pin", .before = with_its_profile},
        {
            .begins = "psicarve calibrate --profile machine.toml --",
        },
        {.begins = "psicarve calibrate", .exit_code = 2, .says = "nobody is there to ask"},
        {.begins = "psicarve doctor --no-latency", .may_find_problems = true},
        {.begins = "psicarve doctor", .with = {"--seconds", "1"}, .may_find_problems = true},
        {.begins = "psicarve latency --period", .with = {"--seconds", "1", "--cpu", "0"}},
        {.begins = "psicarve latency", .with = {"--seconds", "1"}},
    };
    start_core({"--state", file("state")});
    const auto examples = documented_examples("docs/commands.md");
    ASSERT_GT(examples.size(), 50U);
    for (const std::string& line : examples) run_example(line);
    for (const Terms& terms : terms_) EXPECT_TRUE(terms.is_used) << terms.begins << " is no example any more";
}

TEST_F(DocumentedExamples, OfTheTutorialRunInTheirOrder) {
    if (!is_thorough()) GTEST_SKIP() << "under sanitizers only with --long; dev runs it";
    // What the tutorial's reader downloads; scripts/deps.sh test installs it.
    std::filesystem::copy_file("/usr/share/glmark2/models/bunny.obj", folder_ / "bunny.obj");
    const std::vector<std::string> small{"--layers", "12", "--points", "60"};
    const auto done = [this](std::vector<std::string> arguments) {
        const Outcome outcome = run(std::move(arguments));
        EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    };
    const auto with_a_core_and_a_long_job = [&] {
        done({"slice", "bunny.obj", "--profile", "my.toml", "--up", "y", "--fit", "--layers", "400",
              "--points", "100", "-o", "bunny.job"});
        start_core({"--state", file("state"), "--profile", file("my.toml")});
    };
    const auto at_rest = [&] { EXPECT_TRUE(eventually([&] { return state() == MachineState::ready; })); };
    const auto behind_a_layer = [&] {
        EXPECT_TRUE(eventually([&] {
            return run({"status", "--json"}).json()["checkpoint"]["next_layer"] > 0;
        }));
    };
    terms_ = {
        {.begins = "psicarve inspect bunny.obj --profile", .with = small},
        {.begins = "psicarve inspect bunny.obj", .exit_code = 3, .says = "wholly within the core radius"},
        {.begins = "psicarve estimate", .with = small},
        {.begins = "psicarve slice", .with = small},
        {.begins = "psicarve doctor", .may_find_problems = true},
        {.begins = "psicarve publish", .before = with_a_core_and_a_long_job},
        {.begins = "psicarve start --carve", .before = at_rest},
        {.begins = "psicarve status --watch", .goes_on = true},
        {.begins = "psicarve stop", .before = behind_a_layer},
        {.begins = "psicarve start --resume", .before = at_rest},
    };
    const auto examples = documented_examples("docs/tutorial.md");
    ASSERT_GT(examples.size(), 15U);
    for (const std::string& line : examples) run_example(line);
    for (const Terms& terms : terms_) EXPECT_TRUE(terms.is_used) << terms.begins << " is no example any more";
    for (const char* picture : {"looked.png", "carved.png", "deviation.png"})
        EXPECT_TRUE(std::filesystem::exists(folder_ / picture)) << picture;
}

}  // namespace
}  // namespace psicarve::test
