// SPDX-License-Identifier: GPL-3.0-or-later
// Ten thousand files in every way to write TOML. The generator knows which bytes of a file each value is.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hmi/profile/toml_edit.hpp"
#include "shared/profile/toml_library.hpp"
#include "tests/thoroughness.hpp"

namespace psicarve::profile {
namespace {

constexpr std::uint32_t kSeed = 20120611;
constexpr const char* kNewValue = "\"new \xC3\xA4 # ] }\"";

struct Value {
    std::string path;
    std::size_t begin;
    std::size_t size;
};

/// One file, written at random.
class RandomToml {
public:
    explicit RandomToml(std::uint32_t seed) : random_{seed}, newline_{one_of({"\n", "\n", "\r\n"})} {
        if (happens(10)) text_ = "\xEF\xBB\xBF";
        if (happens(30)) noise();
        lines_of_table("", "", 0);
        for (const auto& [header, prefix] : headed_) {
            noise();
            text_ += blanks() + "[" + blanks() + header + blanks() + "]";
            end_of_line();
            lines_of_table(prefix, "", 1);
        }
        if (happens(10)) text_ += "[[list]]" + newline_ + "x = 1" + newline_ + "[[ list ]]" + newline_;
        if (text_.ends_with(newline_) && happens(30)) text_.resize(text_.size() - newline_.size());
    }

    const std::string& text() const { return text_; }
    /// Those whose path is of bare keys, so that it can be named.
    const std::vector<Value>& values() const { return values_; }
    /// "" or "a.b.": each table that is there.
    const std::vector<std::string>& tables() const { return tables_; }
    std::size_t below(std::size_t limit) { return random_() % limit; }
    bool happens(unsigned per_cent) { return below(100) < per_cent; }

private:
    std::string one_of(std::initializer_list<const char*> choices) {
        return choices.begin()[below(choices.size())];
    }
    std::string blanks() { return one_of({"", "", " ", "  ", "\t"}); }
    void noise() {
        while (happens(40))
            text_ +=
                blanks() +
                one_of({"", "# a remark", "# key = 1", "# [axis.r1]", "# \xE4\xB8\xAD\xE6\x96\x87 \"", "#"}) +
                newline_;
    }
    void end_of_line() {
        text_ += blanks();
        if (happens(40)) text_ += one_of({"# why", "#", "# \xF0\x9F\x94\xA7 ' = 3", "# ]", "# }"});
        text_ += newline_;
        noise();
    }
    std::string scalar() {
        return one_of({"1",
                       "-17",
                       "1_000",
                       "0x1F",
                       "0b101",
                       "1.5",
                       "-2e-3",
                       "6.02e+23",
                       "inf",
                       "true",
                       "false",
                       "\"\"",
                       "\"a # b\"",
                       "'c:\\d'",
                       "\"\\\"quoted\\\"\"",
                       "\"\xC3\xA4\xC3\xB6 = \xE2\x82\xAC\"",
                       "1979-05-27",
                       "07:32:00",
                       "1979-05-27T07:32:00Z",
                       "\"\\u00E4\"",
                       "''"});
    }
    std::string array(int depth) {
        std::string result = "[";
        for (std::size_t left = below(4); left > 0; --left) {
            if (happens(30)) result += newline_ + blanks() + (happens(40) ? "# one, two ]" + newline_ : "");
            result += blanks() + (depth < 2 && happens(20)   ? array(depth + 1)
                                  : depth < 2 && happens(10) ? "{ x = 1, y = \"}\" }"
                                                             : scalar());
            result += blanks() + (left > 1 || happens(30) ? "," : "");
        }
        return result + (happens(30) ? newline_ : "") + "]";
    }
    std::string long_string() {
        const std::string quotes = one_of({"\"\"\"", "'''"});
        return quotes + newline_ + "[axis.r1]" + newline_ + "a = 1 # \xC3\xBC" + newline_ + blanks() +
               "'' \"\" #" + quotes;
    }
    void value(const std::string& path, bool in_line) {
        const std::string text = happens(20) ? array(0) : !in_line && happens(15) ? long_string() : scalar();
        if (path.find('"') == std::string::npos && path.find('\'') == std::string::npos)
            values_.push_back({path, text_.size(), text.size()});
        text_ += text;
    }
    /// Names that differ, of which some need quotes.
    std::vector<std::string> names(std::size_t most) {
        std::vector<std::string> all{"a",     "b",    "r1", "r2", "speed_mm_s", "x-y", "3", "\"\xC3\xA4 b\"",
                                     "'c.d'", "\"]\""};
        std::shuffle(all.begin(), all.end(), random_);
        all.resize(1 + below(most));
        return all;
    }
    void add_table(const std::string& prefix) {
        if (prefix.find('"') == std::string::npos && prefix.find('\'') == std::string::npos)
            tables_.push_back(prefix);
    }
    void inline_table(const std::string& prefix, int depth) {
        add_table(prefix);
        text_ += "{" + blanks();
        bool is_first = true;
        for (const std::string& name : happens(15) ? std::vector<std::string>{} : names(3)) {
            if (!is_first) text_ += "," + blanks();
            is_first = false;
            text_ += name;
            std::string path = prefix + name;
            if (happens(20)) {
                text_ += ".d";
                add_table(path + ".");
                path += ".d";
            }
            text_ += blanks() + "=" + blanks();
            if (depth < 3 && happens(20))
                inline_table(path + ".", depth + 1);
            else
                value(path, true);
            text_ += blanks();
        }
        text_ += "}";
    }
    /// `prefix`: of the paths; `dotted`: what stands before each key of a table that dotted keys make.
    void lines_of_table(const std::string& prefix, const std::string& dotted, int depth) {
        const std::size_t begin = text_.size();
        std::vector<std::string> headed;
        std::vector<std::pair<std::string, std::string>> late;  ///< keys of tables that others stand behind
        for (const std::string& name : names(depth == 0 ? 6 : 4)) {
            const std::string path = prefix + name;
            const std::size_t kind = below(10);
            if (kind < 5 || depth > 3) {
                text_ += blanks() + dotted + name + blanks() + "=" + blanks();
                value(path, false);
                end_of_line();
            } else if (kind < 6) {
                text_ += blanks() + dotted + name + blanks() + "=" + blanks();
                inline_table(path + ".", depth + 1);
                end_of_line();
            } else if (kind < 7) {
                const std::string before = dotted + name + blanks() + "." + blanks();
                lines_of_table(path + ".", before, depth + 1);
                if (happens(30)) late.emplace_back(before + "late", path + ".late");
            } else if (dotted.empty() && depth == 0) {
                headed.push_back(name);
            }
        }
        for (const auto& [key, path] : late) {
            text_ += blanks() + key + blanks() + "=" + blanks();
            value(path, false);
            end_of_line();
        }
        // Dotted keys make a table only where there are any.
        if (dotted.empty() || text_.size() > begin) add_table(prefix);
        for (const std::string& name : headed) {
            headed_.emplace_back(name, name + ".");
            if (happens(40)) {
                const std::string inner = one_of({"in", "\"i n\""});
                // Also before the table that it is in, or without it.
                headed_.insert(headed_.end() - static_cast<std::ptrdiff_t>(below(2)),
                               {name + blanks() + "." + blanks() + inner, name + "." + inner + "."});
                if (happens(20)) {
                    add_table(name + ".");  // by the header of the one within it alone
                    headed_.erase(std::find_if(headed_.begin(), headed_.end(),
                                               [&](const auto& it) { return it.first == name; }));
                }
            }
        }
    }

    std::mt19937 random_;
    std::string newline_;
    std::string text_;
    std::vector<Value> values_;
    std::vector<std::string> tables_;
    std::vector<std::pair<std::string, std::string>> headed_;  ///< as written, and as prefix
};

std::uint32_t file_count() {
    return psicarve::test::is_thorough() ? 10'000 : 500;
}

TEST(TomlEditSweep, OfAnyFileOnlyTheValuesBytesChange) {
    std::size_t changed = 0;
    for (std::uint32_t n = 0; n < file_count(); ++n) {
        RandomToml file{kSeed + n};
        ASSERT_TRUE(toml::parse(file.text())) << "the generator writes no TOML:\n" << file.text();
        if (file.values().empty()) continue;
        const Value& at = file.values()[file.below(file.values().size())];
        EXPECT_EQ(value_in(file.text(), at.path), file.text().substr(at.begin, at.size)) << file.text();
        const auto result = with_value(file.text(), at.path, kNewValue);
        ASSERT_TRUE(result) << result.error().message << "\n" << file.text();
        std::string wanted = file.text();
        wanted.replace(at.begin, at.size, kNewValue);
        ASSERT_EQ(*result, wanted) << at.path << " in\n" << file.text();
        ++changed;
    }
    EXPECT_GT(changed, file_count() * 4 / 5);
}

/// `table` without what the path names; each table on the way is there.
void erase(toml::table& table, std::string_view path) {
    const std::size_t dot = path.find('.');
    if (dot == std::string_view::npos) {
        table.erase(path);
        return;
    }
    toml::table& inner = *table.get(path.substr(0, dot))->as_table();
    erase(inner, path.substr(dot + 1));
}

TEST(TomlEditSweep, ToAnyTableOneValueIsAddedAndNoByteTakenAway) {
    for (std::uint32_t n = 0; n < file_count(); ++n) {
        RandomToml file{kSeed + n};
        const std::string& text = file.text();
        const std::string table = file.tables()[file.below(file.tables().size())];
        const std::string path = table + "added";
        ASSERT_EQ(value_in(text, path), std::nullopt);
        const auto result = with_value(text, path, kNewValue);
        ASSERT_TRUE(result) << path << ": " << result.error().message << "\n" << text;
        const auto same_begin = static_cast<std::size_t>(
            std::mismatch(text.begin(), text.end(), result->begin(), result->end()).first - text.begin());
        const std::string_view rest = std::string_view{text}.substr(same_begin);
        ASSERT_TRUE(result->size() > text.size() && std::string_view{*result}.ends_with(rest)) << *result;
        EXPECT_EQ(value_in(*result, path), kNewValue) << *result;
        toml::parse_result again = toml::parse(*result);
        ASSERT_TRUE(again) << *result;
        erase(again.table(), path);
        const auto second = with_value(*result, table + "one-more", kNewValue);
        ASSERT_TRUE(second) << second.error().message << "\n" << *result;
        EXPECT_EQ(value_in(*second, path), kNewValue) << *second;
        EXPECT_EQ(value_in(*second, table + "one-more"), kNewValue) << *second;
        EXPECT_EQ(again.table(), toml::parse(text).table()) << path << " in\n" << text << "\nis\n" << *result;
    }
}

TEST(TomlEditSweep, AnyFileTakesATableThatItDoesNotHave) {
    for (std::uint32_t n = 0; n < file_count(); ++n) {
        RandomToml file{kSeed + n};
        const auto result = with_value(file.text(), "new.inner.added", kNewValue);
        ASSERT_TRUE(result) << result.error().message << "\n" << file.text();
        EXPECT_TRUE(result->starts_with(file.text())) << *result;
        EXPECT_EQ(value_in(*result, "new.inner.added"), kNewValue) << *result;
    }
}

}  // namespace
}  // namespace psicarve::profile
