// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/profile/toml_edit.hpp"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "shared/profile_text.hpp"
#include "shared/trimmed.hpp"

namespace psicarve::profile {
namespace {

std::vector<std::string> lines_of(std::string_view text) {
    std::vector<std::string> lines;
    while (!text.empty()) {
        const std::size_t end = text.find('\n');
        lines.emplace_back(text.substr(0, end));
        text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    }
    return lines;
}

/// Where a comment begins, or the line's end; '#' within strings is none.
std::size_t comment_of(std::string_view line) {
    char quote = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (quote == '"' && c == '\\') {
            ++i;
        } else if (quote != 0) {
            if (c == quote) quote = 0;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '#') {
            return i;
        }
    }
    return line.size();
}

/// "axis.r1" of "[axis.r1]  # the left one"; nothing of other lines.
std::string_view header_of(std::string_view line) {
    const std::string_view code = trimmed(line.substr(0, comment_of(line)));
    if (code.size() < 2 || code.front() != '[' || code.back() != ']') return {};
    return trimmed(code.substr(1, code.size() - 2));
}

std::string_view key_of(std::string_view line) {
    const std::size_t equals = line.substr(0, comment_of(line)).find('=');
    return equals == std::string_view::npos ? std::string_view{} : trimmed(line.substr(0, equals));
}

void set_value(std::string& line, std::string_view toml) {
    const std::size_t comment = comment_of(line);
    const std::string remark = line.substr(comment);
    line.resize(line.find('=') + 1);
    line += ' ';
    line += toml;
    if (remark.empty()) return;
    // Comments below one another stay so.
    line.resize(std::max(line.size() + 1, comment), ' ');
    line += remark;
}

/// A profile's lines, and where a key stands in them.
struct Place {
    std::vector<std::string> lines;
    std::size_t line = 0;  ///< of the key; else the one before which it belongs
    bool is_there = false;
    bool has_table = false;
};

Place place_of(std::string_view text, std::string_view path) {
    Place place;
    place.lines = lines_of(text);
    const std::string_view table = table_of_key(path);
    const std::string_view leaf = leaf_of_key(path);
    place.has_table = table.empty();
    std::string_view present;
    for (std::size_t i = 0; i < place.lines.size(); ++i) {
        const std::string_view header = header_of(place.lines[i]);
        if (!header.empty()) present = header;
        const std::string_view key = header.empty() ? key_of(place.lines[i]) : std::string_view{};
        if (!key.empty() && (present == table ? key == leaf : present.empty() && key == path)) {
            place.line = i;
            place.is_there = true;
            break;
        }
        if (present != table) continue;
        place.has_table = true;
        if (!header.empty() || !key.empty()) place.line = i + 1;
    }
    return place;
}

}  // namespace

std::string with_value(std::string_view text, std::string_view path, std::string_view toml) {
    Place place = place_of(text, path);
    std::vector<std::string>& lines = place.lines;
    if (place.is_there) {
        set_value(lines[place.line], toml);
    } else {
        if (!place.has_table) {
            if (!lines.empty() && !trimmed(lines.back()).empty()) lines.emplace_back();
            lines.push_back("[" + std::string(table_of_key(path)) + "]");
            place.line = lines.size();
        }
        lines.insert(lines.begin() + static_cast<std::ptrdiff_t>(place.line),
                     std::string(leaf_of_key(path)) + " = " + std::string(toml));
    }
    std::string result;
    for (const std::string& line : lines) result += line + "\n";
    return result;
}

std::optional<std::string> value_in(std::string_view text, std::string_view path) {
    const Place place = place_of(text, path);
    if (!place.is_there) return std::nullopt;
    const std::string_view line = place.lines[place.line];
    const std::size_t begin = line.find('=') + 1;
    return std::string(trimmed(line.substr(begin, comment_of(line) - begin)));
}

}  // namespace psicarve::profile
