// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/program/line_index.hpp"

#include <algorithm>
#include <cstring>
#include <fstream>

namespace psicarve::program {
namespace {

constexpr std::size_t kReadBytes = std::size_t{1} << 16U;

/// Cuts bytes into lines, those before the first wanted one only counted.
class LineCutter {
public:
    LineCutter(std::uint64_t line, std::uint64_t first, std::uint64_t count)
        : line_(line), first_(first), count_(count) {}

    /// False: all wanted lines are there.
    bool take(std::span<const char> bytes) {
        for (std::span<const char> rest = bytes; !rest.empty();) {
            if (lines_.size() == count_) return false;
            const void* const found = std::memchr(rest.data(), '\n', rest.size());
            const std::size_t length =
                found == nullptr ? rest.size()
                                 : static_cast<std::size_t>(static_cast<const char*>(found) - rest.data());
            if (line_ >= first_) append({rest.data(), length});
            if (found == nullptr) return true;
            end_line();
            rest = rest.subspan(length + 1);
        }
        return lines_.size() < count_;
    }
    std::vector<std::string> finished() {
        if (has_some_ && lines_.size() < count_) end_line();
        return std::move(lines_);
    }

private:
    void append(std::string_view piece) {
        has_some_ = true;
        const std::size_t room = kMostShownBytes - std::min(kMostShownBytes, text_.size());
        text_.append(piece.substr(0, room));
    }
    void end_line() {
        if (line_++ < first_) return;
        if (!text_.empty() && text_.back() == '\r') text_.pop_back();
        lines_.push_back(std::move(text_));
        text_.clear();
        has_some_ = false;
    }

    std::uint64_t line_;
    std::uint64_t first_;
    std::uint64_t count_;
    std::string text_;
    bool has_some_ = false;
    std::vector<std::string> lines_;
};

Error changed_program(const std::string& path) {
    return bad_input(path + ": has been changed since it was read");
}

}  // namespace

void LineIndex::note(std::span<const char> bytes) {
    std::size_t at = 0;
    while (at < bytes.size()) {
        const void* const found = std::memchr(bytes.data() + at, '\n', bytes.size() - at);
        if (found == nullptr) break;
        at = static_cast<std::size_t>(static_cast<const char*>(found) - bytes.data()) + 1;
        ++ended_lines_;
        if (ended_lines_ % stride_ == 0) mark(bytes_ + at);
    }
    if (!bytes.empty()) is_within_line_ = bytes.back() != '\n';
    bytes_ += bytes.size();
}

void LineIndex::mark(std::uint64_t offset_bytes) {
    if (marks_.size() == kMostMarks) {
        for (std::size_t i = 0; 2 * i < marks_.size(); ++i) marks_[i] = marks_[2 * i];
        marks_.resize((marks_.size() + 1) / 2);
        stride_ *= 2;
        if (ended_lines_ % stride_ != 0) return;
    }
    marks_.push_back(offset_bytes);
}

std::uint64_t LineIndex::line_count() const noexcept {
    return ended_lines_ + (is_within_line_ ? 1 : 0);
}

LineIndex::Mark LineIndex::before(std::uint64_t line) const noexcept {
    const std::uint64_t wanted = line == 0 ? 0 : (line - 1) / stride_;
    const std::uint64_t which = std::min<std::uint64_t>(wanted, marks_.size() - 1);
    return {which * stride_ + 1, marks_[which]};
}

Result<std::vector<std::string>> read_lines(const std::string& path, const gcode::FileState& state,
                                            const LineIndex& index, std::uint64_t first,
                                            std::uint64_t count) {
    const LineIndex::Mark mark = index.before(first);
    std::ifstream file{path, std::ios::binary};
    file.seekg(static_cast<std::streamoff>(mark.offset_bytes));
    if (!file) return bad_input(path + ": cannot be read");
    LineCutter lines{mark.line, first, count};
    std::vector<char> buffer(kReadBytes);
    bool wants_more = count > 0;
    while (wants_more && file) {
        file.read(buffer.data(), static_cast<std::streamsize>(buffer.size()));
        wants_more = lines.take({buffer.data(), static_cast<std::size_t>(file.gcount())});
    }
    // Afterwards: what was read before a change is what was there.
    const auto now = gcode::state_of_program(path);
    if (!now) return now.error();
    if (*now != state) return changed_program(path);
    return lines.finished();
}

}  // namespace psicarve::program
