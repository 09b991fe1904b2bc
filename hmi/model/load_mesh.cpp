// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/model/load_mesh.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "hmi/model/file_bytes.hpp"
#include "hmi/model/foreign_file.hpp"
#include "hmi/model/mesh.hpp"
#include "hmi/model/mesh_check.hpp"
#include "hmi/model/source_name.hpp"
#include "hmi/model/stl_reader.hpp"
#include "hmi/model/text_mesh_readers.hpp"
#include "hmi/model/text_scan.hpp"
#include "hmi/model/three_mf_reader.hpp"
#include "shared/base/result.hpp"

namespace psicarve::model {
namespace {

enum class Format { unknown, binary_stl, ascii_stl, obj, ply, three_mf, off };

constexpr std::size_t kHeadBytes = 1024;

std::string lower(std::string_view text) {
    std::string out(text);
    std::transform(out.begin(), out.end(), out.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return out;
}

bool is_text(std::string_view head) noexcept {
    return std::all_of(head.begin(), head.end(), [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte >= 0x20U ? byte != 0x7FU : (byte >= 0x09U && byte <= 0x0DU);
    });
}

/// Whether some line of the text begins as a vertex of an OBJ file does.
bool has_obj_vertex(std::string_view head) noexcept {
    return head.substr(0, 2) == "v " || head.find("\nv ") != std::string_view::npos;
}

bool is_off(std::string_view lower_head) noexcept {
    while (!lower_head.empty() && lower_head.front() == '#') {
        lower_head.remove_prefix(std::min(lower_head.find_first_of("\r\n"), lower_head.size()));
        lower_head.remove_prefix(std::min(lower_head.find_first_not_of(" \t\r\n"), lower_head.size()));
    }
    const std::size_t end = lower_head.find_first_of(" \t\r\n");
    std::string_view word = lower_head.substr(0, end);
    if (word.size() < 3 || word.substr(word.size() - 3) != "off") return false;
    word.remove_suffix(3);
    return word.size() <= 4 && word.find_first_not_of("stcn4") == std::string_view::npos;
}

Format format_by_content(std::string_view head, std::uint64_t size_bytes) {
    if (head.size() >= kStlHeaderBytes &&
        is_exact_binary_stl(std::span(head.data(), head.size()), size_bytes)) {
        return Format::binary_stl;
    }
    if (head.substr(0, 4) == "PK\x03\x04") return Format::three_mf;
    head = without_byte_order_mark(head);
    std::string start = lower(head);
    start.erase(0, std::min(start.find_first_not_of(" \t\r\n"), start.size()));
    if (start.rfind("ply\n", 0) == 0 || start.rfind("ply\r", 0) == 0) return Format::ply;
    if (!is_text(head)) return Format::unknown;
    if (start.rfind("solid", 0) == 0) return Format::ascii_stl;
    if (is_off(start)) return Format::off;
    return has_obj_vertex(head) ? Format::obj : Format::unknown;
}

Format format_by_extension(const std::string& path) {
    const std::string extension = lower(std::filesystem::path(path).extension().string());
    if (extension == ".stl") return Format::binary_stl;
    if (extension == ".obj") return Format::obj;
    if (extension == ".ply") return Format::ply;
    if (extension == ".3mf") return Format::three_mf;
    if (extension == ".off") return Format::off;
    return Format::unknown;
}

Result<Mesh> read_as(Format format, const InputFile& file) {
    switch (format) {
        case Format::binary_stl:
            return read_binary_stl(file);
        case Format::ascii_stl:
            return read_ascii_stl(file);
        case Format::obj:
            return read_obj(file);
        case Format::ply:
            return read_ply(file);
        case Format::three_mf:
            return read_3mf(file);
        case Format::off:
        case Format::unknown:
            break;
    }
    return read_off(file);
}

/// Decides by the content, then by the extension; refuses a file that fits neither.
Result<Format> known_format(const InputFile& file) {
    if (file.size_bytes() == 0) return bad_input(file.path() + ": the file is empty");
    std::array<char, kHeadBytes> bytes{};
    const std::span<char> head = std::span(bytes).first(
        static_cast<std::size_t>(std::min<std::uint64_t>(kHeadBytes, file.size_bytes())));
    if (auto done = file.read(0, head); !done) return done.error();
    Format format = format_by_content({head.data(), head.size()}, file.size_bytes());
    if (format == Format::unknown) format = format_by_extension(file.path());
    if (format != Format::unknown) return format;
    return bad_input(file.path() + ": " + why_not_read({head.data(), head.size()}));
}

}  // namespace

Result<void> check_is_mesh(const std::string& path) {
    const Result<InputFile> file = InputFile::open(path);
    if (!file) return file.error();
    const Result<Format> format = known_format(*file);
    return format ? Result<void>{} : format.error();
}

Result<Mesh> load_mesh(const std::string& path) {
    const Result<InputFile> file = InputFile::open(path);
    if (!file) return file.error();
    const Result<Format> format = known_format(*file);
    if (!format) return format.error();
    Result<Mesh> mesh = read_as(*format, *file);
    if (!mesh) return mesh.error();
    mesh->source_name = source_name_of(path);
    if (auto good = judge_mesh(*mesh, path); !good) return good.error();
    return mesh;
}

}  // namespace psicarve::model
