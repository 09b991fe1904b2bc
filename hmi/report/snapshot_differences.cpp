// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/report/snapshot_differences.hpp"

#include <cstring>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "hmi/report/record_text.hpp"
#include "hmi/report/status_json.hpp"
#include "shared/job/job.hpp"

namespace psicarve::report {
namespace {

class Comparison {
public:
    void text(const std::string& what, const std::string& a, const std::string& b) {
        if (a != b) found_.push_back({what, a, b});
    }
    template <typename Number>
    void number(const std::string& what, Number a, Number b) {
        if (a != b) found_.push_back({what, std::to_string(a), std::to_string(b)});
    }
    std::vector<Difference> take() { return std::move(found_); }

private:
    std::vector<Difference> found_;
};

/// Where two tables of the same shape differ first, and how often.
struct TableDifference {
    std::uint64_t count = 0;
    std::uint32_t layer = 0;
    std::uint32_t point = 0;
    std::int64_t a = 0;
    std::int64_t b = 0;

    void compare(std::uint32_t at_layer, std::uint32_t at_point, std::int64_t in_a, std::int64_t in_b) {
        if (in_a == in_b) return;
        if (count == 0) *this = {0, at_layer, at_point, in_a, in_b};
        ++count;
    }
    void add_to(Comparison& found, const std::string& name, const std::string& unit) const {
        if (count == 0) return;
        const std::string place = " of layer " + std::to_string(layer) +
                                  (unit == "points" ? ", point " + std::to_string(point) : std::string{});
        found.text(name + " (" + std::to_string(count) + " " + unit + " differ, the first" + place + ")",
                   std::to_string(a), std::to_string(b));
    }
};

/// "axis.r1.speed_mm_s" -> its value in the TOML that we write ourselves.
std::map<std::string, std::string> keys_of(const Profile& profile) {
    std::map<std::string, std::string> keys;
    std::istringstream lines{profile_to_toml(profile)};
    std::string table;
    for (std::string line; std::getline(lines, line);) {
        if (!line.empty() && line.front() == '[') table = line.substr(1, line.find(']') - 1) + ".";
        const std::size_t equals = line.find(" = ");
        if (equals == std::string::npos || line.front() == '#') continue;
        std::string value = line.substr(equals + 3);
        // A comment follows blanks; a string that holds a # ends in a quote before them.
        const std::size_t quote = value.rfind('"');
        const std::size_t comment = value.find("# ", quote == std::string::npos ? 0 : quote);
        value = value.substr(0, comment);
        while (!value.empty() && value.back() == ' ') value.pop_back();
        keys[table + line.substr(0, equals)] = value;
    }
    return keys;
}

void compare_profiles(const JobView& a, const JobView& b, Comparison& found) {
    if (a.profile_toml() == b.profile_toml()) return;
    const auto profile_a = job_profile(a);
    const auto profile_b = job_profile(b);
    if (!profile_a || !profile_b) {
        found.text("profile", profile_a ? "fine" : profile_a.error().message,
                   profile_b ? "fine" : profile_b.error().message);
        return;
    }
    const auto keys_a = keys_of(*profile_a);
    auto keys_b = keys_of(*profile_b);
    for (const auto& [key, value] : keys_a) found.text("profile " + key, value, keys_b[key]);
}

void compare_tables(const JobView& a, const JobView& b, Comparison& found) {
    TableDifference heights;
    TableDifference left;
    TableDifference right;
    for (std::uint32_t layer = 0; layer < a.layer_count(); ++layer) {
        heights.compare(layer, 0, a.layer_heights_pulses()[layer], b.layer_heights_pulses()[layer]);
        for (std::uint32_t point = 0; point < a.point_count(); ++point) {
            left.compare(layer, point, a.r_left_pulses(layer)[point], b.r_left_pulses(layer)[point]);
            right.compare(layer, point, a.r_right_pulses(layer)[point], b.r_right_pulses(layer)[point]);
        }
    }
    heights.add_to(found, "y_pulses", "layers");
    left.add_to(found, "r_left_pulses", "points");
    right.add_to(found, "r_right_pulses", "points");
}

void compare_jobs(const JobView& a, const JobView& b, Comparison& found) {
    found.text("source", std::string{a.source_name()}, std::string{b.source_name()});
    found.number("source_hash", a.header().source_hash, b.header().source_hash);
    found.number("layers", a.layer_count(), b.layer_count());
    found.number("points", a.point_count(), b.point_count());
    found.number("psi_sweep_pulses", a.psi_sweep_pulses(), b.psi_sweep_pulses());
    found.text("joining", std::string{name_of(a.joining())}, std::string{name_of(b.joining())});
    found.number("feed_mm_s", a.header().feed_mm_s, b.header().feed_mm_s);
    compare_profiles(a, b, found);
    if (a.layer_count() == b.layer_count() && a.point_count() == b.point_count()) compare_tables(a, b, found);
    found.text("slice report", std::string{a.report_json()}, std::string{b.report_json()});
}

void compare_statuses(const CoreStatus& a, const CoreStatus& b, Comparison& found) {
    const nlohmann::ordered_json of_a = status_json(a);
    const nlohmann::ordered_json of_b = status_json(b);
    for (const auto& [key, value] : of_a.items())
        found.text("status " + key, value.dump(), of_b.at(key).dump());
}

void compare_records(const Snapshot& a, const Snapshot& b, Comparison& found) {
    found.number("flight recorder entries", a.records.size(), b.records.size());
    const std::size_t both = std::min(a.records.size(), b.records.size());
    for (std::size_t i = 0; i < both; ++i) {
        if (std::memcmp(&a.records[i], &b.records[i], sizeof(FlightRecord)) == 0) continue;
        found.text("flight recorder entry " + std::to_string(i), record_text(a.records[i]),
                   record_text(b.records[i]));
        return;  // differences behind the first one follow from it
    }
}

std::optional<JobView> job_in(const Snapshot& snapshot) {
    const auto view = JobView::check(snapshot.job_blob);
    return view ? std::optional{*view} : std::nullopt;
}

}  // namespace

std::vector<Difference> differences_between(const Snapshot& a, const Snapshot& b) {
    Comparison found;
    const auto presence = [](bool is_there) { return std::string{is_there ? "there" : "none"}; };
    const auto job_a = job_in(a);
    const auto job_b = job_in(b);
    found.text("job", presence(job_a.has_value()), presence(job_b.has_value()));
    if (job_a && job_b) compare_jobs(*job_a, *job_b, found);
    found.text("status", presence(a.status.has_value()), presence(b.status.has_value()));
    if (a.status && b.status) compare_statuses(*a.status, *b.status, found);
    compare_records(a, b, found);
    return found.take();
}

}  // namespace psicarve::report
