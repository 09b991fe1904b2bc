// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/wording/wording.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>
#include <limits>
#include <random>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "shared/base/message_text.hpp"
#include "shared/machine/message_argument.hpp"
#include "tests/places.hpp"

namespace psicarve {
namespace {

using testing::HasSubstr;

std::string source_text(const std::string& path) {
    std::ifstream file{in_source(path)};
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

TEST(Wording, HasEveryIdentifierByItsNumberAndName) {
    const std::string ids = source_text("shared/message/message_id.hpp");
    const std::regex enumerator{"\n    ([a-z_]+) = ([0-9]+),"};
    std::vector<std::pair<unsigned, std::string>> wanted;
    for (std::sregex_iterator found{ids.begin(), ids.end(), enumerator}, end; found != end; ++found)
        if ((*found)[1] != "none") wanted.emplace_back(std::stoul((*found)[2]), (*found)[1]);
    std::vector<std::pair<unsigned, std::string>> had;
    for (const Wording& row : wordings()) had.emplace_back(static_cast<unsigned>(row.id), row.name);
    EXPECT_GT(had.size(), 60U);
    EXPECT_EQ(had, wanted);
    EXPECT_TRUE(std::ranges::is_sorted(had));
}

TEST(Wording, MarksEachArgumentAndNoOther) {
    for (const Wording& row : wordings()) {
        const std::string text = std::string{row.sentence} + row.remedy;
        std::set<std::string> names;
        std::set<char> marks;
        for (std::size_t i = 0; i < row.argument_count(); ++i) {
            marks.insert(static_cast<char>('1' + i));
            EXPECT_TRUE(names.insert(row.arguments[i].name).second) << row.name;
            // There is one text, and it comes last.
            if (row.arguments[i].kind == ArgumentKind::text) {
                EXPECT_EQ(i + 1, row.argument_count()) << row.name;
            }
        }
        std::set<char> used;
        for (std::size_t at = text.find('%'); at != std::string::npos; at = text.find('%', at + 1))
            used.insert(text.at(at + 1));
        EXPECT_EQ(used, marks) << row.name;
    }
}

TEST(Wording, MakesTheSentenceOfAMessage) {
    EXPECT_EQ(in_words(Message{}), "");
    EXPECT_EQ(in_words(message_of(MessageId::not_homed)), "the machine is not homed; home first");
    EXPECT_EQ(in_words(message_of(MessageId::wrong_state, argument_of(CommandKind::hold),
                                  argument_of(MachineState::ready), way_out_of(MachineState::ready))),
              "hold: not while ready; start first");
    EXPECT_EQ(in_words(message_of(MessageId::outside_travel, argument_of(CommandKind::jog),
                                  argument_of(Axis::r1), mm_argument(0.0), mm_argument(60.0))),
              "jog: r1 would leave its travel, 0.000 mm to 60.000 mm");
    EXPECT_EQ(in_words(message_of(MessageId::still_tripped,
                                  signals_argument(bit_of(Signal::r1_limit) | bit_of(Signal::estop)))),
              "still tripped: r1_limit, estop; release it or back off");
    EXPECT_EQ(in_words(message_of(MessageId::speed_limited, argument_of(Axis::y), mm_s_argument(12.5))),
              "y goes at 12.5 mm/s at most, and so it does");
    EXPECT_EQ(in_words(message_of(MessageId::alarm, argument_of(AlarmCause::port_error),
                                  alarm_remedy_argument(AlarmCause::port_error, true))),
              "alarm: port error; " + std::string{kSilentPortRemedy});
    const std::vector<MachineState> wanted{MachineState::ready, MachineState::off};
    EXPECT_EQ(in_words(message_of(MessageId::still_in_state, argument_of(MachineState::carving),
                                  states_argument(wanted))),
              "the machine is still in state 'carving', not ready or off");
}

TEST(Wording, KeepsALongTextWhole) {
    const std::string name(100, 'n');
    EXPECT_EQ(in_words(with_text(message_of(MessageId::no_core), name)),
              "no core serves segment " + name + "; start one: psicarve-rtcore");
    const std::string longest(kMessageTextBytes - 1, 'n');
    EXPECT_EQ(text_of(with_text(message_of(MessageId::no_core), longest)), longest);
}

TEST(Wording, CallsAnErrorByItsMessage) {
    const Error error = error_from(ErrorCode::machine_refused, message_of(MessageId::no_job));
    EXPECT_EQ(error.message, "no job is published; publish one first");
    EXPECT_EQ(error.said.id, MessageId::no_job);
    EXPECT_TRUE((Error{ErrorCode::bad_input, "text alone"}.said.is_none()));
}

TEST(Wording, SaysOfADamagedMessageThatItIs) {
    const Message whole = message_of(MessageId::outside_travel, argument_of(CommandKind::jog),
                                     argument_of(Axis::r1), mm_argument(0.0), mm_argument(60.0));
    ASSERT_TRUE(is_sound(whole));
    const auto expect_unknown = [](const Message& message, const char* what) {
        EXPECT_FALSE(is_sound(message)) << what;
        EXPECT_THAT(in_words(message), HasSubstr("is not known to this version, or damaged")) << what;
        EXPECT_TRUE(argument_words(message).empty()) << what;
    };
    Message sut = whole;
    sut.id = static_cast<MessageId>(65535);
    expect_unknown(sut, "identifier");
    sut = whole;
    sut.argument_count = 3;
    expect_unknown(sut, "too few");
    sut.argument_count = 65535;
    expect_unknown(sut, "too many");
    sut = whole;
    sut.arguments[2] = count_argument(1);
    expect_unknown(sut, "another kind");
    sut = whole;
    sut.arguments[2].kind = static_cast<ArgumentKind>(200);
    expect_unknown(sut, "no kind");
    sut = whole;
    sut.arguments[1].bits = 4;
    expect_unknown(sut, "no axis");
    sut = whole;
    sut.arguments[0].bits = kCommandKindCount;
    expect_unknown(sut, "no command");
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), -1e300}) {
        sut = whole;
        sut.arguments[2] = mm_argument(bad);
        expect_unknown(sut, "no number");
    }
}

TEST(Wording, LivesWithAnyBytes) {
    std::mt19937_64 random{20261127};
    const std::vector<Wording> all = wordings();
    int sound = 0;
    for (int round = 0; round < 40'000; ++round) {
        std::array<unsigned char, sizeof(Message)> bytes{};
        for (unsigned char& byte : bytes) byte = static_cast<unsigned char>(random());
        Message sut{};
        std::memcpy(&sut, bytes.data(), sizeof sut);
        // As random as these are, hardly any would come past the identifier.
        const Wording& row = all[random() % all.size()];
        if (round % 4 != 0) sut.id = row.id;
        if (round % 4 == 2) sut.argument_count = static_cast<std::uint16_t>(row.argument_count());
        if (round % 4 == 3) {
            sut.argument_count = static_cast<std::uint16_t>(row.argument_count());
            for (std::size_t i = 0; i < row.argument_count(); ++i) {
                sut.arguments[i].kind = row.arguments[i].kind;
                if (random() % 2 == 0) sut.arguments[i].bits %= 16;
            }
        }
        const std::string words = in_words(sut);
        if (sut.id != MessageId::none) {
            ASSERT_FALSE(words.empty());
        }
        ASSERT_LT(words.size(), 1000U);
        for (const char c : words) ASSERT_GE(static_cast<unsigned char>(c), 0x20U);
        sound += is_sound(sut) ? 1 : 0;
    }
    EXPECT_GT(sound, 2'000);
    EXPECT_LT(sound, 30'000);
}

}  // namespace
}  // namespace psicarve
