// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/model/foreign_file.hpp"

#include <array>
#include <cstddef>
#include <string_view>

namespace psicarve::model {
namespace {

using namespace std::string_view_literals;

struct ForeignKind {
    std::size_t place;
    std::string_view magic;
    std::string_view what;
};

constexpr std::array kForeignKinds{
    ForeignKind{0, "\x1F\x8B"sv, "a packed file (gzip), as SVGZ is; unpack it first"sv},
    ForeignKind{0, "GIF8"sv, "a GIF picture, which is not read; save it as PNG"sv},
    ForeignKind{8, "WEBP"sv, "a WebP picture, which is not read; save it as PNG"sv},
    ForeignKind{4, "ftypheic"sv, "a HEIC picture, which is not read; save it as PNG"sv},
    ForeignKind{4, "ftypmif1"sv, "a HEIF picture, which is not read; save it as PNG"sv},
    ForeignKind{4, "ftypavif"sv, "an AVIF picture, which is not read; save it as PNG"sv},
    ForeignKind{0, "8BPS"sv, "a Photoshop picture, which is not read; save it as PNG"sv},
    ForeignKind{0, "%PDF"sv, "a PDF drawing, which is not read; save it as SVG"sv},
    ForeignKind{0, "%!PS"sv, "a PostScript drawing, which is not read; save it as SVG"sv},
    ForeignKind{0, "AC10"sv, "a DWG drawing, which is not read; save it as DXF"sv},
    ForeignKind{0, "ISO-10303-21"sv, "a STEP model, which is not read; save it as STL or 3MF"sv},
    ForeignKind{0, "glTF"sv, "a glTF model, which is not read; save it as STL or 3MF"sv},
    ForeignKind{0, "Kaydara FBX"sv, "an FBX model, which is not read; save it as STL or 3MF"sv},
    ForeignKind{0, "BLENDER"sv, "a Blender model, which is not read; save it as STL or 3MF"sv},
};

}  // namespace

std::string_view foreign_kind(std::string_view head) noexcept {
    for (const ForeignKind& kind : kForeignKinds) {
        if (head.size() >= kind.place && head.substr(kind.place, kind.magic.size()) == kind.magic)
            return kind.what;
    }
    return {};
}

std::string why_not_read(std::string_view head) {
    if (const auto foreign = foreign_kind(head); !foreign.empty()) return std::string(foreign);
    return "nothing that can be read here: a mesh (STL, OBJ, PLY, 3MF, OFF), a drawing (SVG, DXF), a picture "
           "(PNG, "
           "JPEG, TIFF, BMP, PGM) or a table (CSV)";
}

}  // namespace psicarve::model
