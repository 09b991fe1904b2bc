// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/gcode/end_words.hpp"

#include <algorithm>

namespace psicarve::gcode {

bool names_end(std::string_view line) noexcept {
    bool is_code = false;
    int number = 0;
    for (std::size_t i = 0; i <= line.size(); ++i) {
        const char byte = i < line.size() ? line[i] : '\n';
        if (byte == ' ' || byte == '\t') continue;
        if (is_code && byte >= '0' && byte <= '9') {
            number = std::min(number * 10 + (byte - '0'), 1000);
            continue;
        }
        if (is_code && (number == 2 || number == 30)) return true;
        is_code = byte == 'M' || byte == 'm';
        number = 0;
    }
    return false;
}

}  // namespace psicarve::gcode
