// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/flat/svg_style.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "hmi/model/text_scan.hpp"
#include "shared/base/trimmed.hpp"

namespace psicarve::flat {
namespace {

constexpr std::size_t kMostRules = 5000;  // each may be asked of each element
constexpr std::array<std::string_view, kSvgPropertyCount> kNames{"display",
                                                                 "visibility",
                                                                 "fill",
                                                                 "stroke",
                                                                 "stroke-width",
                                                                 "stroke-dasharray",
                                                                 "stroke-dashoffset",
                                                                 "transform",
                                                                 "transform-origin",
                                                                 "transform-box",
                                                                 "clip-path",
                                                                 "mask",
                                                                 "mask-image",
                                                                 "overflow",
                                                                 "opacity",
                                                                 "fill-opacity",
                                                                 "stroke-opacity"};

// An attribute has rank 0. Later rules of the same weight win.
constexpr std::uint64_t kElementRank = std::uint64_t{1} << 32U;
constexpr std::uint64_t kClassRank = std::uint64_t{1} << 34U;
constexpr std::uint64_t kMostClasses = 1023;
constexpr std::uint64_t kIdRank = std::uint64_t{1} << 48U;
constexpr std::uint64_t kInlineRank = std::uint64_t{1} << 52U;
constexpr std::uint64_t kImportantRank = std::uint64_t{1} << 56U;

/// Takes the part before the separator off the text.
std::string_view take_until(std::string_view& text, char separator) noexcept {
    const std::size_t end = text.find(separator);
    const std::string_view part = text.substr(0, end);
    text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
    return trimmed(part);
}

std::string without_comments(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const std::size_t begin = text.find("/*");
        out.append(text.substr(0, begin)).append(" ");
        const std::size_t end = begin == std::string_view::npos ? begin : text.find("*/", begin + 2);
        text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 2);
    }
    // The marks that hid style sheets from very old browsers.
    for (const std::string_view mark : {"<!--", "-->"}) {
        for (std::size_t at = out.find(mark); at != std::string::npos; at = out.find(mark, at))
            out.replace(at, mark.size(), " ");
    }
    return out;
}

std::optional<SvgProperty> property_of(std::string_view name) noexcept {
    const auto found = std::find(kNames.begin(), kNames.end(), name);
    if (found == kNames.end()) return std::nullopt;
    return static_cast<SvgProperty>(found - kNames.begin());
}

/// Takes a name off the front; empty where there is none.
std::string_view take_name(std::string_view& text) noexcept {
    const auto is_of_name = [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte >= 0x80U || c == '-' || c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') ||
               (c >= 'A' && c <= 'Z');
    };
    const auto end = std::find_if_not(text.begin(), text.end(), is_of_name);
    const std::string_view name = text.substr(0, static_cast<std::size_t>(end - text.begin()));
    text.remove_prefix(name.size());
    return name;
}

bool has_class(const SvgElement& element, std::string_view wanted) noexcept {
    std::string_view classes = element.get("class");
    while (!(classes = trimmed(classes)).empty()) {
        const std::size_t end = std::min(classes.find_first_of(kGaps), classes.size());
        if (classes.substr(0, end) == wanted) return true;
        classes.remove_prefix(end);
    }
    return false;
}

}  // namespace

void SvgStyle::set(SvgProperty property, std::string_view value, std::uint64_t rank) noexcept {
    const auto at = static_cast<std::size_t>(property);
    if (rank < ranks_[at]) return;
    ranks_[at] = rank;
    values_[at] = value;
}

SvgStyles::SvgStyles(std::string_view sheet) : sheet_(without_comments(sheet)) {
    read_sheet();
}

void SvgStyles::read_sheet() {
    std::string_view rest = sheet_;
    while (!(rest = trimmed(rest)).empty()) {
        if (rest.front() == '@') {
            skip_at_rule(rest);
            continue;
        }
        const std::string_view selectors = take_until(rest, '{');
        add(selectors, take_until(rest, '}'));
    }
}

std::vector<SvgStyles::Declaration> SvgStyles::declarations_in(std::string_view text) {
    std::vector<Declaration> found;
    while (!text.empty()) {
        std::string_view one = take_until(text, ';');
        const auto property = property_of(take_until(one, ':'));
        if (!property) continue;
        const std::size_t mark = one.find('!');
        const bool is_important =
            mark != std::string_view::npos && trimmed(one.substr(mark + 1)) == "important";
        found.push_back({*property, trimmed(one.substr(0, mark)), is_important});
    }
    return found;
}

/// False where the selector is of another kind.
bool SvgStyles::read_selector(std::string_view text, Rule& rule) {
    if (text.empty()) return false;
    if (text.front() == '*') {
        text.remove_prefix(1);
    } else {
        rule.element = take_name(text);
    }
    rule.rank = rule.element.empty() ? 1 : kElementRank;
    while (!text.empty()) {
        const char mark = text.front();
        text.remove_prefix(1);
        const std::string_view name = take_name(text);
        if (name.empty() || (mark != '.' && mark != '#') || (mark == '#' && !rule.id.empty())) return false;
        if (mark == '#') rule.id = name;
        if (mark == '.') rule.classes.push_back(name);
    }
    rule.rank += kClassRank * std::min<std::uint64_t>(rule.classes.size(), kMostClasses);
    if (!rule.id.empty()) rule.rank += kIdRank;
    return true;
}

void SvgStyles::add(std::string_view selectors, std::string_view declarations) {
    const auto said = declarations_in(declarations);
    if (said.empty()) return;
    const std::size_t first = declarations_.size();
    declarations_.insert(declarations_.end(), said.begin(), said.end());
    while (!selectors.empty()) {
        const std::string_view selector = take_until(selectors, ',');
        Rule rule;
        if (rules_.size() >= kMostRules || !read_selector(selector, rule)) {
            note_unread(selector);
            continue;
        }
        rule.first = first;
        rule.end = declarations_.size();
        rule.rank += rules_.size();
        Index& index = !rule.id.empty() ? by_id_ : rule.classes.empty() ? by_element_ : by_class_;
        const std::string_view key = !rule.id.empty()       ? rule.id
                                     : rule.classes.empty() ? rule.element
                                                            : rule.classes.front();
        index[key].push_back(rules_.size());
        rules_.push_back(std::move(rule));
    }
}

/// A rule that does not concern lines is not reported.
void SvgStyles::skip_at_rule(std::string_view& sheet) {
    const std::string_view name = sheet.substr(0, sheet.find_first_of(" \t\r\n\f{;(\""));
    const std::size_t end = sheet.find_first_of("{;");
    std::size_t after = end == std::string_view::npos ? sheet.size() : end + 1;
    if (end != std::string_view::npos && sheet[end] == '{') {
        int depth = 1;
        for (; after < sheet.size() && depth > 0; ++after) {
            if (sheet[after] == '{') ++depth;
            if (sheet[after] == '}') --depth;
        }
    }
    sheet.remove_prefix(after);
    const bool is_harmless = name == "@charset" || name == "@font-face" || name == "@namespace" ||
                             name == "@page" || name.find("keyframes") != std::string_view::npos;
    if (!is_harmless) note_unread(name);
}

void SvgStyles::note_unread(std::string_view selector) {
    constexpr std::size_t kMostShown = 40;
    if (first_unread_.empty()) first_unread_ = model::quoted(selector, kMostShown);
}

void SvgStyles::apply(const Index& index, std::string_view key, const SvgElement& element,
                      SvgStyle& style) const {
    const auto found = index.find(key);
    if (found == index.end()) return;
    for (const std::size_t number : found->second) {
        const Rule& rule = rules_[number];
        if (!rule.element.empty() && rule.element != element.name) continue;
        if (!rule.id.empty() && rule.id != element.get("id")) continue;
        if (!std::all_of(rule.classes.begin(), rule.classes.end(),
                         [&element](std::string_view one) { return has_class(element, one); })) {
            continue;
        }
        for (std::size_t i = rule.first; i < rule.end; ++i) {
            const Declaration& said = declarations_[i];
            style.set(said.property, said.value, rule.rank + (said.is_important ? kImportantRank : 0));
        }
    }
}

SvgStyle SvgStyles::of(const SvgElement& element) const {
    SvgStyle style;
    for (const auto& [name, value] : element.attributes) {
        if (const auto property = property_of(name)) style.set(*property, trimmed(value), 0);
    }
    for (const Declaration& said : declarations_in(element.get("style"))) {
        style.set(said.property, said.value, kInlineRank + (said.is_important ? kImportantRank : 0));
    }
    if (rules_.empty()) return style;
    apply(by_element_, {}, element, style);
    apply(by_element_, element.name, element, style);
    if (const auto id = element.get("id"); !id.empty()) apply(by_id_, id, element, style);
    std::string_view classes = by_class_.empty() ? std::string_view{} : element.get("class");
    while (!(classes = trimmed(classes)).empty()) {
        const std::size_t end = std::min(classes.find_first_of(kGaps), classes.size());
        apply(by_class_, classes.substr(0, end), element, style);
        classes.remove_prefix(end);
    }
    return style;
}

}  // namespace psicarve::flat
