// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/manual/command_table.hpp"

#include <gmock/gmock.h>

namespace psicarve::manual {
namespace {

using ::testing::ElementsAre;

TEST(CommandTable, TakesParagraphsExamplesAndExitCodesFromAHelpPagesEnd) {
    CommandTable sut;
    take_footer(
        "One line\nand its end.\n\nAnother.\n\nExample:\n  psicarve a b\n  psicarve c\n\n"
        "Exit codes: 0 done; 2 wrong\nusage; 4 alarm (replay).",
        sut);
    EXPECT_THAT(sut.details, ElementsAre("One line and its end.", "Another."));
    EXPECT_THAT(sut.examples, ElementsAre("psicarve a b", "psicarve c"));
    ASSERT_EQ(sut.exit_codes.size(), 3U);
    EXPECT_EQ(sut.exit_codes[1].code, "2");
    EXPECT_EQ(sut.exit_codes[1].meaning, "wrong usage");
    EXPECT_EQ(sut.exit_codes[2].meaning, "alarm (replay)");
}

TEST(CommandTable, PlacesCommandsBehindTheWordsBeforeThem) {
    CommandTable save;
    save.name = "save";
    CommandTable snapshot;
    snapshot.name = "snapshot";
    snapshot.commands.push_back(save);
    CommandTable program;
    program.name = "psicarve";
    program.commands.push_back(snapshot);
    const auto all = all_commands(program);
    ASSERT_EQ(all.size(), 3U);
    EXPECT_THAT(all[2].words, ElementsAre("psicarve", "snapshot", "save"));
    EXPECT_EQ(all[2].table->name, "save");
    EXPECT_EQ(joined(all[2].words, " ", 1), "snapshot save");
}

}  // namespace
}  // namespace psicarve::manual
