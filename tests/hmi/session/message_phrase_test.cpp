// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/phrase/message_phrase.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "hmi/machine/machine_link.hpp"
#include "hmi/phrase/error_phrase.hpp"
#include "shared/machine/message_argument.hpp"
#include "tests/places.hpp"
#include "tests/shared/sample_message.hpp"

namespace psicarve::session {
namespace {

Error refusal_of(const psicarve::Message& message) {
    return error_from(ErrorCode::machine_refused, message);
}

TEST(MessagePhrase, NamesTheCommandOnceAndInTheWindowsWords) {
    const Phrase shown = refusal_phrase(
        phrase("Hold"),
        refusal_of(message_of(MessageId::wrong_state, argument_of(CommandKind::hold),
                              argument_of(MachineState::ready), way_out_of(MachineState::ready))));
    EXPECT_EQ(in_english(shown), "Hold: not while ready; start first");
    const Phrase& why = shown.inner.at(1);
    EXPECT_STREQ(why.english, "not while %1; %2");
    EXPECT_EQ(why.arguments, (std::vector<std::string>{"ready"}));
    EXPECT_STREQ(why.inner.at(0).english, "start first");
    const psicarve::Message outside = message_of(MessageId::outside_travel, argument_of(CommandKind::jog),
                                                 argument_of(Axis::r1), mm_argument(0.0), mm_argument(60.0));
    EXPECT_EQ(in_english(refusal_phrase(phrase("By hand"), refusal_of(outside))),
              "By hand: R1 would leave its travel, 0.000 mm to 60.000 mm");
    CoreStatus in_alarm{};
    in_alarm.alarm_cause = AlarmCause::limit;
    in_alarm.alarm_axis = static_cast<std::uint8_t>(index_of(Axis::r2));
    EXPECT_EQ(in_english(core_phrase(machine::alarm_error(in_alarm))), "alarm: limit, axis R2");
    in_alarm.alarm_cause = AlarmCause::emergency_stop;
    in_alarm.alarm_axis = kNoAxis;
    EXPECT_EQ(in_english(core_phrase(machine::alarm_error(in_alarm))), "alarm: emergency stop");
}

TEST(MessagePhrase, CountsLayersAndPointsFromOneAsTheWindowDoes) {
    EXPECT_EQ(
        in_english(message_phrase(message_of(MessageId::no_layer_finished_but_earlier, layer_argument(40)))),
        "no layer was finished; start from the beginning, or with layer 41 for the piece of before");
    EXPECT_EQ(in_english(message_phrase(message_of(MessageId::spiral_not_joined, layer_argument(0),
                                                   point_argument(0), argument_of(Axis::r2),
                                                   pulses_argument(2), pulses_argument(1)))),
              "layer 1, point 1: the radius of R2 is not that in which the layer below ends; slice the model "
              "again");
}

TEST(MessagePhrase, LeavesAnErrorWithoutAMessageAsItIs) {
    const Error text{ErrorCode::machine_refused, "something else: 12 %"};
    EXPECT_EQ(in_english(core_phrase(text)), "something else: 12 %");
    EXPECT_EQ(
        in_english(refusal_phrase(phrase("Start"), {ErrorCode::machine_refused, "start: something else"})),
        "Start: something else");
}

TEST(MessagePhrase, HasWordsForEveryIdentifier) {
    for (const Wording& row : wordings()) {
        const psicarve::Message sample = psicarve::test::sample_message(row);
        ASSERT_TRUE(is_sound(sample)) << row.name;
        const Phrase shown = message_phrase(sample);
        EXPECT_STRNE(shown.english, "%1") << row.name;
        std::size_t marks = 0;
        for (const char* c = shown.english; *c != '\0'; ++c) marks += *c == '%' ? 1 : 0;
        EXPECT_EQ(marks, shown.arguments.size() + shown.inner.size()) << row.name;
        EXPECT_EQ(in_english(shown).find('%'), std::string::npos) << row.name;
        if (row.id != MessageId::job_unsound) {
            EXPECT_EQ(error_phrase(refusal_of(sample)), shown) << row.name;
        }
    }
}

std::string catalogue(const std::string& language) {
    std::ifstream file{in_source("hmi/translations/psicarve_" + language + ".ts")};
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

/// Empty: there is none.
std::string translated(const std::string& words, const std::string& english) {
    const std::string source = "<source>" + english + "</source>";
    const std::string begin = "<translation>";
    const std::size_t at = words.find(source);
    if (at == std::string::npos) return {};
    const std::size_t from = words.find_first_not_of(" \n", at + source.size());
    if (words.compare(from, begin.size(), begin) != 0) return {};
    return words.substr(from + begin.size(), words.find('<', from + 1) - from - begin.size());
}

std::multiset<char> marks_of(const std::string& words) {
    std::multiset<char> marks;
    for (std::size_t at = words.find('%'); at != std::string::npos; at = words.find('%', at + 1))
        if (words.at(at + 1) >= '1' && words.at(at + 1) <= '9') marks.insert(words.at(at + 1));
    return marks;
}

TEST(MessagePhrase, HasTheSameArgumentsInEveryLanguage) {
    for (const std::string language : {"zh_CN", "ru"}) {
        const std::string words = catalogue(language);
        for (const Wording& row : wordings()) {
            const Phrase shown = message_phrase(psicarve::test::sample_message(row));
            const std::string own = translated(words, shown.english);
            EXPECT_FALSE(own.empty()) << language << ": " << row.name;
            EXPECT_EQ(marks_of(own), marks_of(shown.english)) << language << ": " << own;
        }
    }
}

TEST(MessagePhrase, SaysOfADamagedMessageThatItIs) {
    psicarve::Message sut = message_of(MessageId::at_the_end, argument_of(CommandKind::jog));
    EXPECT_NE(in_english(message_phrase(sut)).find("is not known to this version"), std::string::npos);
    sut.id = static_cast<MessageId>(40'000);
    EXPECT_NE(in_english(message_phrase(sut)).find("message 40000"), std::string::npos);
    EXPECT_EQ(in_english(core_phrase({ErrorCode::machine_refused, "in words", sut})), "in words");
}

}  // namespace
}  // namespace psicarve::session
