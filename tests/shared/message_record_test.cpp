// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/wording/message_record.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/shared/sample_message.hpp"

namespace psicarve {
namespace {

TEST(MessageRecord, GivesEveryMessageBackWordByWord) {
    for (const Wording& row : wordings()) {
        const Message written = test::sample_message(row);
        const auto read = message_from(row.name, arguments_text(written), text_of(written));
        ASSERT_TRUE(read) << row.name;
        EXPECT_EQ(in_words(*read), in_words(written)) << row.name;
    }
}

TEST(MessageRecord, KeepsEachBitOfALength) {
    const Message written = message_of(MessageId::inside_core_radius, argument(ArgumentKind::command, 10),
                                       argument(ArgumentKind::axis, 1), mm_argument(-0.1));
    const auto read = message_from("inside_core_radius", arguments_text(written), "");
    ASSERT_TRUE(read);
    EXPECT_EQ(read->arguments[2].number(), -0.1);
}

TEST(MessageRecord, TakesNothingThatIsNotTheMessages) {
    for (const auto& [name, arguments] :
         {std::pair{"not_homed", "1"},  // it has none
          std::pair{"no_such_message", ""}, std::pair{"inside_core_radius", "a 1"},
          std::pair{"inside_core_radius", "a 1 zz"},
          std::pair{"inside_core_radius", "a 1 3ff0000000000000 3"},
          std::pair{"inside_core_radius", "1ffffffffffffffff 1 3ff0000000000000"},
          std::pair{"inside_core_radius", "a 99 3ff0000000000000"}})
        EXPECT_FALSE(message_from(name, arguments, "")) << name << ": " << arguments;
}

}  // namespace
}  // namespace psicarve
