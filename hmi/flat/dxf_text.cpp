// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/flat/dxf_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "hmi/model/text_scan.hpp"
#include "shared/base/result.hpp"
#include "shared/base/trimmed.hpp"

namespace psicarve::flat {
namespace {

constexpr std::size_t kMostGroups = 4'000'000;  // of one element

bool is_real_code(int code) noexcept {
    return (code >= 10 && code <= 59) || (code >= 110 && code <= 149) || (code >= 210 && code <= 239);
}
bool is_whole_code(int code) noexcept {
    return (code >= 60 && code <= 79) || (code >= 90 && code <= 99) || (code >= 170 && code <= 179);
}

}  // namespace

std::string_view DxfElement::text(int code, std::string_view otherwise) const noexcept {
    const auto found =
        std::find_if(groups.begin(), groups.end(), [code](const DxfGroup& g) { return g.code == code; });
    return found == groups.end() ? otherwise : found->value;
}

double DxfElement::number(int code, double otherwise) const noexcept {
    const std::string_view value = text(code);
    return value.empty() ? otherwise : model::number(value).value_or(otherwise);
}

int DxfElement::whole(int code, int otherwise) const noexcept {
    const std::string_view value = text(code);
    const auto number = value.empty() ? std::nullopt : model::whole_number(value);
    return number && *number >= -1'000'000'000 && *number <= 1'000'000'000 ? static_cast<int>(*number)
                                                                           : otherwise;
}

Error DxfText::wrong(std::size_t line, const std::string& what) const {
    return bad_input(file_ + " line " + std::to_string(line) + ": " + what);
}

bool DxfText::take_line(std::string_view& out) noexcept {
    if (position_ >= text_.size()) return false;
    const std::size_t end = std::min(text_.find('\n', position_), text_.size());
    out = trimmed(text_.substr(position_, end - position_));
    position_ = std::min(end + 1, text_.size());
    ++line_;
    return true;
}

/// False at the end of the text.
Result<bool> DxfText::take_group(DxfGroup& out) {
    std::string_view code;
    if (!take_line(code)) return false;
    const auto number = model::whole_number(code);
    if (!number || *number < -5 || *number > 1071) {
        return wrong(line_ - 1, model::quoted(code) + " is no group code");
    }
    if (!take_line(out.value)) return false;
    out.code = static_cast<int>(*number);
    out.line = line_ - 1;
    if (is_real_code(out.code)) {
        const auto value = model::number(out.value);
        if (!value || !std::isfinite(*value))
            return wrong(out.line, model::quoted(out.value) + " is not a number");
    } else if (is_whole_code(out.code) && !model::whole_number(out.value)) {
        return wrong(out.line, model::quoted(out.value) + " is not a whole number");
    }
    return true;
}

Result<void> DxfText::next(DxfElement& out) {
    out.groups.clear();
    out.begin = position_;
    out.line = line_;
    DxfGroup group;
    bool has_type = false;
    while (true) {
        const std::size_t position = position_;
        const std::size_t line = line_;
        const auto taken = take_group(group);
        if (!taken) return taken.error();
        if (!*taken) {
            if (has_type && out.type == "EOF") return {};
            return wrong(line_, "the file ends too early: there is no EOF");
        }
        if (group.code == 0 && has_type) {
            go_to(position, line);
            return {};
        }
        if (group.code == 0) {
            out.type = group.value;
            out.begin = position;
            out.line = line;
            has_type = true;
            if (out.type == "EOF") return {};
        } else if (has_type) {
            if (out.groups.size() >= kMostGroups)
                return wrong(line, "more than four million values in one element");
            out.groups.push_back(group);
        } else if (group.code != 999) {  // comments may stand before the first element
            return wrong(line, "this is no DXF file: it does not begin with a section");
        }
    }
}

}  // namespace psicarve::flat
