// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/piece/piece_mesh.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>

#include "shared/file/atomic_file.hpp"

namespace psicarve::piece {
namespace {

using Vertex = std::array<float, 3>;
using Corners = std::array<std::uint32_t, 3>;
constexpr std::size_t kStlHeader = 80;

class Bytes {
public:
    template <typename T>
    void add(const T& value) {
        const std::size_t at = bytes_.size();
        bytes_.resize(at + sizeof value);
        std::memcpy(bytes_.data() + at, &value, sizeof value);
    }
    void add_text(std::string_view text) {
        for (const char c : text) add(c);
    }
    std::vector<std::byte> take() { return std::move(bytes_); }

private:
    std::vector<std::byte> bytes_;
};

struct PieceMesh {
    std::vector<Vertex> vertices;
    std::vector<Corners> facets;  ///< counter-clockwise, seen from outside
};

PieceMesh mesh_of(const StockMap& stock) {
    PieceMesh mesh;
    const auto columns = static_cast<std::uint32_t>(stock.column_count());
    const auto rows = static_cast<std::uint32_t>(stock.row_count());
    for (std::uint32_t row = 0; row < rows; ++row) {
        // The piece ends where its outer rows do, not in their middle.
        double height_mm = stock.height_mm(row);
        if (row == 0) height_mm -= 0.5 * stock.row_mm();
        if (row + 1 == rows) height_mm = stock.height_mm(row) + 0.5 * stock.row_mm();
        for (std::uint32_t column = 0; column < columns; ++column) {
            const double at_rad = stock.direction_rad(column);
            const double radius_mm = stock.row(row)[column];
            mesh.vertices.push_back({static_cast<float>(radius_mm * std::cos(at_rad)),
                                     static_cast<float>(radius_mm * std::sin(at_rad)),
                                     static_cast<float>(height_mm)});
        }
    }
    const auto bottom = static_cast<std::uint32_t>(mesh.vertices.size());
    const auto top = bottom + 1;
    mesh.vertices.push_back({0.0F, 0.0F, mesh.vertices.front()[2]});
    mesh.vertices.push_back({0.0F, 0.0F, mesh.vertices[bottom - 1][2]});
    for (std::uint32_t column = 0; column < columns; ++column) {
        const std::uint32_t next = (column + 1) % columns;
        mesh.facets.push_back({bottom, next, column});
        for (std::uint32_t low = 0; low + columns < bottom; low += columns) {
            mesh.facets.push_back({low + column, low + next, low + columns + next});
            mesh.facets.push_back({low + column, low + columns + next, low + columns + column});
        }
        mesh.facets.push_back({top, bottom - columns + column, bottom - columns + next});
    }
    return mesh;
}

std::vector<std::byte> stl_bytes(const PieceMesh& mesh) {
    Bytes bytes;
    std::array<char, kStlHeader> header{};
    std::memcpy(header.data(), "Psicarve: the carved piece, mm", 30);
    bytes.add(header);
    bytes.add(static_cast<std::uint32_t>(mesh.facets.size()));
    for (const Corners& corners : mesh.facets) {
        bytes.add(Vertex{});  // readers calculate the normal
        for (const std::uint32_t corner : corners) bytes.add(mesh.vertices[corner]);
        bytes.add(std::uint16_t{0});
    }
    return bytes.take();
}

std::vector<std::byte> ply_bytes(const PieceMesh& mesh) {
    Bytes bytes;
    bytes.add_text(
        "ply\nformat binary_little_endian 1.0\ncomment Psicarve: the carved piece, mm\nelement vertex " +
        std::to_string(mesh.vertices.size()) +
        "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
        std::to_string(mesh.facets.size()) + "\nproperty list uchar uint vertex_indices\nend_header\n");
    for (const Vertex& vertex : mesh.vertices) bytes.add(vertex);
    for (const Corners& corners : mesh.facets) {
        bytes.add(std::uint8_t{3});
        bytes.add(corners);
    }
    return bytes.take();
}

}  // namespace

std::vector<std::byte> mesh_bytes(const StockMap& stock, MeshFormat format) {
    const PieceMesh mesh = mesh_of(stock);
    return format == MeshFormat::stl ? stl_bytes(mesh) : ply_bytes(mesh);
}

Result<MeshFormat> mesh_format_of(const std::string& path) {
    if (path.ends_with(".stl") || path.ends_with(".STL")) return MeshFormat::stl;
    if (path.ends_with(".ply") || path.ends_with(".PLY")) return MeshFormat::ply;
    return bad_input(path + ": the piece is written as .stl or .ply");
}

Result<void> write_piece(const std::string& path, const StockMap& stock) {
    const auto format = mesh_format_of(path);
    if (!format) return format.error();
    return write_file_atomically(path, mesh_bytes(stock, *format));
}

}  // namespace psicarve::piece
