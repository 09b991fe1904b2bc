// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/flat/svg_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hmi/flat/drawing.hpp"
#include "hmi/flat/svg_frame.hpp"
#include "hmi/flat/svg_shapes.hpp"
#include "hmi/flat/svg_style.hpp"
#include "hmi/flat/svg_tree.hpp"
#include "hmi/flat/svg_values.hpp"
#include "shared/base/result.hpp"

namespace psicarve::flat {
namespace {

// A few <use> in each other can draw more than the file is long; a loop of them never ends.
constexpr std::size_t kMostVisits = 2'000'000;
constexpr int kDeepestUse = 16;
constexpr double kUsualSide = 100.0;  // of a viewport that says nothing at all

struct Inherited {
    Affine placement;
    SvgViewport viewport;
    const SvgFrame* frame = nullptr;
    bool is_filled = true;
    bool is_stroked = false;
    bool is_fill_clear = false;
    bool is_stroke_clear = false;
    double stroke_width = 1.0;   ///< user units
    std::vector<double> dashes;  ///< user units
    double dash_offset = 0.0;
    bool is_visible = true;
    int use_depth = 0;
};

/// Places a viewBox in its viewport, as preserveAspectRatio says.
Affine fitted(const std::array<double, 4>& box, const SvgViewport& port, std::string_view aspect) {
    double x_factor = port.width / box[2];
    double y_factor = port.height / box[3];
    double x_share = 0.5;
    double y_share = 0.5;
    if (aspect.substr(0, 4) == "none") {
        x_share = y_share = 0.0;
    } else {
        const bool is_slice = aspect.find("slice") != std::string_view::npos;
        x_factor = y_factor = is_slice ? std::max(x_factor, y_factor) : std::min(x_factor, y_factor);
        if (aspect.find("xMin") != std::string_view::npos) x_share = 0.0;
        if (aspect.find("xMax") != std::string_view::npos) x_share = 1.0;
        if (aspect.find("YMin") != std::string_view::npos) y_share = 0.0;
        if (aspect.find("YMax") != std::string_view::npos) y_share = 1.0;
    }
    return {x_factor,
            0.0,
            0.0,
            y_factor,
            x_share * (port.width - box[2] * x_factor) - box[0] * x_factor,
            y_share * (port.height - box[3] * y_factor) - box[1] * y_factor};
}

std::optional<std::array<double, 4>> view_box(const SvgElement& element) {
    SvgNumbers numbers(element.get("viewBox"));
    std::array<double, 4> box{};
    for (double& number : box) {
        const auto value = numbers.next();
        if (!value) return std::nullopt;
        number = *value;
    }
    if (!(box[2] > 0.0) || !(box[3] > 0.0)) return std::nullopt;
    return box;
}

/// A length of the whole drawing. Nothing for a percentage: only the viewer knows of what.
std::optional<double> own_length(std::string_view text) {
    const auto length = svg_length(text, std::numeric_limits<double>::quiet_NaN());
    return length && std::isnan(*length) ? std::nullopt : length;
}

class SvgDrawer {
public:
    SvgDrawer(const SvgTree& tree, std::string file)
        : tree_(tree), styles_(tree.style_sheet), file_(std::move(file)) {}

    Result<Drawing> draw(double scale) {
        const SvgElement& root = tree_.elements.front();
        const auto box = view_box(root);
        Inherited state;
        const double whole_width = box ? (*box)[2] : kUsualSide;
        const double whole_height = box ? (*box)[3] : kUsualSide;
        const auto width = own_length(root.get("width"));
        const auto height = own_length(root.get("height"));
        state.viewport.width =
            width.value_or(box && height ? *height * whole_width / whole_height : whole_width);
        state.viewport.height =
            height.value_or(box && width ? *width * whole_height / whole_width : whole_height);
        if (!(state.viewport.width > 0.0) || !(state.viewport.height > 0.0)) {
            return bad_input(file_ + ": the drawing's width or height is not more than 0");
        }
        if (!width && !height) {
            warnings_.insert("the drawing does not say how large it is: its units are taken as 1/96 inch");
        }
        const double mm = scale * kMmPerInch / kSvgUnitsPerInch;
        state.placement = {mm, 0.0, 0.0, -mm, 0.0, 0.0};
        if (const std::string& unread = styles_.first_unread(); !unread.empty()) {
            warnings_.insert("of <style> only rules for element names, .class and #id are followed, not " +
                             unread);
        }
        const bool has_page = box || width || height;
        if (take_on(root, state)) framed(root, state, has_page);
        if (const auto good = maker_.check(file_); !good) return good.error();
        if (is_too_deep_)
            return bad_input(file_ + ": its <use> elements draw more than two million elements");
        Drawing drawing;
        drawing.format = "SVG";
        drawing.paths = maker_.take();
        drawing.warnings.assign(warnings_.begin(), warnings_.end());
        return drawing;
    }

private:
    /// Nothing where the transform cannot be read.
    static std::optional<Affine> moved(const SvgStyle& style, const Inherited& state) {
        const auto own = svg_transform(style[SvgProperty::transform]);
        const std::string_view about = style[SvgProperty::transform_origin];
        const std::string_view box = style[SvgProperty::transform_box];
        if (!own) return std::nullopt;
        if (style[SvgProperty::transform].empty()) return state.placement;
        // The box of the drawn content is not known here.
        if (!box.empty() && box != "view-box") return std::nullopt;
        if (about.empty()) return after(state.placement, *own);
        const auto origin = svg_origin(about, state.viewport.width, state.viewport.height);
        if (!origin) return std::nullopt;
        const Affine there{1.0, 0.0, 0.0, 1.0, origin->x, origin->y};
        const Affine back{1.0, 0.0, 0.0, 1.0, -origin->x, -origin->y};
        return after(state.placement, after(there, after(*own, back)));
    }

    /// The inside of a viewport: its viewBox, if it has one, becomes the user units.
    static void enter(const SvgElement& element, Inherited& state) {
        const auto box = view_box(element);
        if (!box) return;
        state.placement =
            after(state.placement, fitted(*box, state.viewport, element.get("preserveAspectRatio")));
        state.viewport = {(*box)[2], (*box)[3]};
    }

    void children(const SvgElement& element, const Inherited& state) {
        for (const std::size_t child : element.children) visit(tree_.elements[child], state);
    }

    static bool is_said(std::string_view value) { return !value.empty() && value != "inherit"; }
    static bool is_drawn(std::string_view paint) { return paint != "none" && paint != "transparent"; }

    /// Nothing where it is no opacity.
    static std::optional<bool> is_clear(std::string_view opacity) {
        const auto value = SvgNumbers(opacity).next();
        return value ? std::optional<bool>(!(*value > 0.0)) : std::nullopt;
    }

    static void inherit(const SvgStyle& style, Inherited& state) {
        if (const auto fill = style[SvgProperty::fill]; is_said(fill)) state.is_filled = is_drawn(fill);
        if (const auto stroke = style[SvgProperty::stroke]; is_said(stroke))
            state.is_stroked = is_drawn(stroke);
        state.is_fill_clear = is_clear(style[SvgProperty::fill_opacity]).value_or(state.is_fill_clear);
        state.is_stroke_clear = is_clear(style[SvgProperty::stroke_opacity]).value_or(state.is_stroke_clear);
        const double whole =
            std::sqrt(0.5) * std::hypot(state.viewport.width, state.viewport.height);  // of percentages
        if (const auto width = svg_length(style[SvgProperty::stroke_width], whole))
            state.stroke_width = std::max(0.0, *width);
        if (const auto dashes = style[SvgProperty::stroke_dasharray]; is_said(dashes))
            state.dashes = svg_dashes(dashes, whole).value_or(std::vector<double>{});
        if (const auto offset = svg_length(style[SvgProperty::stroke_dashoffset], whole))
            state.dash_offset = *offset;
        if (const auto seen = style[SvgProperty::visibility]; is_said(seen))
            state.is_visible = seen == "visible";
    }

    void note_clipping(const SvgElement& element, const SvgStyle& style) {
        const auto hides = [&style](SvgProperty property) {
            return is_said(style[property]) && style[property] != "none";
        };
        if (hides(SvgProperty::clip_path) || hides(SvgProperty::mask) || hides(SvgProperty::mask_image))
            tell_of_clipping(element);
    }

    void tell_of_clipping(const SvgElement& element) {
        if (clipped_ != nullptr) return;
        clipped_ = &element;
        warnings_.insert("line " + std::to_string(element.line) + ": clipping and masks are not followed: <" +
                         element.name + "> is carved whole");
    }

    /// Notes the first viewport beyond whose edge something is visible.
    void note_edge(const Inherited& state, std::size_t first_path) {
        if (has_edge_told_) return;
        const SvgFrame* const frame = hiding_frame(state.frame, maker_.paths(), first_path);
        if (frame == nullptr || frame->element == clipped_) return;  // carved whole, as was warned
        has_edge_told_ = true;
        warnings_.insert("line " + std::to_string(frame->element->line) + ": what lies beyond the edge of <" +
                         frame->element->name + "> is carved, too");
    }

    /// Applies an element's own style; false where it is not drawn.
    bool take_on(const SvgElement& element, Inherited& state) {
        const SvgStyle style = styles_.of(element);
        // A <symbol> is drawn through <use> alone, and is visible there by standard.
        if (style[SvgProperty::display] == "none" && element.name != "symbol") return false;
        if (is_clear(style[SvgProperty::opacity]).value_or(false)) return false;
        note_clipping(element, style);
        inherit(style, state);
        const auto placement = moved(style, state);
        if (!placement) {
            warnings_.insert("line " + std::to_string(element.line) +
                             ": a transform that cannot be read; the element is left out");
            return false;
        }
        state.placement = *placement;
        return true;
    }

    void visit(const SvgElement& element, Inherited state) {
        if (++visits_ > kMostVisits) is_too_deep_ = true;
        if (is_too_deep_ || maker_.is_over() || !take_on(element, state)) return;
        const std::string& name = element.name;
        if (name == "g" || name == "a") return children(element, state);
        if (name == "switch") return first_that_fits(element, state);
        if (name == "svg") return inner_picture(element, state, {}, {});
        if (name == "use") return use(element, state);
        if (name == "text" || name == "image" || name == "foreignObject") {
            warnings_.insert("<" + name + "> is left out" +
                             (name == "text" ? ": convert text to paths in the drawing program" : ""));
            return;
        }
        if (state.is_visible) shape(element, state);
    }

    /// A reader's language and extensions are not known here: an element that asks for none fits.
    static bool fits(const SvgElement& element) {
        constexpr std::array<std::string_view, 6> kDrawNothing{"title", "desc",  "metadata",
                                                               "defs",  "style", "foreignObject"};
        const bool draws =
            std::find(kDrawNothing.begin(), kDrawNothing.end(), element.name) == kDrawNothing.end();
        return draws &&
               std::none_of(element.attributes.begin(), element.attributes.end(), [](const auto& pair) {
                   return pair.first == "systemLanguage" || pair.first == "requiredExtensions";
               });
    }

    void first_that_fits(const SvgElement& element, const Inherited& state) {
        const auto found = std::find_if(element.children.begin(), element.children.end(),
                                        [this](std::size_t child) { return fits(tree_.elements[child]); });
        if (found != element.children.end()) return visit(tree_.elements[*found], state);
        warnings_.insert("line " + std::to_string(element.line) +
                         ": <switch> holds nothing for every language and is left out");
    }

    void shape(const SvgElement& element, const Inherited& state) {
        maker_.place(state.placement);
        const bool is_filled = state.is_filled && !state.is_fill_clear && element.name != "line";
        maker_.fill(is_filled);
        const bool is_stroked = state.is_stroked && !state.is_stroke_clear;
        const Affine& to = state.placement;
        const double growth = std::sqrt(std::abs(to.a * to.d - to.b * to.c));
        const double width_mm = state.stroke_width * growth;
        maker_.stroke(is_stroked && std::isfinite(width_mm) ? width_mm : 0.0, is_filled || is_stroked);
        const std::size_t first_path = maker_.paths().size();
        const bool is_right = draw_svg_shape(element, state.viewport, maker_);
        note_edge(state, first_path);
        // A filled shape has an edge that is visible between the dashes, too.
        if (!state.dashes.empty() && is_stroked && !is_filled) dash(element, state, first_path, growth);
        if (is_right) return;
        const bool is_list = element.name == "path" || element.name.starts_with("poly");
        warnings_.insert(
            "line " + std::to_string(element.line) + ": <" + element.name +
            (is_list ? "> is not right; what follows the fault is left out" : "> is not right and left out"));
    }

    void dash(const SvgElement& element, const Inherited& state, std::size_t first_path, double growth) {
        const auto length = SvgNumbers(element.get("pathLength")).next();
        const bool is_measured = length && *length > 0.0;
        Dashes dashes{state.dashes, state.dash_offset};
        if (!is_measured) {
            for (double& one : dashes.lengths_mm) one *= growth;
            dashes.offset_mm *= growth;
        }
        maker_.dash(first_path, dashes, is_measured ? *length : 0.0);
    }

    /// An <svg> or <symbol> inside; <use> may say its size.
    void inner_picture(const SvgElement& element, Inherited state, std::string_view width,
                       std::string_view height) {
        const SvgViewport outer = state.viewport;
        if (element.name == "svg") {
            const double x = svg_length(element.get("x"), outer.width).value_or(0.0);
            const double y = svg_length(element.get("y"), outer.height).value_or(0.0);
            state.placement = after(state.placement, {1.0, 0.0, 0.0, 1.0, x, y});
        }
        const auto side = [](std::string_view first, std::string_view second, double whole) {
            const auto length = svg_length(first.empty() ? second : first, whole);
            return length.value_or(whole);
        };
        state.viewport = {side(width, element.get("width"), outer.width),
                          side(height, element.get("height"), outer.height)};
        if (!(state.viewport.width > 0.0) || !(state.viewport.height > 0.0))
            return;  // not shown, by standard
        framed(element, state, true);
    }

    /// Draws the content of a viewport.
    void framed(const SvgElement& element, Inherited state, bool has_edge) {
        const SvgFrame frame{&element, state.placement, state.viewport, state.frame};
        const SvgStyle style = styles_.of(element);
        const std::string_view overflow = style[SvgProperty::overflow];
        if (has_edge && overflow != "visible" && overflow != "auto") state.frame = &frame;
        enter(element, state);
        children(element, state);
    }

    void use(const SvgElement& element, Inherited state) {
        const std::string_view link = element.get("href");
        const auto found = link.empty() ? tree_.by_id.end() : tree_.by_id.find(link.substr(1));
        if (found == tree_.by_id.end() || link.front() != '#' || state.use_depth >= kDeepestUse) {
            warnings_.insert("line " + std::to_string(element.line) +
                             ": <use> of something that is not in this file is left out");
            return;
        }
        ++state.use_depth;
        const double x = svg_length(element.get("x"), state.viewport.width).value_or(0.0);
        const double y = svg_length(element.get("y"), state.viewport.height).value_or(0.0);
        state.placement = after(state.placement, {1.0, 0.0, 0.0, 1.0, x, y});
        const SvgElement& target = tree_.elements[found->second];
        if (target.name == "symbol" || target.name == "svg") {
            if (take_on(target, state))
                inner_picture(target, state, element.get("width"), element.get("height"));
            return;
        }
        visit(target, state);
    }

    const SvgTree& tree_;
    SvgStyles styles_;
    std::string file_;
    PathMaker maker_;
    std::set<std::string> warnings_;
    std::size_t visits_ = 0;
    bool is_too_deep_ = false;
    const SvgElement* clipped_ = nullptr;  ///< the first that something would hide a part of
    bool has_edge_told_ = false;
};

}  // namespace

Result<Drawing> read_svg(std::string_view text, const std::string& file, double scale) {
    const auto tree = read_svg_tree(text, file);
    if (!tree) return tree.error();
    return SvgDrawer(*tree, file).draw(scale);
}

}  // namespace psicarve::flat
