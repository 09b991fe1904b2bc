// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/cli/number_argument.hpp"

#include <charconv>
#include <cmath>

namespace psicarve::cli {

Result<double> number_argument(const std::string& name, const std::string& text) {
    double value = 0.0;
    const char* first = text.data();
    const char* const last = first + text.size();
    if (first != last && *first == '+') ++first;
    const auto [end, error] = std::from_chars(first, last, value);
    if (error == std::errc{} && end == last && std::isfinite(value)) return value;
    return Error{ErrorCode::bad_usage, name + ": '" + text + "' is not a number"};
}

}  // namespace psicarve::cli
