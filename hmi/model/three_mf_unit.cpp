// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/model/three_mf_unit.hpp"

#include <minizip/unzip.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string_view>

namespace psicarve::model {
namespace {

constexpr std::size_t kHeadBytes = 16384;  ///< a model's root element stands at its beginning

struct ZipCloser {
    void operator()(void* zip) const noexcept { unzClose(zip); }
};
using Zip = std::unique_ptr<void, ZipCloser>;

/// The beginning of the first entry whose name ends in ".model".
std::string model_head(void* zip) {
    for (int found = unzGoToFirstFile(zip); found == UNZ_OK; found = unzGoToNextFile(zip)) {
        std::array<char, 1024> name{};
        const auto room = static_cast<uLong>(name.size() - 1);
        if (unzGetCurrentFileInfo64(zip, nullptr, name.data(), room, nullptr, 0, nullptr, 0) != UNZ_OK) break;
        if (!std::string_view(name.data()).ends_with(".model")) continue;
        if (unzOpenCurrentFile(zip) != UNZ_OK) break;
        std::string head(kHeadBytes, '\0');
        const int got = unzReadCurrentFile(zip, head.data(), static_cast<unsigned>(head.size()));
        unzCloseCurrentFile(zip);
        head.resize(static_cast<std::size_t>(std::max(got, 0)));
        return head;
    }
    return {};
}

/// The value of `unit` in <model ... unit="inch" ...>; empty where there is none.
std::string unit_word(std::string_view xml) {
    const std::size_t begin = xml.find("<model");
    if (begin == std::string_view::npos) return {};
    xml = xml.substr(begin, xml.find('>', begin) - begin);
    for (const std::string_view start : {" unit=\"", " unit='"}) {
        const std::size_t at = xml.find(start);
        if (at == std::string_view::npos) continue;
        xml.remove_prefix(at + start.size());
        return std::string(xml.substr(0, xml.find(start.back())));
    }
    return {};
}

}  // namespace

ThreeMfUnit three_mf_unit(const std::string& path) {
    const std::array<ThreeMfUnit, 5> units{
        {{"micron", 1e-3}, {"centimeter", 10.0}, {"inch", 25.4}, {"foot", 304.8}, {"meter", 1e3}}};
    const Zip zip{unzOpen(path.c_str())};
    if (!zip) return {};
    const std::string word = unit_word(model_head(zip.get()));
    const auto* const unit =
        std::find_if(units.begin(), units.end(), [&](const auto& u) { return u.name == word; });
    return unit == units.end() ? ThreeMfUnit{} : *unit;
}

}  // namespace psicarve::model
