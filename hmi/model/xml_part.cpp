// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/model/xml_part.hpp"

#include <expat.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "hmi/model/text_scan.hpp"
#include "hmi/model/zip_archive.hpp"
#include "shared/base/result.hpp"

namespace psicarve::model {
namespace {

// Nested elements, and tags and comments as long as a file, take more memory and time than their text.
constexpr int kDeepestElement = 100;
constexpr std::int64_t kLongestTokenBytes = std::int64_t{1} << 20U;
constexpr std::size_t kShownPartName = 80;

struct ParserFree {
    void operator()(XML_Parser parser) const noexcept { XML_ParserFree(parser); }
};
using ParserOwner = std::unique_ptr<std::remove_pointer_t<XML_Parser>, ParserFree>;

/// Feeds one part to Expat. C functions call the handlers, so these throw nothing.
class XmlWalk {
public:
    XmlWalk(const ElementTaker& take, std::string where) : take_(take), where_(std::move(where)) {
        if (parser_ == nullptr) throw std::bad_alloc();
        XML_SetUserData(parser_.get(), this);
        XML_SetElementHandler(parser_.get(), on_element, on_element_end);
        XML_SetStartDoctypeDeclHandler(parser_.get(), on_doctype);
    }

    Result<void> parse(std::string_view piece, bool is_last) {
        const auto status =
            XML_Parse(parser_.get(), piece.data(), static_cast<int>(piece.size()), is_last ? 1 : 0);
        given_bytes_ += static_cast<std::int64_t>(piece.size());
        if (is_out_of_memory_) throw std::bad_alloc();
        if (refusal_) return wrong(refusal_->message);
        if (status == XML_STATUS_OK) return check_token_length();
        const auto error = XML_GetErrorCode(parser_.get());
        if (error == XML_ERROR_NO_MEMORY) throw std::bad_alloc();
        const bool is_cut = is_last || error == XML_ERROR_NO_ELEMENTS;
        return wrong(is_cut ? "the XML ends too early" : "this is not well-formed XML");
    }

private:
    Error wrong(const std::string& what) const {
        return bad_input(where_ + std::to_string(XML_GetCurrentLineNumber(parser_.get())) + ": " + what);
    }

    /// The bytes that Expat keeps back belong to a tag or a comment that has not ended yet.
    Result<void> check_token_length() const {
        const std::int64_t done_bytes = XML_GetCurrentByteIndex(parser_.get());
        if (given_bytes_ - done_bytes <= kLongestTokenBytes) return {};
        return wrong("a tag or comment of more than a megabyte");
    }

    void refuse(const char* what) noexcept {
        try {
            refusal_ = bad_input(what);
        } catch (const std::bad_alloc&) {
            is_out_of_memory_ = true;
        }
        XML_StopParser(parser_.get(), XML_FALSE);
    }

    void begin_element(const XML_Char* full_name, const XML_Char** attributes) noexcept {
        if (refusal_ || is_out_of_memory_) return;
        if (++depth_ > kDeepestElement) return refuse("elements stand in each other more than 100 deep");
        const std::string_view full = full_name;
        const std::size_t gap = full.rfind(' ');
        const std::string_view space = gap == std::string_view::npos ? "" : full.substr(0, gap);
        const std::string_view name = gap == std::string_view::npos ? full : full.substr(gap + 1);
        try {
            if (auto done = take_(space, name, XmlAttributes(attributes)); !done) refusal_ = done.error();
        } catch (const std::bad_alloc&) {
            is_out_of_memory_ = true;
        }
        if (refusal_ || is_out_of_memory_) XML_StopParser(parser_.get(), XML_FALSE);
    }

    static void on_element(void* walk, const XML_Char* name, const XML_Char** attributes) noexcept {
        static_cast<XmlWalk*>(walk)->begin_element(name, attributes);
    }
    static void on_element_end(void* walk, const XML_Char* /*name*/) noexcept {
        --static_cast<XmlWalk*>(walk)->depth_;
    }
    /// Entities that multiply are declared there; 3MF allows none of it.
    static void on_doctype(void* walk, const XML_Char* /*name*/, const XML_Char* /*system*/,
                           const XML_Char* /*public*/, int /*has_subset*/) noexcept {
        static_cast<XmlWalk*>(walk)->refuse("a document type declaration, which 3MF does not allow");
    }

    ParserOwner parser_{XML_ParserCreateNS(nullptr, ' ')};
    const ElementTaker& take_;
    std::string where_;
    std::optional<Error> refusal_;
    bool is_out_of_memory_ = false;
    int depth_ = 0;
    std::int64_t given_bytes_ = 0;
};

}  // namespace

std::optional<std::string_view> XmlAttributes::find(std::string_view name) const noexcept {
    for (const char** pair = pairs_; *pair != nullptr; pair += 2) {
        if (name == *pair) return pair[1];
    }
    return std::nullopt;
}

Result<void> read_xml(ZipArchive& archive, const std::string& part, const ElementTaker& take) {
    XmlWalk walk(take, archive.file() + ": " + quoted(part, kShownPartName) + " line ");
    const auto done = archive.read(part, [&](std::string_view piece) { return walk.parse(piece, false); });
    if (!done) return done;
    return walk.parse("", true);
}

}  // namespace psicarve::model
