// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "hmi/flat/svg_tree.hpp"

namespace psicarve::flat {

/// The style properties that decide about lines.
enum class SvgProperty : std::uint8_t {
    display,
    visibility,
    fill,
    stroke,
    stroke_width,
    stroke_dasharray,
    stroke_dashoffset,
    transform,
    transform_origin,
    transform_box,
    clip_path,
    mask,
    mask_image,
    overflow,
    opacity,
    fill_opacity,
    stroke_opacity
};
inline constexpr std::size_t kSvgPropertyCount = 17;

/// The style of one element; its values are views of the style sheet and of the element's text.
class SvgStyle {
public:
    /// Empty where the property is not set.
    std::string_view operator[](SvgProperty property) const noexcept {
        return values_[static_cast<std::size_t>(property)];
    }
    /// Keeps the value with the highest rank, of equal ones the last.
    void set(SvgProperty property, std::string_view value, std::uint64_t rank) noexcept;

private:
    std::array<std::string_view, kSvgPropertyCount> values_;
    std::array<std::uint64_t, kSvgPropertyCount> ranks_{};
};

/// The cascade of an SVG file: attributes, the rules of <style>, style="...". Follows the rules whose
/// selector is a name, classes and an id of one element (`rect`, `.a`, `rect.a.b`, `#c`, `*`, lists of
/// these).
class SvgStyles {
public:
    explicit SvgStyles(std::string_view sheet);
    SvgStyles(const SvgStyles&) = delete;
    SvgStyles& operator=(const SvgStyles&) = delete;

    SvgStyle of(const SvgElement& element) const;
    /// The selector of the first rule that is not followed and sets one of these properties, in quotes; empty
    /// when all are followed.
    const std::string& first_unread() const noexcept { return first_unread_; }

private:
    struct Declaration {
        SvgProperty property;
        std::string_view value;
        bool is_important;
    };
    struct Rule {
        std::string_view element;  ///< empty: any
        std::string_view id;       ///< empty: any
        std::vector<std::string_view> classes;
        std::size_t first = 0;  ///< in declarations_
        std::size_t end = 0;
        std::uint64_t rank = 0;
    };
    using Index = std::unordered_map<std::string_view, std::vector<std::size_t>>;

    static std::vector<Declaration> declarations_in(std::string_view text);
    static bool read_selector(std::string_view text, Rule& rule);
    void read_sheet();
    void add(std::string_view selectors, std::string_view declarations);
    void skip_at_rule(std::string_view& sheet);
    void note_unread(std::string_view selector);
    void apply(const Index& index, std::string_view key, const SvgElement& element, SvgStyle& style) const;

    std::string sheet_;  ///< without comments
    std::vector<Declaration> declarations_;
    std::vector<Rule> rules_;
    Index by_id_;
    Index by_class_;
    Index by_element_;  ///< "": any
    std::string first_unread_;
};

}  // namespace psicarve::flat
