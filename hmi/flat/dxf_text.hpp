// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hmi/flat/drawing.hpp"
#include "shared/base/result.hpp"

namespace psicarve::flat {

/// A pair of lines of a DXF file: the code, which gives the value's meaning, and the value.
struct DxfGroup {
    int code = 0;
    std::string_view value;
    std::size_t line = 0;  ///< of the value
};

/// One element: its type and the groups up to the next.
struct DxfElement {
    std::string_view type;
    std::size_t begin = 0;  ///< of its first line in the text
    std::size_t line = 0;
    std::vector<DxfGroup> groups;

    /// The first of that code; `otherwise` where there is none.
    std::string_view text(int code, std::string_view otherwise = {}) const noexcept;
    double number(int code, double otherwise) const noexcept;
    int whole(int code, int otherwise) const noexcept;
    Point point(int x_code) const noexcept { return {number(x_code, 0.0), number(x_code + 10, 0.0)}; }
};

/// Walks through the elements of an ASCII DXF file. Checks every group as it is read: Autodesk's table of
/// group codes says which values a code may have.
class DxfText {
public:
    DxfText(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

    /// Continues from here; `line` is the number of the line that begins there, from 1.
    void go_to(std::size_t position, std::size_t line) noexcept {
        position_ = position;
        line_ = line;
    }
    /// The next element. Refuses a file that ends without its EOF, and invalid groups.
    Result<void> next(DxfElement& out);
    std::size_t position() const noexcept { return position_; }
    std::size_t line() const noexcept { return line_; }
    Error wrong(std::size_t line, const std::string& what) const;

private:
    bool take_line(std::string_view& out) noexcept;
    Result<bool> take_group(DxfGroup& out);

    std::string_view text_;
    std::string file_;
    std::size_t position_ = 0;
    std::size_t line_ = 1;
};

}  // namespace psicarve::flat
