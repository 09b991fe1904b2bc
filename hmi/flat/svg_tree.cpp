// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/flat/svg_tree.hpp"

#include <expat.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "shared/base/result.hpp"

namespace psicarve::flat {
namespace {

constexpr std::size_t kMostNodes = 1'000'000;
constexpr std::size_t kDeepestElement = 200;
constexpr std::size_t kPieceBytes = std::size_t{1} << 20U;
constexpr std::size_t kLongestStyleBytes = std::size_t{1} << 20U;
constexpr std::string_view kSvgSpace = "http://www.w3.org/2000/svg";
constexpr std::string_view kXlinkHref = "http://www.w3.org/1999/xlink href";

struct ParserFree {
    void operator()(XML_Parser parser) const noexcept { XML_ParserFree(parser); }
};

/// Feeds the text to Expat and keeps the elements. C functions call the handlers, so these throw nothing.
/// Expat stops entities that multiply (since 2.4).
class TreeWalk {
public:
    explicit TreeWalk(std::string file) : file_(std::move(file)) {
        if (parser_ == nullptr) throw std::bad_alloc();
        XML_SetUserData(parser_.get(), this);
        XML_SetElementHandler(parser_.get(), on_begin, on_end);
        XML_SetCharacterDataHandler(parser_.get(), on_text);
    }

    Result<SvgTree> walk(std::string_view text) {
        bool is_last = false;
        do {
            const std::string_view piece = text.substr(0, kPieceBytes);
            text.remove_prefix(piece.size());
            is_last = text.empty();
            const auto status =
                XML_Parse(parser_.get(), piece.data(), static_cast<int>(piece.size()), is_last ? 1 : 0);
            if (is_out_of_memory_) throw std::bad_alloc();
            if (refusal_ != nullptr) return wrong(refusal_);
            if (status == XML_STATUS_OK) continue;
            const auto error = XML_GetErrorCode(parser_.get());
            if (error == XML_ERROR_NO_MEMORY) throw std::bad_alloc();
            const bool is_cut = error == XML_ERROR_NO_ELEMENTS || error == XML_ERROR_UNCLOSED_TOKEN ||
                                error == XML_ERROR_UNCLOSED_CDATA_SECTION || error == XML_ERROR_PARTIAL_CHAR;
            return wrong(is_cut && is_last ? "the XML ends too early" : "this is not well-formed XML");
        } while (!is_last);
        if (tree_.elements.empty()) return wrong("there is no <svg> element");
        return std::move(tree_);
    }

private:
    Error wrong(const std::string& what) const {
        return bad_input(file_ + " line " + std::to_string(XML_GetCurrentLineNumber(parser_.get())) + ": " +
                         what);
    }
    void refuse(const char* what) noexcept {
        refusal_ = what;
        XML_StopParser(parser_.get(), XML_FALSE);
    }

    /// The name without its name space; empty where it is not SVG's.
    static std::string_view svg_name(std::string_view full) noexcept {
        const std::size_t gap = full.rfind(' ');
        if (gap == std::string_view::npos) return full;  // files without any name space are read as well
        return full.substr(0, gap) == kSvgSpace ? full.substr(gap + 1) : std::string_view{};
    }

    void begin(std::string_view full, const XML_Char** attributes) {
        if (open_.size() >= kDeepestElement) return refuse("elements stand in each other more than 200 deep");
        if (tree_.elements.size() >= kMostNodes) return refuse("more than a million elements");
        const std::string_view name = svg_name(full);
        if (open_.empty() && name != "svg") return refuse("the first element is not <svg>");
        const std::size_t index = tree_.elements.size();
        SvgElement element;
        element.name = name;
        element.line = XML_GetCurrentLineNumber(parser_.get());
        // An element that is not SVG is kept without content, so that its end finds it.
        for (const XML_Char** pair = attributes; *pair != nullptr && !name.empty(); pair += 2) {
            const std::string_view key = *pair == kXlinkHref ? "href" : std::string_view(*pair);
            if (key.find(' ') == std::string_view::npos) element.attributes.emplace_back(key, pair[1]);
        }
        const std::string_view id = element.get("id");
        if (!id.empty()) tree_.by_id.emplace(id, index);
        if (!open_.empty() && !name.empty()) tree_.elements[open_.back()].children.push_back(index);
        tree_.elements.push_back(std::move(element));
        open_.push_back(index);
    }

    static void on_begin(void* self, const XML_Char* name, const XML_Char** attributes) noexcept {
        auto& walk = *static_cast<TreeWalk*>(self);
        if (walk.refusal_ != nullptr || walk.is_out_of_memory_) return;
        try {
            walk.begin(name, attributes);
        } catch (const std::bad_alloc&) {
            walk.is_out_of_memory_ = true;
            XML_StopParser(walk.parser_.get(), XML_FALSE);
        }
    }
    static void on_end(void* self, const XML_Char* /*name*/) noexcept {
        auto& walk = *static_cast<TreeWalk*>(self);
        if (!walk.open_.empty()) walk.open_.pop_back();
    }
    static void on_text(void* self, const XML_Char* text, int length) noexcept {
        auto& walk = *static_cast<TreeWalk*>(self);
        if (walk.open_.empty() || walk.tree_.elements[walk.open_.back()].name != "style") return;
        if (walk.tree_.style_sheet.size() >= kLongestStyleBytes) return;
        try {
            walk.tree_.style_sheet.append(text, static_cast<std::size_t>(length));
        } catch (const std::bad_alloc&) {
            walk.is_out_of_memory_ = true;
            XML_StopParser(walk.parser_.get(), XML_FALSE);
        }
    }

    std::unique_ptr<std::remove_pointer_t<XML_Parser>, ParserFree> parser_{XML_ParserCreateNS(nullptr, ' ')};
    std::string file_;
    SvgTree tree_;
    std::vector<std::size_t> open_;
    const char* refusal_ = nullptr;
    bool is_out_of_memory_ = false;
};

}  // namespace

std::string_view SvgElement::get(std::string_view attribute) const noexcept {
    const auto found = std::find_if(attributes.begin(), attributes.end(),
                                    [attribute](const auto& pair) { return pair.first == attribute; });
    return found == attributes.end() ? std::string_view{} : std::string_view(found->second);
}

Result<SvgTree> read_svg_tree(std::string_view text, const std::string& file) {
    return TreeWalk(file).walk(text);
}

}  // namespace psicarve::flat
