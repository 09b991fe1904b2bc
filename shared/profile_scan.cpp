// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "shared/profile_table.hpp"

namespace psicarve::profile_detail {
namespace {

/// Walks TOML only as far as to tell strings and comments from the rest. Where the text is no TOML (a string
/// that its line does not end) it stops: the parser stops there too.
class Scanner {
public:
    explicit Scanner(std::string_view text) : text_(text) {}

    std::optional<std::int64_t> first_foreign_line() {
        if (text_.starts_with("\xEF\xBB\xBF")) at_ = 3;  // byte order mark
        while (at_ < text_.size() && !ended_) {
            const char c = text_[at_];
            if (is_foreign(c)) return line_;
            if (c == '#') {
                at_ = std::min(text_.find('\n', at_), text_.size());
            } else if (c == '"' || c == '\'') {
                if (skip_string(c)) return line_;
            } else {
                step();
            }
        }
        return std::nullopt;
    }

private:
    static bool is_foreign(char c) noexcept { return static_cast<unsigned char>(c) >= 0x80; }
    void step() noexcept {
        if (text_[at_] == '\n') ++line_;
        ++at_;
    }
    bool three_quotes(char quote) const { return text_.substr(at_, 3) == std::string(3, quote); }

    /// True when a foreign character stands where none may.
    bool skip_string(char quote) {
        const bool many_lines = three_quotes(quote);
        at_ += many_lines ? 3 : 1;
        while (at_ < text_.size()) {
            const char c = text_[at_];
            if (many_lines && is_foreign(c)) return true;
            if (!many_lines && c == '\n') {
                ended_ = true;
                return false;
            }
            if (c == quote && (!many_lines || three_quotes(quote))) {
                at_ += many_lines ? 3 : 1;
                // Up to two quotes more belong to the text of a string of several lines.
                for (int i = 0; many_lines && i < 2 && at_ < text_.size() && text_[at_] == quote; ++i) ++at_;
                return false;
            }
            if (quote == '"' && c == '\\' && at_ + 1 < text_.size()) step();
            step();
        }
        return false;
    }

    std::string_view text_;
    std::size_t at_ = 0;
    std::int64_t line_ = 1;
    bool ended_ = false;
};

}  // namespace

std::optional<std::int64_t> first_foreign_line(std::string_view text) {
    return Scanner(text).first_foreign_line();
}

}  // namespace psicarve::profile_detail
