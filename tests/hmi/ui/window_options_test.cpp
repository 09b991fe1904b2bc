// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/ui/window_options.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "hmi/manual/window_table.hpp"

namespace psicarve::ui {
namespace {

TEST(WindowOptions, TakesAFileAndASegment) {
    const WindowOptions options = parse_window_options({"owl.stl", "--segment", "/mine", "--profile=p.toml"});
    EXPECT_FALSE(options.exit_code);
    EXPECT_EQ(options.path, "owl.stl");
    EXPECT_EQ(options.segment_name, "/mine");
    EXPECT_EQ(options.profile_path, "p.toml");
    EXPECT_EQ(parse_window_options({}).segment_name, "/psicarve");
    EXPECT_EQ(parse_window_options({"--", "--odd.stl"}).path, "--odd.stl");
}

TEST(WindowOptions, LeavesOpenGlToTheMachineUnlessTold) {
    EXPECT_EQ(parse_window_options({}).opengl, OpenGl::automatic);
    EXPECT_EQ(parse_window_options({"--opengl"}).opengl, OpenGl::always);
    EXPECT_EQ(parse_window_options({"--no-opengl"}).opengl, OpenGl::never);
}

TEST(WindowOptions, KnowLanguages) {
    EXPECT_EQ(parse_window_options({"--language", "ru"}).language, "ru");
    EXPECT_EQ(parse_window_options({"--language", "tlh"}).exit_code, 2);
    EXPECT_EQ(language_of("zh_CN"), Language::chinese);
    EXPECT_EQ(language_of("zh-Hans-CN"), Language::chinese);
    EXPECT_EQ(language_of("zh"), Language::chinese);
    EXPECT_EQ(language_of("zh_TW"), std::nullopt);
    EXPECT_EQ(language_of("ru_RU"), Language::russian);
    EXPECT_EQ(language_of("en-GB"), Language::english);
    EXPECT_EQ(language_of("C"), std::nullopt);
}

TEST(WindowOptions, RefusesWrongUsageInOneLine) {
    using Words = std::vector<std::string>;
    for (const Words& wrong :
         {Words{"--nothing"}, Words{"a.stl", "b.stl"}, Words{"--segment"}, Words{"--segment="},
          Words{"--segment", "mine"}, Words{"--segment", "/a/b"}, Words{""}}) {
        const WindowOptions options = parse_window_options(wrong);
        ASSERT_TRUE(options.exit_code) << wrong.front();
        EXPECT_EQ(*options.exit_code, 2);
        EXPECT_EQ(options.text.find('\n'), options.text.size() - 1) << options.text;
    }
}

TEST(WindowOptions, AreThoseThatHelpTellsOf) {
    const std::map<std::string, std::string> values{{"--segment", "/mine"},
                                                    {"--profile", "p.toml"},
                                                    {"--group", "carvers"},
                                                    {"--language", "ru"},
                                                    {"--state", "/kept"}};
    for (const manual::OptionRow& option : manual::window_table().options) {
        for (const std::string& name : option.names) {
            std::vector<std::string> words{name};
            if (!option.type.empty()) words.push_back(values.at(name));
            EXPECT_EQ(parse_window_options(words).exit_code.value_or(0), 0) << name;
        }
    }
    const manual::OptionRow* const language = manual::window_option("--language");
    ASSERT_NE(language, nullptr);
    std::string codes;
    for (const LanguageName& known : kLanguages) codes += std::string{codes.empty() ? "" : "|"} + known.code;
    EXPECT_EQ(language->type, codes);
}

TEST(WindowOptions, ExplainsItself) {
    const WindowOptions help = parse_window_options({"--help"});
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_NE(help.text.find("--segment"), std::string::npos);
    EXPECT_EQ(parse_window_options({"--version"}).exit_code, 0);
}

}  // namespace
}  // namespace psicarve::ui
