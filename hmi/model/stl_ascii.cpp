// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "hmi/model/file_bytes.hpp"
#include "hmi/model/indexed_mesh.hpp"
#include "hmi/model/mesh.hpp"
#include "hmi/model/mesh_check.hpp"
#include "hmi/model/stl_reader.hpp"
#include "hmi/model/text_scan.hpp"
#include "hmi/model/whole_file.hpp"
#include "shared/base/result.hpp"

namespace psicarve::model {
namespace {

class AsciiReader {
public:
    AsciiReader(std::string_view text, const std::string& path) : words_(text), path_(path) {}

    Result<Mesh> read() {
        for (std::string_view word = words_.next(); !word.empty(); word = words_.next()) {
            if (auto done = take(word); !done) return done.error();
        }
        if (in_facet_) return wrong("the file ends in the middle of a facet");
        mesh_.format = "ASCII STL";
        mesh_.facts = check_.facts(mesh_.origin);
        // Cut between two facets: the mesh itself shows whether anything is missing.
        if (in_solid_ && !mesh_.facts.closed) {
            return bad_input(path_ + ": truncated: it ends without endsolid, and the mesh has holes");
        }
        if (in_solid_) mesh_.warnings.emplace_back("the file ends without endsolid");
        return std::move(mesh_);
    }

private:
    Error wrong(const std::string& what) const {
        return bad_input(path_ + ": line " + std::to_string(words_.line()) + ": " + what);
    }

    Result<void> take(std::string_view word) {
        if (is_word(word, "vertex")) return take_vertex();
        if (is_word(word, "facet")) return begin_facet();
        if (is_word(word, "endfacet")) return end_facet();
        if (is_word(word, "outer") || is_word(word, "loop") || is_word(word, "endloop")) return {};
        if (is_word(word, "solid") || is_word(word, "endsolid")) {
            if (in_facet_) return wrong("a facet without endfacet");
            in_solid_ = is_word(word, "solid");
            return pass_name();
        }
        return wrong(quoted(word) + " is not a word of ASCII STL");
    }

    Result<void> begin_facet() {
        if (in_facet_) return wrong("a facet without endfacet");
        in_facet_ = true;
        vertex_count_ = 0;
        // Skips the normal: the vertices' order gives the same, and is more often right. Words behind it on
        // the same line count.
        for (std::string_view word = words_.next_in_line(); !word.empty(); word = words_.next_in_line())
            if (is_word(word, "outer") || is_word(word, "loop") || is_word(word, "vertex")) return take(word);
        return {};
    }

    /// A solid's name is what is left of its line, where that does not hold facets, too.
    Result<void> pass_name() {
        std::string_view before;
        for (std::string_view word = words_.next_in_line(); !word.empty(); word = words_.next_in_line()) {
            if (is_word(before, "facet") && is_word(word, "normal")) {
                in_solid_ = true;
                return begin_facet();
            }
            before = word;
        }
        return {};
    }

    Result<void> take_vertex() {
        if (!in_facet_ || vertex_count_ == 3) return wrong("a vertex too many");
        for (double& coordinate : facet_[vertex_count_]) {
            const std::string_view word = words_.next();
            const std::optional<double> value = number(word);
            if (!value) {
                return wrong(word.empty() ? "the file ends in the middle of a facet"
                                          : quoted(word) + " is not a number");
            }
            coordinate = *value;
        }
        ++vertex_count_;
        return {};
    }

    Result<void> end_facet() {
        if (!in_facet_ || vertex_count_ != 3) return wrong("a facet needs three vertices");
        in_facet_ = false;
        if (mesh_.triangles.empty()) mesh_.origin = origin_near(facet_[0]);
        Triangle triangle{};
        for (std::size_t v = 0; v < 3; ++v) {
            for (std::size_t k = 0; k < 3; ++k) {
                triangle.vertices[v][k] = static_cast<float>(facet_[v][k] - mesh_.origin[k]);
            }
        }
        check_.add_to(mesh_.triangles, triangle);
        return {};
    }

    Words words_;
    const std::string& path_;
    Mesh mesh_;
    MeshCheck check_;
    std::array<std::array<double, 3>, 3> facet_{};
    std::size_t vertex_count_ = 0;
    bool in_facet_ = false;
    bool in_solid_ = false;
};

}  // namespace

Result<Mesh> read_ascii_stl(const InputFile& file) {
    return read_whole<AsciiReader>(file);
}

}  // namespace psicarve::model
