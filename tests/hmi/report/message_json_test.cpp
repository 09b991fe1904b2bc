// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/report/message_json.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "hmi/report/exit_code.hpp"
#include "shared/machine/message_argument.hpp"
#include "tests/shared/sample_message.hpp"

namespace psicarve::report {
namespace {

using MessageJson = nlohmann::ordered_json;

TEST(MessageJson, HasNumbersAsSuchAndWordsOfTheMachineByName) {
    const Message sut = message_of(MessageId::outside_travel, argument_of(CommandKind::move),
                                   argument_of(Axis::r1), mm_argument(-0.25), mm_argument(60.0));
    EXPECT_EQ(
        message_json(sut).dump(),
        R"({"id":"outside_travel","arguments":{"command":"move","axis":"r1","from_mm":-0.25,"to_mm":60.0}})");
    EXPECT_EQ(message_json(message_of(MessageId::not_homed)).dump(), R"({"id":"not_homed","arguments":{}})");
    const Message joint = message_of(MessageId::spiral_not_joined, layer_argument(3), point_argument(0),
                                     argument_of(Axis::r2), pulses_argument(-7), pulses_argument(8));
    EXPECT_EQ(message_json(joint)["arguments"]["radius_pulses"], -7);
    EXPECT_EQ(message_json(joint)["arguments"]["layer"], 3);
}

TEST(MessageJson, HasEveryArgumentOfEveryMessage) {
    for (const Wording& row : wordings()) {
        const MessageJson object = message_json(test::sample_message(row));
        EXPECT_EQ(object["id"], row.name);
        EXPECT_EQ(object["arguments"].size(), row.argument_count()) << row.name;
    }
}

TEST(MessageJson, OfADamagedMessageOrNoneIsNull) {
    EXPECT_TRUE(message_json({}).is_null());
    EXPECT_TRUE(message_json(message_of(MessageId::at_the_end)).is_null());
}

TEST(ErrorJson, HasTheMessagesKeysBesideItsOwn) {
    const Error error = error_from(ErrorCode::machine_refused, message_of(MessageId::not_homed));
    EXPECT_EQ(error_json(error), R"({"code":"machine_refused","exit_code":4,)"
                                 R"("message":"the machine is not homed; home first",)"
                                 R"("id":"not_homed","arguments":{}})");
    EXPECT_EQ(error_json(bad_input("x")), R"({"code":"bad_input","exit_code":3,"message":"x"})");
}

}  // namespace
}  // namespace psicarve::report
