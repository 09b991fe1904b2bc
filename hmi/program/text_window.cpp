// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/program/text_window.hpp"

#include <algorithm>
#include <utility>

namespace psicarve::program {
namespace {

/// Read on both sides of what is wanted, so that scrolling seldom has to wait.
constexpr std::uint64_t kMargin = 512;

}  // namespace

void TextWindow::show(const DecodedPointer& program) {
    if (program == program_) return;
    program_ = program;
    lines_.clear();
    failure_.reset();
    work_ = {};
    read_wanted();
}

void TextWindow::want(std::uint64_t first, std::uint64_t count) {
    wanted_ = {std::max<std::uint64_t>(first, 1), count};
    read_wanted();
}

bool TextWindow::has(const Range& range) const noexcept {
    if (!program_) return true;
    const std::uint64_t end = std::min(range.first + range.count, program_->lines.line_count() + 1);
    return range.first >= end || (range.first >= first_ && end <= first_ + lines_.size());
}

void TextWindow::read_wanted() {
    if (has(wanted_) || failure_ || work_.is_under_way()) return;
    read_first_ = wanted_.first > kMargin ? wanted_.first - kMargin : 1;
    const std::uint64_t count = wanted_.first + wanted_.count + kMargin - read_first_;
    work_.begin([program = program_, first = read_first_, count]() -> Lines {
        return read_lines(program->request.path, program->state, program->lines, first, count);
    });
}

bool TextWindow::poll() {
    auto read = work_.take();
    if (!read) return false;
    if (*read) {
        first_ = read_first_;
        lines_ = std::move(*read).value();
        // A file that has become shorter is a changed one; never asked for again and again.
        if (lines_.empty()) failure_ = bad_input("");
    } else {
        failure_ = read->error();
    }
    read_wanted();
    return true;
}

const std::string* TextWindow::line(std::uint64_t number) const noexcept {
    if (number < first_ || number - first_ >= lines_.size()) return nullptr;
    return &lines_[number - first_];
}

}  // namespace psicarve::program
