// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/profile/text_places.hpp"

#include <algorithm>

namespace psicarve::profile {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool continues_code_point(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

}  // namespace

TextPlaces::TextPlaces(std::string_view text)
    : text_{text}, begins_{text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0} {
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '\n') begins_.push_back(i + 1);
}

std::size_t TextPlaces::offset_of(std::size_t line, std::size_t column) const {
    if (line == 0 || line > begins_.size()) return text_.size();
    std::size_t offset = begins_[line - 1];
    for (; column > 1 && offset < text_.size(); --column) {
        ++offset;
        while (offset < text_.size() && continues_code_point(text_[offset])) ++offset;
    }
    return offset;
}

std::size_t TextPlaces::line_begin(std::size_t offset) const {
    return *(std::upper_bound(begins_.begin() + 1, begins_.end(), offset) - 1);
}

std::size_t TextPlaces::line_end(std::size_t offset) const {
    const auto next = std::upper_bound(begins_.begin() + 1, begins_.end(), offset);
    return next == begins_.end() ? text_.size() : *next;
}

std::string_view TextPlaces::newline() const {
    const std::size_t end = text_.find('\n');
    return end != std::string_view::npos && end > 0 && text_[end - 1] == '\r' ? "\r\n" : "\n";
}

}  // namespace psicarve::profile
