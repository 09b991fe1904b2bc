// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "shared/wording/wording.hpp"
#include "tests/places.hpp"

namespace psicarve {
namespace {

constexpr const char* kPage = "docs/messages.md";

std::vector<std::string> lines_of_page() {
    std::ifstream file{in_source(kPage)};
    std::vector<std::string> lines;
    for (std::string line; std::getline(file, line);) lines.push_back(line);
    return lines;
}

bool is_message_row(const std::string& line) {
    return line.size() > 2 && line.starts_with("| ") &&
           std::isdigit(static_cast<unsigned char>(line[2])) != 0;
}

std::string row_of_message(const Wording& row) {
    std::string arguments;
    for (std::size_t i = 0; i < row.argument_count(); ++i)
        arguments += std::string{arguments.empty() ? "" : ", "} + "`" + row.arguments[i].name + "`";
    std::string remedy = row.remedy;
    return "| " + std::to_string(static_cast<unsigned>(row.id)) + " | `" + row.name + "` | " + row.sentence +
           " | " + remedy + " | " + arguments + " |";
}

std::vector<std::string> rows_wanted() {
    std::vector<std::string> rows;
    for (const Wording& row : wordings()) rows.push_back(row_of_message(row));
    return rows;
}

// After a change of the table:
//   PSICARVE_WRITE_MESSAGES=1 build/dev/tests/shared_wording_test --gtest_filter='MessageDocs.*'
TEST(MessageDocs, ListEveryMessageAsItIs) {
    const std::vector<std::string> lines = lines_of_page();
    if (std::getenv("PSICARVE_WRITE_MESSAGES") != nullptr) {
        std::ofstream page{in_source(kPage)};
        for (const std::string& line : lines) {
            if (is_message_row(line)) continue;
            page << line << "\n";
            if (!line.starts_with("| --- | --- | --- |")) continue;
            for (const std::string& row : rows_wanted()) page << row << "\n";
        }
        return;
    }
    std::vector<std::string> documented;
    for (const std::string& line : lines)
        if (is_message_row(line)) documented.push_back(line);
    EXPECT_EQ(documented, rows_wanted());
}

/// All sources of the product that raise messages, without what stands between words.
std::string product_sources() {
    std::string text;
    for (const std::string side : {"shared", "rtcore", "hmi"}) {
        for (const auto& entry : std::filesystem::recursive_directory_iterator{in_source(side)}) {
            const std::string path = entry.path().string();
            const bool is_source = path.ends_with(".cpp") || path.ends_with(".hpp");
            const bool makes_words = path.find("/shared/wording/") != std::string::npos ||
                                     path.find("/hmi/phrase/") != std::string::npos;
            if (!is_source || makes_words) continue;
            std::ifstream file{path};
            for (char c = 0; file.get(c);)
                if (std::isspace(static_cast<unsigned char>(c)) == 0) text += c;
        }
    }
    return text;
}

TEST(MessageDocs, EveryMessageIsRaisedSomewhere) {
    const std::string sources = product_sources();
    ASSERT_GT(sources.size(), 1'000'000U);
    for (const Wording& row : wordings()) {
        const std::string raised = std::string{"message_of(MessageId::"} + row.name;
        const bool is_raised = sources.find(raised + ")") != std::string::npos ||
                               sources.find(raised + ",") != std::string::npos;
        EXPECT_TRUE(is_raised) << row.name;
    }
}

}  // namespace
}  // namespace psicarve
