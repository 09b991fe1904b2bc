// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unistd.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include "hmi/model/mesh.hpp"

/// Mesh files made by the tests themselves.
namespace psicarve::mesh_files {

/// A folder that goes away with the test.
class Folder {
public:
    Folder() {
        std::string name = (std::filesystem::temp_directory_path() / "psicarve-test-XXXXXX").string();
        path_ = ::mkdtemp(name.data());
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    const std::filesystem::path& path() const { return path_; }

    std::string write(const std::string& name, const std::string& bytes) const {
        const std::filesystem::path file = path_ / name;
        std::ofstream(file, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        return file.string();
    }

private:
    std::filesystem::path path_;
};

inline std::string little_endian(std::uint32_t value, int bytes = 4) {
    std::string out;
    for (int i = 0; i < bytes; ++i) out += static_cast<char>((value >> (8 * i)) & 0xFFU);
    return out;
}

inline std::string binary_stl(const model::Mesh& mesh, std::uint32_t count, std::string header = "") {
    header.resize(80);
    std::string out = header + little_endian(count);
    for (const model::Triangle& t : mesh.triangles) {
        std::array<char, 50> facet{};
        std::memcpy(facet.data() + 12, &t, sizeof(t));
        out.append(facet.data(), facet.size());
    }
    return out;
}
inline std::string binary_stl(const model::Mesh& mesh) {
    return binary_stl(mesh, static_cast<std::uint32_t>(mesh.triangles.size()));
}

inline std::string text_of(double value) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.9g", value);
    return text.data();
}

/// `shift` is added to every x in double.
inline std::string ascii_stl(const model::Mesh& mesh, double shift = 0.0) {
    std::string out = "solid a name of several words\n";
    for (const model::Triangle& t : mesh.triangles) {
        out += "  facet normal 0 0 0\n    outer loop\n";
        for (const auto& v : t.vertices) {
            std::array<char, 120> line{};
            std::snprintf(line.data(), line.size(), "      vertex %.12g %.9g %.9g\n", double{v[0]} + shift,
                          double{v[1]}, double{v[2]});
            out += line.data();
        }
        out += "    endloop\n  endfacet\n";
    }
    return out + "endsolid\n";
}

inline std::string point_line(const std::array<float, 3>& v) {
    return text_of(double{v[0]}) + " " + text_of(double{v[1]}) + " " + text_of(double{v[2]}) + "\n";
}

inline std::string obj(const model::Mesh& mesh) {
    std::string out = "# a comment\nmtllib nowhere.mtl\no thing\n";
    for (const auto& t : mesh.triangles) {
        for (const auto& v : t.vertices) out += "v " + point_line(v);
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        out += "f " + std::to_string(3 * i + 1) + " " + std::to_string(3 * i + 2) + " " +
               std::to_string(3 * i + 3) + "\n";
    }
    return out;
}

/// The body of a PLY or OFF file: points, then facets.
inline std::string points_and_facets(const model::Mesh& mesh) {
    std::string out;
    for (const auto& t : mesh.triangles) {
        for (const auto& v : t.vertices) out += point_line(v);
    }
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        out += "3 " + std::to_string(3 * i) + " " + std::to_string(3 * i + 1) + " " +
               std::to_string(3 * i + 2) + "\n";
    }
    return out;
}

inline std::string ply(const model::Mesh& mesh) {
    const std::string facets = std::to_string(mesh.triangles.size());
    const std::string points = std::to_string(3 * mesh.triangles.size());
    return "ply\nformat ascii 1.0\nelement vertex " + points +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " + facets +
           "\nproperty list uchar int vertex_indices\nend_header\n" + points_and_facets(mesh);
}

inline std::string binary_ply(const model::Mesh& mesh, bool big_endian) {
    std::string out =
        "ply\nformat binary_" + std::string(big_endian ? "big" : "little") +
        "_endian 1.0\ncomment by a test\nelement vertex " + std::to_string(3 * mesh.triangles.size()) +
        "\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nelement face " +
        std::to_string(mesh.triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n";
    const auto put = [&out, big_endian](std::uint32_t value) {
        std::string bytes = little_endian(value);
        if (big_endian) bytes = {bytes[3], bytes[2], bytes[1], bytes[0]};
        out += bytes;
    };
    for (const auto& t : mesh.triangles) {
        for (const auto& v : t.vertices) {
            for (const float c : v) put(std::bit_cast<std::uint32_t>(c));
            out += '\x7f';
        }
    }
    for (std::uint32_t i = 0; i < 3 * mesh.triangles.size(); i += 3) {
        out += '\3';
        for (std::uint32_t k = 0; k < 3; ++k) put(i + k);
    }
    return out;
}

inline std::string off(const model::Mesh& mesh) {
    return "OFF\n" + std::to_string(3 * mesh.triangles.size()) + " " + std::to_string(mesh.triangles.size()) +
           " 0\n" + points_and_facets(mesh);
}

inline std::uint32_t crc32(const std::string& bytes) {
    std::uint32_t crc = 0xFFFFFFFFU;
    for (const char c : bytes) {
        crc ^= static_cast<unsigned char>(c);
        for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xEDB88320U : 0U);
    }
    return ~crc;
}

/// A ZIP archive, whose parts stand in it as they are unless another method and size are claimed.
class Zip {
public:
    struct Claim {
        std::uint32_t method = 0;
        std::uint32_t flags = 0;  ///< 1: encrypted
        std::uint32_t unpacked_bytes = 0;
        std::uint32_t crc = 0;
    };
    void add(const std::string& name, const std::string& bytes) {
        add(name, bytes, {0, 0, static_cast<std::uint32_t>(bytes.size()), crc32(bytes)});
    }
    void add(const std::string& name, const std::string& packed, const Claim& claim) {
        const auto size = static_cast<std::uint32_t>(packed.size());
        const std::string what =
            little_endian(20, 2) + little_endian(claim.flags, 2) + little_endian(claim.method, 2) +
            little_endian(0) + little_endian(claim.crc) + little_endian(size) +
            little_endian(claim.unpacked_bytes) + little_endian(static_cast<std::uint32_t>(name.size()), 2) +
            little_endian(0, 2);
        directory_ += "PK\x01\x02" + little_endian(20, 2) + what + little_endian(0, 2) + little_endian(0, 2) +
                      little_endian(0, 2) + little_endian(0) +
                      little_endian(static_cast<std::uint32_t>(files_.size())) + name;
        files_ += "PK\x03\x04" + what + name + packed;
        ++count_;
    }
    std::string bytes() const {
        return files_ + directory_ + "PK\x05\x06" + little_endian(0) + little_endian(count_, 2) +
               little_endian(count_, 2) + little_endian(static_cast<std::uint32_t>(directory_.size())) +
               little_endian(static_cast<std::uint32_t>(files_.size())) + little_endian(0, 2);
    }

private:
    std::string files_;
    std::string directory_;
    std::uint32_t count_ = 0;
};

}  // namespace psicarve::mesh_files
