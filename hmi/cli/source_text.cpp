// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/source_text.hpp"

#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "shared/base/shared_text.hpp"

namespace psicarve::cli {
namespace {

using Json = nlohmann::ordered_json;

// As the options of `gcode run` have them.
constexpr std::array<std::pair<std::uint32_t, const char*>, 6> kSwitches{
    {{kSourceIsIso, "--dialect iso"},
     {kSourceIsSingle, "--single"},
     {kSourceStopsAtOptional, "--optional-stop"},
     {kSourceSkipsDeleted, "--block-delete"},
     {kSourceIsDry, "--dry-run"},
     {kSourceIsTyped, "--mdi"}}};

std::vector<std::string> switches_of(const ProgramSource& source) {
    std::vector<std::string> switches;
    for (const auto& [flag, option] : kSwitches) {
        if ((source.flags & flag) != 0) switches.emplace_back(option);
    }
    if (source.from_line > 1) switches.push_back("--from-line " + std::to_string(source.from_line));
    return switches;
}

bool is_stream(const ProgramSource& source) {
    return (source.flags & kSourceIsStream) != 0;
}

}  // namespace

std::string hash_text(std::uint64_t hash) {
    std::array<char, 24> text{};
    std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash));
    return text.data();
}

std::string text_words(std::uint64_t bytes, std::uint64_t sum) {
    return std::to_string(bytes) + " bytes, XXH3 " + hash_text(sum);
}

std::string source_text(const RecordedSource* recorded) {
    if (recorded == nullptr) return {};
    const ProgramSource& source = recorded->source;
    std::string text = "its text   " + std::string{text_from_field(source.name)} + ": ";
    text += is_stream(source) ? "a stream" : text_words(source.text_bytes, source.text_sum);
    text += "; " + std::to_string(recorded->taken) + " motion records taken";
    const char* separator = "; ";
    for (const std::string& option : switches_of(source)) {
        text += separator + option;
        separator = " ";
    }
    return text + "\n";
}

Json source_json(const RecordedSource* recorded) {
    if (recorded == nullptr) return Json(nullptr);
    const ProgramSource& source = recorded->source;
    const bool has_sum = !is_stream(source);
    return Json{{"number", source.program},
                {"name", text_from_field(source.name)},
                {"is_stream", is_stream(source)},
                {"bytes", has_sum ? Json(source.text_bytes) : Json(nullptr)},
                {"xxh3", has_sum ? Json(hash_text(source.text_sum)) : Json(nullptr)},
                {"records_taken", recorded->taken},
                {"options", switches_of(source)}};
}

}  // namespace psicarve::cli
