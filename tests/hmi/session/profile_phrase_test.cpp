// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/phrase/profile_phrase.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "hmi/phrase/error_phrase.hpp"
#include "hmi/profile/profile_draft.hpp"
#include "shared/profile/profile.hpp"
#include "shared/profile/profile_text.hpp"
#include "tests/hmi/profile/key_named.hpp"
#include "tests/shared/temporary_folder.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::session {
namespace {

using Values = std::vector<std::string>;

std::string line_of(std::string_view path, const std::string& value) {
    return std::string{path} + " = " + value + "\n";
}

std::string number(double value, bool is_whole) {
    std::string text = std::to_string(value);
    return is_whole ? text.substr(0, text.find('.')) : text;
}

bool is_whole(const ProfileKey& key) {
    return key.value == ProfileValue::integer;
}

bool is_number(const ProfileKey& key) {
    return key.value == ProfileValue::integer || key.value == ProfileValue::number;
}

/// Values of every kind, whatever the key takes.
Values any_values() {
    return {"3",
            "-1",
            "1.5",
            "nan",
            "inf",
            "true",
            "\"none\"",
            "\"\"",
            "\"a\\u001bb\"",
            "[1]",
            "[[]]",
            "{}",
            "[1.0, 2]",
            "1979-05-27",
            "[-1e9, 0.0]",
            "\"" + std::string(65, 'x') + "\""};
}

/// Within and just outside its bounds.
Values values_at_bounds(const ProfileKey& key) {
    if (!is_number(key)) return {};
    const ProfileBounds bounds = profile_bounds(key.path);
    Values values;
    for (const double value : {bounds.least - 1.0, bounds.least, bounds.greatest, bounds.greatest + 1.0})
        values.push_back(number(value, is_whole(key)));
    return values;
}

/// That the key takes: small, usual and large ones, every word, pins of each kind.
Values possible_values(const ProfileKey& key) {
    Values values;
    for (const std::string& word : key.words) values.push_back('"' + word + '"');
    if (key.value == ProfileValue::range)
        return {"[0.0, 60.0]", "[60.0, 0.0]", "[5.0, 6.0]", "[-60.0, -1.0]"};
    if (!is_number(key)) return values;
    const ProfileBounds bounds = profile_bounds(key.path);
    if (key.unit == "pin") return {"0", "1", "6", "-6", "10", "-13", "16"};
    const double usual = std::stod(key.built_in);
    std::set<double> tried{bounds.least, bounds.greatest};
    for (const double factor : {0.1, 0.5, 2.0, 10.0}) tried.insert(factor * usual);
    for (const double value : {-5.0, 1.0, 3.0, 50.0}) tried.insert(value);
    for (const double value : tried) {
        if (bounds.hold(value)) values.push_back(number(value, is_whole(key)));
    }
    return values;
}

/// What keys have to do with each other: "axis.r1", "port", "roughing" with "tool".
std::string field_of(const ProfileKey& key) {
    const std::string table{table_of_key(key.path)};
    if (table.starts_with("port") || table == "tick") return "port";
    return table == "roughing" ? "tool" : table;
}

/// Before what is tried: the usual machine, one that is slow, and slow ones of the other kinds, on which
/// nothing but what is tried can be wrong.
Values machines(std::string_view field) {
    if (field != "port") return {""};
    std::string slow;
    for (const char* axis : {"r1", "r2", "y"}) {
        for (const char* leaf : {"speed_mm_s", "home_speed_mm_s"})
            slow += line_of("axis." + std::string{axis} + "." + leaf, "1.0");
    }
    for (const char* leaf : {"speed_deg_s", "home_speed_deg_s"})
        slow += line_of("axis.psi." + std::string{leaf}, "25.0");
    return {"", slow, slow + "tick.schedule = \"two-timer\"\n", slow + "port.pulses = \"within-tick\"\n"};
}

class ProfilePhrases : public testing::Test {
protected:
    void look_at(const std::string& toml) {
        for (const ProfileProblem& problem : profile_problems(toml)) expect_known(problem.text, toml);
    }
    void expect_known(const std::string& problem, const std::string& of) {
        if (problem.empty() || !seen_.insert(problem).second) return;
        const Phrase shown = profile_problem_phrase(problem);
        EXPECT_STRNE(shown.english, "%1") << problem << "\nof\n" << of;
        EXPECT_EQ(in_english(shown), problem);
        note(shown);
    }
    /// All values of two keys that have to do with each other.
    void look_at_pair(const ProfileKey& a, const ProfileKey& b) {
        for (const std::string& machine : machines(field_of(a))) {
            const bool is_said = machine.find(a.path + " ") != std::string::npos ||
                                 machine.find(b.path + " ") != std::string::npos;
            if (is_said) continue;
            for (const std::string& first : possible_values(a)) {
                for (const std::string& second : possible_values(b)) {
                    if (!machine.empty() && pairs_++ % kPairStride != 0) continue;
                    look_at(machine + line_of(a.path, first) + line_of(b.path, second));
                }
            }
        }
    }
    void look_at_typed() {
        for (std::size_t key = 0; key < profile_keys().size(); ++key) {
            for (const char* typed : {"", "fast", "1.5", "1 ... 2", "a\x1b"}) {
                profile::ProfileDraft draft;
                draft.type(key, typed);
                expect_known(draft.problem(key), typed);
            }
        }
    }
    void note(const Phrase& shown) {
        const std::string english = shown.english;
        met_.insert(english.starts_with("%3 where the table")
                        ? "%1 where the table [%2] is expected; put its keys below [%3]"  // in another order
                        : english);
        for (const Phrase& inner : shown.inner) {
            EXPECT_STRNE(inner.english, "%1") << in_english(shown);
            note(inner);
        }
    }

    /// On machines other than the usual one, one pair in so many is tried; all problems are met even so.
    static inline const std::size_t kPairStride = psicarve::test::is_thorough() ? 1 : 5;

    std::size_t pairs_ = 0;
    std::set<std::string> seen_;
    std::set<std::string> met_;
};

// Whatever a profile can be refused for, from profiles that are refused: each key with values of every kind,
// and all pairs of keys that have to do with each other, on machines of each kind.
TEST_F(ProfilePhrases, HaveWordsForEveryProblemThatAProfileCanHave) {
    const std::vector<ProfileKey>& keys = profile_keys();
    for (const ProfileKey& key : keys) {
        for (const Values& values : {any_values(), values_at_bounds(key), possible_values(key)})
            for (const std::string& value : values) look_at(line_of(key.path, value));
        if (const auto table = table_of_key(key.path); !table.empty()) look_at(line_of(table, "3"));
        look_at(line_of(key.path + "s", "3"));
    }
    for (auto a = keys.begin(); a != keys.end(); ++a) {
        for (auto b = a + 1; b != keys.end(); ++b) {
            if (field_of(*a) == field_of(*b)) look_at_pair(*a, *b);
        }
    }
    look_at_typed();
    look_at("[");
    look_at(std::string(100, 'x') + " = 3\n");
    look_at(std::string(kProfileTextBytes + 1, '\n'));
    for (const std::string& known : known_profile_problems())
        EXPECT_TRUE(met_.contains(known)) << "no profile has this problem: " << known;
}

TEST_F(ProfilePhrases, TakeTheirArgumentsAlong) {
    EXPECT_EQ(profile_problem_phrase("0 mm/s is impossible; give a value from 0.001 to 10000 mm/s").arguments,
              (Values{"0 mm/s", "0.001", "10000 mm/s"}));
    const Phrase wrong =
        profile_problem_phrase("a string where min, max or none is expected; correct the value");
    EXPECT_EQ(wrong.inner, (std::vector<Phrase>{phrase("a string"), phrase("min, max or none")}));
    EXPECT_TRUE(wrong.arguments.empty());
    EXPECT_EQ(in_english(profile_problem_phrase("something else")), "something else");
}

TEST_F(ProfilePhrases, TellWhyAProfileCannotBeReadOrSaved) {
    const psicarve::test::TemporaryFolder folder;
    const std::string path = folder.path("a: b.toml");
    const auto written = [&path](const std::string& toml) { std::ofstream{path} << toml; };
    for (const char* toml : {"[job]\nfeed_mm_s = 0\n", "\nname = = 3\n", "[axis.r1]\nbogus = 1\n",
                             "[axis.psi]\npulses_per_rev = 6401\n"}) {
        written(toml);
        const auto read = load_profile(path);
        ASSERT_FALSE(read);
        const Phrase shown = error_phrase(read.error().message);
        ASSERT_EQ(shown.inner.size(), 3U) << read.error().message;
        EXPECT_EQ(in_english(shown.inner[0]), path);
        EXPECT_STREQ(shown.inner[1].english, "line %1");
    }
    written("[job]\nfeed_mm_s = 0\n");
    EXPECT_EQ(in_english(error_phrase(load_profile(path).error().message)),
              path + ": line 2: job.feed_mm_s: 0 mm/s is impossible; give a value from 0.001 to 10000 mm/s");
    written("[job]\nfeed_mm_s = 3\n");
    auto draft = profile::ProfileDraft::open(path);
    ASSERT_TRUE(draft);
    draft->type(profile::key_named("job.feed_mm_s"), "-1");
    EXPECT_EQ(error_phrase(draft->save().error().message),
              joined(phrase("%1", "job.feed_mm_s"), phrase("%1 is impossible; give a value from %2 to %3",
                                                           "-1 mm/s", "0.001", "10000 mm/s")));
    draft->type(profile::key_named("job.feed_mm_s"), "4");
    written("# of somebody else\n");
    EXPECT_TRUE(std::string_view{error_phrase(draft->save().error().message).english}.starts_with(
        "%1: somebody has changed this file"));
    EXPECT_STREQ(error_phrase(profile::ProfileDraft{}.save().error().message).english,
                 "the built-in profile has no file: save it under a name");
}

}  // namespace
}  // namespace psicarve::session
