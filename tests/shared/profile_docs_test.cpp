// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "shared/profile/profile.hpp"
#include "tests/places.hpp"

namespace psicarve {
namespace {

std::vector<std::string> documented_rows() {
    std::ifstream file(in_source("docs/profile.md"));
    std::vector<std::string> rows;
    for (std::string line; std::getline(file, line);) {
        if (line.starts_with("| `")) rows.push_back(line);
    }
    return rows;
}

std::string row_of(const ProfileKey& key) {
    const std::string unit = key.unit.empty() ? "" : " " + key.unit;
    return "| `" + key.path + "` |" + unit + " | `" + key.built_in + "` | " + key.bounds + " | " +
           (key.matters_to_motion ? "yes" : "no") + " | " + key.explanation + " |";
}

TEST(ProfileDocs, ListEveryKeyAsItIs) {
    std::vector<std::string> expected;
    std::ostringstream as_should_be;
    for (const ProfileKey& key : profile_keys()) {
        expected.push_back(row_of(key));
        as_should_be << row_of(key) << "\n";
    }
    EXPECT_EQ(documented_rows(), expected) << "docs/profile.md should list:\n" << as_should_be.str();
}

}  // namespace
}  // namespace psicarve
