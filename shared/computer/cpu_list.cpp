// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/computer/cpu_list.hpp"

#include <algorithm>
#include <charconv>

namespace psicarve {
namespace {

constexpr int kMostCpus = 8192;  // no kernel is built for more

std::optional<int> number_from(std::string_view text) {
    int number = -1;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const bool is_whole = error == std::errc{} && end == text.data() + text.size();
    if (!is_whole || number < 0 || number >= kMostCpus) return std::nullopt;
    return number;
}

std::string_view without_space(std::string_view text) {
    constexpr std::string_view kSpace = " \t\n";
    const std::size_t first = text.find_first_not_of(kSpace);
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(kSpace) - first + 1);
}

}  // namespace

std::optional<std::vector<int>> cpus_from_list(std::string_view text) {
    std::vector<int> cpus;
    text = without_space(text);
    while (!text.empty()) {
        const std::size_t comma = text.find(',');
        const std::string_view range = text.substr(0, comma);
        text = comma == std::string_view::npos ? std::string_view{} : text.substr(comma + 1);
        const std::size_t dash = range.find('-');
        const auto first = number_from(range.substr(0, dash));
        const auto last = dash == std::string_view::npos ? first : number_from(range.substr(dash + 1));
        if (!first || !last || *last < *first) return std::nullopt;
        for (int cpu = *first; cpu <= *last; ++cpu) cpus.push_back(cpu);
    }
    std::ranges::sort(cpus);
    cpus.erase(std::unique(cpus.begin(), cpus.end()), cpus.end());
    return cpus;
}

}  // namespace psicarve
