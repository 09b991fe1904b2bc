// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/flat/load_model.hpp"

#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <new>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "hmi/flat/drawing.hpp"
#include "hmi/flat/dxf_reader.hpp"
#include "hmi/flat/engraved_body.hpp"
#include "hmi/flat/grey_image.hpp"
#include "hmi/flat/grooves.hpp"
#include "hmi/flat/outline.hpp"
#include "hmi/flat/prism.hpp"
#include "hmi/flat/relief.hpp"
#include "hmi/flat/svg_reader.hpp"
#include "hmi/model/file_bytes.hpp"
#include "hmi/model/foreign_file.hpp"
#include "hmi/model/load_mesh.hpp"
#include "hmi/model/source_name.hpp"
#include "hmi/model/text_scan.hpp"

namespace psicarve::flat {
namespace {

constexpr std::size_t kHeadBytes = 4096;
constexpr std::uint64_t kMostBytes = std::uint64_t{512} << 20U;

enum class Format : std::uint8_t { other, svg, dxf, image };

std::string extension_of(const std::string& path) {
    std::string extension = std::filesystem::path(path).extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
}

bool begins_as_dxf(std::string_view head) {
    if (head.substr(0, 18) == "AutoCAD Binary DXF") return true;
    model::Words words(head);
    if (words.next() != "0") return false;
    return words.next() == "SECTION";
}

Format format_of(std::string_view head, const std::string& path) {
    if (image_format({reinterpret_cast<const unsigned char*>(head.data()), head.size()}) !=
        ImageFormat::none) {
        return Format::image;
    }
    head = model::without_byte_order_mark(head);
    head.remove_prefix(std::min(head.find_first_not_of(" \t\r\n"), head.size()));
    if (!head.empty() && head.front() == '<' && head.find("<svg") != std::string_view::npos)
        return Format::svg;
    if (begins_as_dxf(head)) return Format::dxf;
    // A packed file, or another program's, is recognised by its content, whatever its name.
    if (!model::foreign_kind(head).empty()) return Format::other;
    // A damaged file is still of its kind: the reader reports the fault.
    const std::string extension = extension_of(path);
    if (extension == ".svg") return Format::svg;
    if (extension == ".dxf") return Format::dxf;
    for (const char* image :
         {".png", ".jpg", ".jpeg", ".tif", ".tiff", ".bmp", ".pgm", ".pnm", ".pbm", ".ppm"}) {
        if (extension == image) return Format::image;
    }
    return Format::other;
}

Format format_of_file(const model::InputFile& file) {
    std::array<char, kHeadBytes> bytes{};
    const std::span<char> head = std::span(bytes).first(
        static_cast<std::size_t>(std::min<std::uint64_t>(kHeadBytes, file.size_bytes())));
    if (!file.read(0, head)) return Format::other;
    return format_of({head.data(), head.size()}, file.path());
}

Result<Drawing> read_drawing(std::string_view text, Format format, const std::string& path, double scale) {
    return (format == Format::svg ? read_svg : read_dxf)(text, path, scale);
}

/// Extruded, or its lines engraved.
Result<model::Mesh> drawn(std::string_view text, Format format, const std::string& path,
                          const FlatOptions& options) {
    const auto drawing = read_drawing(text, format, path, options.scale);
    if (!drawing) return drawing.error();
    if (options.engraving) {
        auto grooves = grooves_of(*drawing, options, path);
        if (!grooves) return grooves.error();
        return engraved_body(std::make_shared<const Grooves>(std::move(*grooves)), drawing->format, path);
    }
    const auto outline = outline_of(*drawing, path);
    if (!outline) return outline.error();
    return prism_of(*outline, options.height_mm.value_or(kUsualHeight_mm), drawing->format, path);
}

Result<model::Mesh> wrapped(Bytes bytes, const std::string& path, const FlatOptions& options) {
    const auto image = read_image(bytes, path);
    if (!image) return image.error();
    const auto depths = depths_of(*image, options, path);
    if (!depths) return depths.error();
    return body_of(*depths, image->format, path);
}

Result<model::Mesh> load_flat(const model::InputFile& file, Format format, const FlatOptions& options) {
    const std::string& path = file.path();
    if (file.size_bytes() == 0) return bad_input(path + ": the file is empty");
    if (file.size_bytes() > kMostBytes) {
        return bad_input(path + ": more than 512 MiB, which no drawing or picture needs");
    }
    const auto bytes = file.read_all();
    if (!bytes) return bytes.error();
    auto mesh =
        format == Format::image
            ? wrapped({reinterpret_cast<const unsigned char*>(bytes->data()), bytes->size()}, path, options)
            : drawn({bytes->data(), bytes->size()}, format, path, options);
    if (!mesh) return mesh;
    mesh->body_json = flat_options_json(options);
    mesh->source_name = model::source_name_of(path);
    mesh->source_hash = XXH3_64bits(bytes->data(), bytes->size());
    return mesh;
}

}  // namespace

ModelKind kind_of_model(const std::string& path) {
    const auto file = model::InputFile::open(path);
    const Format format = file ? format_of_file(*file) : Format::other;
    if (format == Format::image) return ModelKind::picture;
    return format == Format::other ? ModelKind::mesh : ModelKind::drawing;
}

bool has_only_open_lines(const std::string& path) {
    const auto file = model::InputFile::open(path);
    const Format format = file ? format_of_file(*file) : Format::other;
    const bool is_drawing = format == Format::svg || format == Format::dxf;
    if (!is_drawing || file->size_bytes() > kMostBytes) return false;
    try {
        const auto text = file->read_all();
        if (!text) return false;
        const auto drawing = read_drawing({text->data(), text->size()}, format, path, FlatOptions{}.scale);
        return drawing && has_only_open_lines(*drawing);
    } catch (const std::bad_alloc&) {
        return false;
    }
}

Result<model::Mesh> load_model(const std::string& path, const FlatOptions& options) {
    const auto file = model::InputFile::open(path);
    const Format format = file ? format_of_file(*file) : Format::other;
    if (format == Format::other) return model::load_mesh(path);
    try {
        return load_flat(*file, format, options);
    } catch (const std::bad_alloc&) {
        return Error{ErrorCode::out_of_room, path + ": too large for this computer's memory"};
    }
}

}  // namespace psicarve::flat
