// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cctype>
#include <cstddef>
#include <string>
#include <string_view>

namespace psicarve::test {

/// A text as the name of a parameter: googletest takes letters, digits and underscores.
inline std::string parameter_name(std::string_view text) {
    std::string name;
    for (const char c : text.substr(0, 60)) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0) {
            name += c;
        } else if (!name.empty() && name.back() != '_') {
            name += '_';
        }
    }
    return name;
}
/// For texts that may come out alike: the name starts with the text's number.
inline std::string parameter_name(std::string_view text, std::size_t index) {
    return std::to_string(index) + "_" + parameter_name(text);
}

}  // namespace psicarve::test
