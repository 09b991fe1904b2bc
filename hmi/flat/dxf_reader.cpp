// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/flat/dxf_reader.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hmi/flat/drawing.hpp"
#include "hmi/flat/dxf_shapes.hpp"
#include "hmi/flat/dxf_text.hpp"
#include "hmi/model/text_scan.hpp"
#include "shared/base/result.hpp"
#include "shared/base/units.hpp"

namespace psicarve::flat {
namespace {

constexpr std::uint64_t kMostWalkedBytes = std::uint64_t{1} << 29U;
constexpr std::size_t kMostElements = 1'000'000;  // drawn, those of blocks each time
constexpr int kDeepestInsert = 16;
constexpr std::size_t kMostNamedTypes = 8;

/// mm of $INSUNITS; 0 where it names no length.
double mm_of_units(int units) noexcept {
    constexpr std::array<double, 15> kMm{0.0,     25.4,   304.8, 1'609'344.0, 1.0,  10.0, 1000.0, 1e6,
                                         2.54e-5, 0.0254, 914.4, 1e-7,        1e-6, 1e-3, 100.0};
    return units > 0 && units < static_cast<int>(kMm.size()) ? kMm[static_cast<std::size_t>(units)] : 0.0;
}

/// Names of blocks and layers ignore case (in ASCII, as programs differ in other letters).
struct NameOrder {
    using is_transparent = void;
    bool operator()(std::string_view a, std::string_view b) const noexcept {
        const auto small = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
        return std::lexicographical_compare(
            a.begin(), a.end(), b.begin(), b.end(),
            [&small](char one, char other) { return small(one) < small(other); });
    }
};

struct Place {
    std::size_t position = 0;
    std::size_t line = 1;
};

struct Block {
    Place begin;
    Point base;
};

class DxfDrawer {
public:
    DxfDrawer(std::string_view text, const std::string& file) : text_(text, file), file_(file) {}

    Result<Drawing> draw(double scale) {
        if (auto done = survey(); !done) return done.error();
        const double mm = mm_of_units(units_);
        if (mm == 0.0) warnings_.insert("the drawing does not say its units: they are taken as millimetres");
        const double factor = scale * (mm == 0.0 ? 1.0 : mm);
        if (has_entities_) {
            if (auto done = entities(entities_, {factor, 0.0, 0.0, factor, 0.0, 0.0}, "0", 0); !done) {
                return done.error();
            }
        }
        if (auto good = maker_.check(file_); !good) return good.error();
        tell_of_types();
        Drawing drawing;
        drawing.format = "DXF";
        drawing.paths = maker_.take();
        drawing.warnings.assign(warnings_.begin(), warnings_.end());
        return drawing;
    }

private:
    /// Reads the whole file once: units, layers, places of blocks and entities. A file that passes is
    /// well-formed.
    Result<void> survey() {
        DxfElement element;
        std::string_view section;
        while (true) {
            if (auto done = text_.next(element); !done) return done;
            if (element.type == "EOF") return {};
            if (element.type == "SECTION") {
                section = element.text(2);
                if (section == "HEADER") read_header(element);
                if (section == "ENTITIES") {
                    entities_ = here();
                    has_entities_ = true;
                }
            } else if (element.type == "LAYER") {
                const bool is_frozen = (element.whole(70, 0) & 1) != 0;
                if (is_frozen || element.whole(62, 7) < 0)
                    hidden_layers_.insert_or_assign(std::string(element.text(2)), is_frozen);
            } else if (element.type == "BLOCK" && section == "BLOCKS") {
                blocks_.emplace(element.text(2), Block{here(), element.point(10)});
            }
        }
    }

    /// Where the next element begins.
    Place here() const { return {text_.position(), text_.line()}; }

    void read_header(const DxfElement& element) {
        std::string_view variable;
        for (const DxfGroup& group : element.groups) {
            if (group.code == 9) variable = group.value;
            const DxfElement one{{}, 0, 0, {group}};
            if (group.code == 70 && variable == "$INSUNITS") units_ = one.whole(70, 0);
        }
    }

    bool is_shown(const DxfElement& element, std::string_view layer) const {
        if (element.whole(60, 0) != 0 || element.whole(67, 0) != 0) return false;
        const auto hidden = hidden_layers_.find(layer);
        if (hidden == hidden_layers_.end()) return true;
        // In a block that is inserted on a layer that is off, entities with a layer of their own are visible.
        return element.type == "INSERT" && !hidden->second;
    }

    /// From a place to the end of its block or section.
    Result<void> entities(Place from, const Affine& placement, std::string_view block_layer, int depth) {
        text_.go_to(from.position, from.line);
        DxfElement element;
        while (!maker_.is_over()) {
            if (auto done = text_.next(element); !done) return done;
            if (element.type == "ENDBLK" || element.type == "ENDSEC" || element.type == "EOF") return {};
            if (++drawn_ > kMostElements)
                return bad_input(file_ + ": its blocks draw more than a million elements");
            std::string_view layer = element.text(8, "0");
            if (layer == "0") layer = block_layer;  // the layer on which the block is inserted
            const bool shown = is_shown(element, layer);
            if (element.type == "SEQEND") continue;  // of an INSERT's attributes
            if (element.type == "POLYLINE") {
                if (auto done = polyline(element, placement, shown); !done) return done;
            } else if (shown && element.type == "INSERT") {
                const Place next = here();
                if (auto done = insert(element, placement, layer, depth); !done) return done;
                text_.go_to(next.position, next.line);
            } else if (shown && element.type == "SPLINE") {
                const bool has_control_points = !element.text(10).empty() || element.text(11).empty();
                const auto draw = has_control_points ? draw_dxf_spline : draw_dxf_fit_spline;
                if (!draw(element, placement, maker_)) {
                    warnings_.insert("line " + std::to_string(element.line) +
                                     ": a SPLINE whose knots and points do not belong together is left out");
                }
            } else if (shown && !draw_dxf_shape(element, placement, maker_)) {
                left_out_.insert(std::string(element.type));
            }
        }
        return {};
    }

    /// A POLYLINE's vertices are elements of their own, up to SEQEND.
    Result<void> polyline(const DxfElement& head, const Affine& placement, bool is_drawn) {
        const int flags = head.whole(70, 0);
        const bool is_mesh = (flags & (16 | 64)) != 0;
        const bool is_in_space = (flags & 8) != 0;
        const Affine plane = is_in_space ? placement : after(placement, dxf_plane(head));
        std::vector<DxfVertex> vertices;
        DxfElement vertex;
        while (true) {
            const Place next = here();
            if (auto done = text_.next(vertex); !done) return done;
            if (vertex.type == "SEQEND") break;
            if (vertex.type != "VERTEX") {
                text_.go_to(next.position, next.line);
                break;
            }
            const bool is_control_point = (vertex.whole(70, 0) & 16) != 0;
            if (!is_control_point)
                vertices.push_back({vertex.point(10), is_in_space ? 0.0 : vertex.number(42, 0.0)});
        }
        if (!is_drawn) return {};
        if (is_mesh) {
            left_out_.insert("POLYLINE mesh");
            return {};
        }
        maker_.place(plane);
        draw_bulges(vertices, (flags & 1) != 0, maker_);
        return {};
    }

    Result<void> insert(const DxfElement& element, const Affine& placement, std::string_view layer,
                        int depth) {
        const auto block = blocks_.find(element.text(2));
        // A missing block on a layer that is off needs no warning.
        if (block == blocks_.end() && hidden_layers_.contains(layer)) return {};
        if (block == blocks_.end() || depth >= kDeepestInsert) {
            warnings_.insert("line " + std::to_string(element.line) +
                             ": INSERT of a block that is not there" +
                             (depth >= kDeepestInsert ? " or holds itself" : "") + " is left out");
            return {};
        }
        const double turn_rad = rad_from_deg(element.number(50, 0.0));
        const double cosine = std::cos(turn_rad);
        const double sine = std::sin(turn_rad);
        const Point at = element.point(10);
        const double x_scale = element.number(41, 1.0);
        const double y_scale = element.number(42, 1.0);
        const Affine plane = after(placement, dxf_plane(element));
        const Affine turned{cosine, sine, -sine, cosine, at.x, at.y};
        const int columns = std::max(element.whole(70, 1), 1);
        const int rows = std::max(element.whole(71, 1), 1);
        for (int row = 0; row < rows && !maker_.is_over(); ++row) {
            for (int column = 0; column < columns && !maker_.is_over(); ++column) {
                // Copies stand along the turned axes; an empty block must not be walked forever either.
                if (++drawn_ > kMostElements) {
                    return bad_input(file_ + ": its blocks draw more than a million elements");
                }
                const Affine shifted{x_scale,
                                     0.0,
                                     0.0,
                                     y_scale,
                                     column * element.number(44, 0.0) - x_scale * block->second.base.x,
                                     row * element.number(45, 0.0) - y_scale * block->second.base.y};
                const Affine whole = after(plane, after(turned, shifted));
                if (auto done = entities(block->second.begin, whole, layer, depth + 1); !done) return done;
                // Invisible blocks are walked, too, each time.
                walked_bytes_ += text_.position() - block->second.begin.position;
                if (walked_bytes_ > kMostWalkedBytes)
                    return bad_input(file_ + ": its blocks draw more than half a gigabyte of text");
            }
        }
        return {};
    }

    void tell_of_types() {
        if (left_out_.empty()) return;
        std::string names;
        std::size_t count = 0;
        for (const std::string& type : left_out_) {
            if (++count > kMostNamedTypes) break;
            names += (names.empty() ? "" : ", ") + shown_name(type);
        }
        warnings_.insert("left out, as they are no lines: " + names +
                         (count > kMostNamedTypes ? ", ..." : ""));
    }
    static std::string shown_name(const std::string& type);

    DxfText text_;
    std::string file_;
    PathMaker maker_;
    std::map<std::string, Block, NameOrder> blocks_;
    std::map<std::string, bool, NameOrder> hidden_layers_;  ///< frozen, or only off
    std::set<std::string> left_out_;
    std::set<std::string> warnings_;
    Place entities_;
    bool has_entities_ = false;
    int units_ = 0;
    std::size_t drawn_ = 0;
    std::uint64_t walked_bytes_ = 0;  ///< of blocks, in all their copies
};

/// A type's name, which is foreign text.
std::string DxfDrawer::shown_name(const std::string& type) {
    std::string shown = type.substr(0, 20);
    for (char& c : shown) c = c < ' ' || c > '~' ? '?' : c;
    return shown;
}

}  // namespace

Result<Drawing> read_dxf(std::string_view text, const std::string& file, double scale) {
    text = model::without_byte_order_mark(text);
    if (text.starts_with("AutoCAD Binary DXF")) {
        return bad_input(file + ": a binary DXF drawing; save it as text (ASCII DXF)");
    }
    return DxfDrawer(text, file).draw(scale);
}

}  // namespace psicarve::flat
