// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cam/number_lines.hpp"

#include <algorithm>
#include <cmath>

#include "hmi/model/text_scan.hpp"
#include "shared/base/trimmed.hpp"

namespace psicarve::cam {

NumberLines::NumberLines(std::string_view text, const std::string& file)
    : text_(model::without_byte_order_mark(text)), file_(file) {}

std::string_view NumberLines::line() {
    while (!text_.empty()) {
        const std::size_t end = text_.find('\n');
        const std::string_view taken = trimmed(text_.substr(0, end));
        text_ = end == std::string_view::npos ? std::string_view{} : text_.substr(end + 1);
        ++number_;
        if (!taken.empty() && taken.front() != '#') return taken;
    }
    return {};
}

Result<bool> NumberLines::numbers(std::vector<double>& out, double farthest) {
    out.clear();
    std::string_view rest = line();
    if (rest.empty()) return false;
    while (!rest.empty()) {
        const std::size_t end = rest.find_first_of(separators_);
        std::string word(trimmed(rest.substr(0, end)));
        if (separators_.find(',') == std::string_view::npos) std::replace(word.begin(), word.end(), ',', '.');
        rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
        if (word.empty() && trimmed(rest).empty()) break;  // a comma at the line's end
        const auto value = model::number(word);
        if (!value || !(std::abs(*value) <= farthest)) {
            return wrong(model::quoted(word) + " is not a number that a table can hold");
        }
        out.push_back(*value);
    }
    return true;
}

Error NumberLines::wrong(const std::string& what) const {
    return bad_input(file_ + " line " + std::to_string(number_) + ": " + what);
}

std::string table_place(const std::string& path, std::size_t layer, std::size_t point) {
    return path + ": layer " + std::to_string(layer) + ", point " + std::to_string(point) + ": ";
}

}  // namespace psicarve::cam
