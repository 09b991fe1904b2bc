// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/model/xml_part.hpp"

#include <expat.h>

#include <memory>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "hmi/model/zip_archive.hpp"
#include "shared/result.hpp"

namespace psicarve::model {
namespace {

struct ParserFree {
    void operator()(XML_Parser parser) const noexcept { XML_ParserFree(parser); }
};
using ParserOwner = std::unique_ptr<std::remove_pointer_t<XML_Parser>, ParserFree>;

struct Walk {
    XML_Parser parser;
    const ElementTaker& take;
    std::optional<Error> refusal;
    bool out_of_memory = false;
};

// Between C functions: nothing may be thrown through it.
void on_element(void* user_data, const XML_Char* full_name, const XML_Char** attributes) noexcept {
    Walk& walk = *static_cast<Walk*>(user_data);
    const std::string_view full = full_name;
    const std::size_t gap = full.rfind(' ');
    const std::string_view space = gap == std::string_view::npos ? "" : full.substr(0, gap);
    const std::string_view name = gap == std::string_view::npos ? full : full.substr(gap + 1);
    try {
        if (auto done = walk.take(space, name, XmlAttributes(attributes)); !done) walk.refusal = done.error();
    } catch (const std::bad_alloc&) {
        walk.out_of_memory = true;
    }
    if (walk.refusal || walk.out_of_memory) XML_StopParser(walk.parser, XML_FALSE);
}

}  // namespace

std::optional<std::string_view> XmlAttributes::find(std::string_view name) const noexcept {
    for (const char** pair = pairs_; *pair != nullptr; pair += 2) {
        if (name == *pair) return pair[1];
    }
    return std::nullopt;
}

Result<void> read_xml(const ZipArchive& archive, const std::string& part, const ElementTaker& take) {
    const ParserOwner parser(XML_ParserCreateNS(nullptr, ' '));
    if (parser == nullptr) throw std::bad_alloc();
    Walk walk{parser.get(), take, {}, false};
    XML_SetUserData(parser.get(), &walk);
    XML_SetStartElementHandler(parser.get(), on_element);
    const auto where = [&] {
        return archive.file() + ": " + part + " line " +
               std::to_string(XML_GetCurrentLineNumber(parser.get())) + ": ";
    };
    const auto parse = [&](std::string_view piece, bool is_last) -> Result<void> {
        const auto status =
            XML_Parse(parser.get(), piece.data(), static_cast<int>(piece.size()), is_last ? 1 : 0);
        if (walk.out_of_memory) throw std::bad_alloc();
        if (walk.refusal) return Error{walk.refusal->code, where() + walk.refusal->message};
        if (status == XML_STATUS_OK) return {};
        const bool is_cut = is_last || XML_GetErrorCode(parser.get()) == XML_ERROR_NO_ELEMENTS;
        return bad_input(where() + (is_cut ? "the XML ends too early" : "this is not well-formed XML"));
    };
    const auto done = archive.read(part, [&](std::string_view piece) { return parse(piece, false); });
    if (!done) return done;
    return parse("", true);
}

}  // namespace psicarve::model
