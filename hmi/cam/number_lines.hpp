// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "shared/base/result.hpp"

namespace psicarve::cam {

/// Lines of numbers between commas or semicolons; skips empty lines and those that begin with '#'. Where the
/// head has semicolons or tabs, these alone separate numbers, and a comma is the decimal mark, as
/// spreadsheets of half of Europe write. The text outlives this.
class NumberLines {
public:
    NumberLines(std::string_view text, const std::string& file);

    /// The next line as it stands; empty at the end.
    std::string_view line();
    void part_by(char separator) { separators_ = separator == ',' ? ",;" : separator == ';' ? ";" : "\t"; }
    /// mm or pulses: far beyond every machine, and safe to calculate with.
    static constexpr double kFarthest = 1e9;
    /// False at the end. Refuses what is no number, or is further from 0 than `farthest`.
    Result<bool> numbers(std::vector<double>& out, double farthest = kFarthest);
    /// An error that names the line read last.
    Error wrong(const std::string& what) const;

private:
    std::string_view text_;
    std::string file_;
    std::string_view separators_ = ",;";
    std::size_t number_ = 0;
};

/// "FILE: layer 3, point 4: ".
std::string table_place(const std::string& path, std::size_t layer, std::size_t point);

}  // namespace psicarve::cam
