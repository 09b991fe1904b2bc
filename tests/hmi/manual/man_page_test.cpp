// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/manual/man_page.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace psicarve::manual {
namespace {

TEST(ManPage, TakesNothingThatIsSaidForARequest) {
    EXPECT_EQ(man_text(".stl or \\n - 'x'"), "\\&.stl or \\en \\- \\(aqx\\(aq");
    // Also where a line is broken before it.
    EXPECT_EQ(man_text("ends in .stl"), "ends in \\&.stl");
}

TEST(ManPage, BreaksLinesAtWords) {
    std::string text;
    for (int i = 0; i < 60; ++i) text += "word ";
    std::istringstream lines{man_paragraph(text)};
    std::string line;
    int count = 0;
    for (; std::getline(lines, line); ++count) EXPECT_LE(line.size(), 80U);
    EXPECT_EQ(count, 4);
}

TEST(ManPage, TellsAllThatTheTableTells) {
    CommandTable table;
    table.name = "slice";
    table.summary = "Model to job";
    table.arguments = {{"MODEL", "", "What is sliced", true, false}};
    table.options = {{{"-o", "--output"}, "JOB", "a.job", "What is written", true, true}};
    table.exit_codes = {{"0", "done"}};
    table.examples = {"psicarve slice a.stl"};
    const std::string sut =
        man_page({{"psicarve", "slice"}, &table}, {"psicarve(1)"}, {"1.2.3", "2030-01-02"});
    for (const char* const part :
         {".TH PSICARVE\\-SLICE 1 2030-01-02 \"psicarve 1.2.3\" Psicarve\n",
          "\npsicarve\\-slice \\- Model to job\n", "\n\\fBpsicarve slice\\fR [\\fIOPTION\\fR]... ",
          "\\fB\\-o\\fR \\fIJOB\\fR, \\fB\\-\\-output\\fR=\\fIJOB\\fR\nWhat is written.\nWithout it: "
          "\\fBa.job\\fR.\nMust be given.\nMay be given more than once.\n",
          ".SH EXIT STATUS\n.TP\n\\fB0\\fR\ndone.\n", ".SH EXAMPLES\n.nf\npsicarve slice a.stl\n.fi\n",
          ".BR psicarve (1)\n"}) {
        EXPECT_NE(sut.find(part), std::string::npos) << part << "\n" << sut;
    }
}

}  // namespace
}  // namespace psicarve::manual
