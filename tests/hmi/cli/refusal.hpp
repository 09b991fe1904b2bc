// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "tests/hmi/cli/program_run.hpp"

namespace psicarve::test {

class RefusalTest : public CliTest {
protected:
    /// Exit code 3, one line that names the file, and nothing new in the folder.
    void expect_refused(const std::vector<std::string>& arguments, const std::string& name) const {
        const auto before = files_in_folder();
        expect_refusal(psicarve(arguments), name);
        EXPECT_EQ(files_in_folder(), before) << name;
    }
    static void expect_refusal(const Outcome& outcome, const std::string& name) {
        EXPECT_EQ(outcome.exit_code, 3) << name << ": " << outcome.error;
        EXPECT_EQ(outcome.out, "") << name;
        EXPECT_EQ(outcome.error_lines(), 1U) << name << ": " << outcome.error;
        EXPECT_TRUE(outcome.error.starts_with("psicarve: ")) << outcome.error;
        EXPECT_NE(outcome.error.find(name), std::string::npos) << outcome.error;
    }
};

}  // namespace psicarve::test
