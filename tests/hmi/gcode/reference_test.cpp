// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "hmi/gcode/canon_writer.hpp"
#include "tests/hmi/gcode/read_program.hpp"
#include "tests/places.hpp"

namespace psicarve::gcode {
namespace {

using Json = nlohmann::json;

constexpr double kToleranceMm = 0.0003;
constexpr double kInchToleranceMm = 0.004;

std::vector<std::string> good_programs() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator{in_source("tests/data/gcode/good")})
        names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    return names;
}

std::vector<Json> lines_of(const std::string& text) {
    std::vector<Json> records;
    std::istringstream lines{text};
    for (std::string line; std::getline(lines, line);) records.push_back(Json::parse(line));
    return records;
}

/// Those that the references have: an "off" of a spindle that stands tells nothing.
std::vector<Json> compared(const std::vector<CanonRecord>& records) {
    static const std::set<std::string> kCompared{"rapid",   "feed", "arc",         "dwell", "speed",
                                                 "spindle", "tool", "tool_change", "stop",  "end"};
    std::vector<Json> kept;
    bool is_on = false;
    for (const CanonRecord& record : records) {
        std::string text;
        append_canon_line(record, text);
        const Json json = Json::parse(text);
        if (!kCompared.contains(json["k"])) continue;
        const bool is_spindle = json["k"] == "spindle";
        if (is_spindle && json["dir"] == "off" && !is_on) continue;
        if (is_spindle) is_on = json["dir"] != "off";
        kept.push_back(json);
    }
    return kept;
}

void expect_near(const Json& ours, const Json& theirs, const char* key, double tolerance) {
    ASSERT_EQ(ours.contains(key), theirs.contains(key)) << key;
    if (!ours.contains(key)) return;
    const auto numbers = [&](const Json& record) {
        return record[key].is_array() ? record[key].get<std::vector<double>>()
                                      : std::vector<double>{record[key].get<double>()};
    };
    const std::vector<double> a = numbers(ours);
    const std::vector<double> b = numbers(theirs);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], tolerance) << key << ' ' << i;
}

void expect_alike(const Json& ours, const Json& theirs, double tolerance_mm) {
    for (const char* key : {"k", "plane", "rot", "dir", "why", "t"})
        EXPECT_EQ(ours.value(key, Json()), theirs.value(key, Json())) << key;
    for (const char* key : {"end", "ctr", "s", "rpm"}) expect_near(ours, theirs, key, tolerance_mm);
    const double feed = theirs.value("f", 0.0);
    expect_near(ours, theirs, "f", std::max(tolerance_mm, 1e-4 * std::abs(feed)));
}

class GoodPrograms : public ::testing::TestWithParam<std::string> {};

TEST_P(GoodPrograms, MoveAsLinuxcncHasThem) {
    const std::string text = file_text(in_source("tests/data/gcode/good/" + GetParam() + ".ngc"));
    InterpreterOptions options;
    options.skips_deleted = GetParam().starts_with("deleted");
    const auto read = read_program(text, options);
    EXPECT_EQ(read->problems.error_count(), 0U) << Json(read->faults());
    const std::vector<Json> ours = compared(read->records);
    const std::vector<Json> theirs =
        lines_of(file_text(in_source("tests/data/gcode/reference/" + GetParam() + ".canon")));
    ASSERT_EQ(ours.size(), theirs.size());
    const bool has_inches = text.find("G20") != std::string::npos;
    for (std::size_t i = 0; i < ours.size(); ++i) {
        SCOPED_TRACE(ours[i].dump() + " | " + theirs[i].dump());
        expect_alike(ours[i], theirs[i], has_inches ? kInchToleranceMm : kToleranceMm);
    }
}

INSTANTIATE_TEST_SUITE_P(Gcode, GoodPrograms, ::testing::ValuesIn(good_programs()),
                         [](const auto& program) { return program.param; });

TEST(GoodProgramsList, IsNotEmpty) {
    EXPECT_GE(good_programs().size(), 40U);
}

}  // namespace
}  // namespace psicarve::gcode
