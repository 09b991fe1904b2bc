// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/report/job_export.hpp"

#include <charconv>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <vector>

namespace psicarve::report {
namespace {

using Json = nlohmann::ordered_json;

// Millions of numbers: printf would take longer than all the rest.
void append(std::string& text, std::int64_t number, char after) {
    char digits[24];
    const auto [end, error] = std::to_chars(digits, digits + sizeof digits, number);
    text.append(digits, end);
    text.push_back(after);
}

/// The shortest text that reads back to the same number.
void append(std::string& text, double number) {
    char digits[32];
    const auto [end, error] = std::to_chars(digits, digits + sizeof digits, number);
    text.append(digits, end);
}

void write(std::FILE* out, const std::string& text) {
    std::fwrite(text.data(), 1, text.size(), out);
}

template <typename Number>
void append_row(std::string& text, std::span<const Number> row) {
    text += "[";
    for (const Number number : row) append(text, number, ',');
    text.back() = ']';
}

void write_table(const JobView& job, Axis head, std::FILE* out) {
    std::string text;
    for (std::uint32_t layer = 0; layer < job.layer_count(); ++layer) {
        text.assign(layer == 0 ? "[" : ",");
        append_row(text, head == Axis::r1 ? job.r_left_pulses(layer) : job.r_right_pulses(layer));
        write(out, text);
    }
    write(out, "]");
}

void write_point_heights(const JobView& job, std::FILE* out) {
    std::vector<std::int64_t> heights(job.point_count());
    std::string text;
    for (std::uint32_t layer = 0; layer < job.layer_count(); ++layer) {
        for (std::uint32_t point = 0; point < job.point_count(); ++point) {
            heights[point] = job.y_pulses(layer, point);
        }
        text.assign(layer == 0 ? "[" : ",");
        append_row(text, std::span<const std::int64_t>(heights));
        write(out, text);
    }
    write(out, "]");
}

/// The end of each row of a layer: ",1,1,0.3,8,12\n".
std::string run_columns(const JobView& job, std::uint32_t layer) {
    const std::uint32_t run = job.pass_of(layer);
    const JobPass& pass = job.passes()[run];
    std::string text = "," + std::to_string(run + 1) + "," + std::to_string(pass.number);
    for (const double length_mm : {pass.allowance_mm, pass.depth_mm, pass.clear_mm}) {
        text.push_back(',');
        append(text, length_mm);
    }
    return text + "\n";
}

}  // namespace

void write_csv(const JobView& job, std::FILE* out) {
    const bool has_passes = job.header().pass_count > 0;
    write(out, "layer,point,y_pulses,psi_pulses,r_left_pulses,r_right_pulses");
    write(out, has_passes ? ",run,pass,allowance_mm,depth_mm,clear_mm\n" : "\n");
    std::string rows;
    for (std::uint32_t layer = 0; layer < job.layer_count(); ++layer) {
        rows.clear();
        const std::string end = has_passes ? run_columns(job, layer) : "\n";
        const auto left = job.r_left_pulses(layer);
        const auto right = job.r_right_pulses(layer);
        for (std::uint32_t point = 0; point < job.point_count(); ++point) {
            append(rows, layer, ',');
            append(rows, point, ',');
            append(rows, job.y_pulses(layer, point), ',');
            append(rows, job.psi_pulses(layer, point), ',');
            append(rows, left[point], ',');
            append(rows, right[point], end.front());
            rows.append(end, 1);
        }
        write(out, rows);
    }
}

void write_json(const JobView& job, std::FILE* out) {
    const Json slicer = Json::parse(job.report_json(), nullptr, false);
    const Json head{{"source", std::string{job.source_name()}},
                    {"layers", job.layer_count()},
                    {"points", job.point_count()},
                    {"psi_sweep_pulses", job.psi_sweep_pulses()},
                    {"joining", name_of(job.joining())},
                    {"feed_mm_s", job.header().feed_mm_s},
                    {"profile", std::string{job.profile_toml()}},
                    {"slice_report", slicer.is_discarded() ? Json(nullptr) : slicer}};
    std::string text = head.dump(-1, ' ', false, Json::error_handler_t::replace);
    text.back() = ',';
    text += "\"y_pulses\":";
    append_row(text, job.layer_heights_pulses());
    write(out, text);
    if (job.joining() == Joining::spiral) {
        write(out, ",\"point_y_pulses\":");
        write_point_heights(job, out);
    }
    write(out, ",\"r_left_pulses\":");
    write_table(job, Axis::r1, out);
    write(out, ",\"r_right_pulses\":");
    write_table(job, Axis::r2, out);
    write(out, "}\n");
}

}  // namespace psicarve::report
