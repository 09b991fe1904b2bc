// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/kept_text.hpp"

#include <algorithm>

namespace psicarve::gcode {

void KeptText::begin(std::uint64_t offset) {
    const bool goes_on = !pieces_.empty() && pieces_.back().offset + pieces_.back().text.size() == offset;
    if (!goes_on) pieces_.push_back({offset, 0, {}});
}

void KeptText::append(std::uint64_t offset, std::string_view line) {
    begin(offset);
    bytes_ += line.size() + 1;
    if (bytes_ > kMostBytes) has_overflowed_ = true;
    if (has_overflowed_) return;
    pieces_.back().text += line;
    pieces_.back().text += '\n';
}

void KeptText::drop() {
    if (pieces_.empty()) return;
    Piece& last = pieces_.back();
    bytes_ -= last.text.size() - last.kept_bytes;
    last.text.resize(last.kept_bytes);
    if (last.text.empty()) pieces_.pop_back();
}

void KeptText::keep_for_good() {
    if (!pieces_.empty()) pieces_.back().kept_bytes = pieces_.back().text.size();
}

const KeptText::Piece* KeptText::piece_at(std::uint64_t offset) const noexcept {
    const auto after =
        std::upper_bound(pieces_.begin(), pieces_.end(), offset,
                         [](std::uint64_t wanted, const Piece& piece) { return wanted < piece.offset; });
    if (after == pieces_.begin()) return nullptr;
    const Piece& piece = *(after - 1);
    return offset - piece.offset < piece.text.size() ? &piece : nullptr;
}

std::string_view KeptText::line_at(std::uint64_t offset) const noexcept {
    const Piece& piece = *piece_at(offset);
    const std::size_t at = offset - piece.offset;
    return std::string_view{piece.text}.substr(at, piece.text.find('\n', at) - at);
}

}  // namespace psicarve::gcode
