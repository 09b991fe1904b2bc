// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/report/program_origin.hpp"

#include <array>
#include <cstring>
#include <string_view>
#include <utility>

#include "shared/base/printable.hpp"

namespace psicarve::report {

OriginKind kind_of(const ProgramOrigin& origin) noexcept {
    if ((origin.flags & kSourceIsStream) != 0) return OriginKind::stream;
    return (origin.flags & kSourceIsTyped) != 0 ? OriginKind::typed : OriginKind::file;
}

std::string file_name_of(const ProgramOrigin& origin) {
    const char* const begin = static_cast<const char*>(origin.name);
    std::string_view path{begin, ::strnlen(begin, sizeof origin.name)};
    path.remove_prefix(path.find_last_of('/') + 1);  // npos + 1 is 0
    if (path.empty()) return "?";
    std::string name;
    // One line, whatever a file is called: printable() leaves line feeds and tabs as they are.
    for (const char letter : path) {
        if (letter == '\n' || letter == '\t') {
            name += letter == '\n' ? "\\u000a" : "\\u0009";
        } else {
            name += letter;
        }
    }
    return printable(name);
}

std::string origin_text(const ProgramOrigin& origin) {
    switch (kind_of(origin)) {
        case OriginKind::stream:
            return "standard input";
        case OriginKind::typed:
            return "a typed block";
        case OriginKind::file:
            break;
    }
    return file_name_of(origin);
}

std::vector<std::string> switch_names(const ProgramStatus& status, const ProgramOrigin* origin) {
    std::vector<std::string> names;
    if (status.is_single != 0) names.emplace_back("single block");
    if (status.stops_at_optional != 0) names.emplace_back("optional stop");
    if (origin == nullptr) return names;
    constexpr std::array<std::pair<std::uint32_t, const char*>, 3> kAsRead{
        {{kSourceSkipsDeleted, "block delete"}, {kSourceIsDry, "dry run"}, {kSourceIsIso, "ISO dialect"}}};
    for (const auto& [flag, name] : kAsRead)
        if ((origin->flags & flag) != 0) names.emplace_back(name);
    if (origin->from_line > 1) names.push_back("from line " + std::to_string(origin->from_line));
    return names;
}

}  // namespace psicarve::report
