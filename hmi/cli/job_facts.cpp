// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/job_facts.hpp"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "hmi/cli/progress_bar.hpp"
#include "shared/base/units.hpp"

namespace psicarve::cli {
namespace {

template <typename... Args>
std::string line_with(const char* format, Args... args) {
    char text[256];
    std::snprintf(text, sizeof text, format, args...);
    return text;
}

/// Numbers of an array, if it has so many.
bool takes_numbers(const nlohmann::json& report, const char* key, double* numbers, std::size_t count) {
    const auto found = report.find(key);
    if (found == report.end() || !found->is_array() || found->size() != count) return false;
    for (std::size_t i = 0; i < count; ++i) {
        if (!(*found)[i].is_number()) return false;
        numbers[i] = (*found)[i].get<double>();
    }
    return true;
}

std::string word_of(const nlohmann::json& report, const char* key) {
    const auto found = report.find(key);
    return found != report.end() && found->is_string() ? found->get<std::string>() : std::string{};
}

}  // namespace

JobSize job_size(const JobView& job, const Profile& profile) {
    JobSize size;
    bool is_first = true;
    const auto note = [&](const auto& row, Axis head) {
        const auto [least, greatest] = std::minmax_element(row.begin(), row.end());
        const double scale = axis_motion(profile, head).pulses_per_unit;
        const double tip_mm = (head == Axis::r1 ? profile.r1 : profile.r2).tip_mm();
        const double least_mm = mm_from_pulses(*least, scale) + tip_mm;
        const double greatest_mm = mm_from_pulses(*greatest, scale) + tip_mm;
        size.least_radius_mm = is_first ? least_mm : std::min(size.least_radius_mm, least_mm);
        size.greatest_radius_mm = is_first ? greatest_mm : std::max(size.greatest_radius_mm, greatest_mm);
        is_first = false;
    };
    for (std::uint32_t layer = job.finishing_layer(); layer < job.layer_count(); ++layer) {
        note(job.r_left_pulses(layer), Axis::r1);
        note(job.r_right_pulses(layer), Axis::r2);
    }
    const auto heights = job.layer_heights_pulses();
    const double y_scale = axis_motion(profile, Axis::y).pulses_per_unit;
    size.lowest_mm = mm_from_pulses(heights[job.finishing_layer()], y_scale);
    size.highest_mm = mm_from_pulses(heights.back(), y_scale);
    return size;
}

std::string size_text(const JobSize& size) {
    return line_with("radii %.2f to %.2f mm, heights %.2f to %.2f mm", size.least_radius_mm,
                     size.greatest_radius_mm, size.lowest_mm, size.highest_mm);
}

nlohmann::ordered_json size_json(const JobSize& size) {
    return {{"radius_mm", {size.least_radius_mm, size.greatest_radius_mm}},
            {"height_mm", {size.lowest_mm, size.highest_mm}}};
}

void add_time_option(Syntax& syntax, bool& wanted) {
    syntax.flag("--time", wanted, "Plan the job, too, and tell how long carving takes, and its T_ref");
}

std::string time_text(const machine::PlannedTime& planned) {
    std::string text = clock_text(planned.carve_seconds);
    if (planned.reference_seconds) text += ", T_ref " + clock_text(*planned.reference_seconds);
    return text;
}

nlohmann::ordered_json time_json(const std::optional<machine::PlannedTime>& planned) {
    using FactsJson = nlohmann::ordered_json;
    if (!planned) return {{"carve_seconds", nullptr}, {"reference_seconds", nullptr}};
    return {{"carve_seconds", planned->carve_seconds},
            {"reference_seconds",
             planned->reference_seconds ? FactsJson(*planned->reference_seconds) : FactsJson(nullptr)}};
}

std::string slicer_text(const JobView& job) {
    const auto report = nlohmann::json::parse(job.report_json(), nullptr, false);
    if (!report.is_object()) return {};
    std::string text;
    double numbers[3]{};
    if (takes_numbers(report, "bounding_box_mm", numbers, 3))
        text += line_with("model      %.2f x %.2f x %.2f mm\n", numbers[0], numbers[1], numbers[2]);
    if (takes_numbers(report, "axis", numbers, 2))
        text += line_with("axis       at %.4g, %.4g of the file, %s up\n", numbers[0], numbers[1],
                          word_of(report, "up").c_str());
    if (const std::string tool = word_of(report, "tool"); !tool.empty()) text += "tool       " + tool + "\n";
    if (report.contains("undercut_share") && report["undercut_share"].is_number())
        text +=
            line_with("hidden     %.2f %% of the surface\n", 100.0 * report["undercut_share"].get<double>());
    if (report.contains("open_points") && report["open_points"].is_number_unsigned())
        text += line_with("open       %llu samples\n",
                          static_cast<unsigned long long>(report["open_points"].get<std::uint64_t>()));
    return text;
}

}  // namespace psicarve::cli
