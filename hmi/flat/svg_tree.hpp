// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "shared/base/result.hpp"

namespace psicarve::flat {

/// One element of an SVG file: only elements that can be drawn, none of other name spaces.
struct SvgElement {
    std::string name;
    std::vector<std::pair<std::string, std::string>> attributes;  ///< xlink:href as "href"
    std::vector<std::size_t> children;                            ///< in SvgTree::elements
    std::size_t line = 0;

    /// Empty where there is none.
    std::string_view get(std::string_view attribute) const noexcept;
};

/// An SVG file's elements; the first is the root.
struct SvgTree {
    std::vector<SvgElement> elements;
    std::map<std::string, std::size_t, std::less<>> by_id;
    std::string style_sheet;  ///< all <style> elements, one after another
};

/// Refuses a text that is not well-formed, not SVG, or cut short: "FILE line N: ...". At most a million
/// elements, 200 deep.
Result<SvgTree> read_svg_tree(std::string_view text, const std::string& file);

}  // namespace psicarve::flat
