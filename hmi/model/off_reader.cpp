// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hmi/model/file_bytes.hpp"
#include "hmi/model/indexed_mesh.hpp"
#include "hmi/model/mesh.hpp"
#include "hmi/model/text_mesh_readers.hpp"
#include "hmi/model/text_scan.hpp"
#include "hmi/model/whole_file.hpp"
#include "shared/base/result.hpp"

namespace psicarve::model {
namespace {

class OffReader {
public:
    OffReader(std::string_view text, const std::string& path) : words_(text), path_(path) {}

    Result<Mesh> read() {
        std::string_view first = next();
        if (!whole_number(first)) {  // the word OFF may be missing
            if (first.find_first_of("4n") != std::string_view::npos)
                return wrong("OFF in other than 3 dimensions");
            first = next();
            if (is_word(first, "binary")) return wrong("OFF that is binary; save it as text");
        }
        const auto points = count_from(first, "vertices");
        if (!points) return points.error();
        const auto faces = count_of("faces");
        if (!faces) return faces.error();
        words_.skip_line();  // the count of edges, which programs leave 0
        for (std::uint64_t i = 0; i < *points; ++i) {
            if (auto done = take_point(i, *points); !done) return done.error();
        }
        for (std::uint64_t i = 0; i < *faces; ++i) {
            if (auto done = take_face(i, *faces); !done) return done.error();
        }
        return mesh_.finish("OFF");
    }

private:
    Error wrong(const std::string& what) const {
        return bad_input(path_ + ": line " + std::to_string(words_.line()) + ": " + what);
    }
    Error truncated(const char* kind, std::uint64_t have, std::uint64_t wanted) const {
        return bad_input(path_ + ": truncated: " + std::to_string(have) + " of " + std::to_string(wanted) +
                         " " + kind + " are there");
    }

    /// The next word that is not in a comment.
    std::string_view next() {
        std::string_view word = words_.next();
        while (!word.empty() && word.front() == '#') {
            words_.skip_line();
            word = words_.next();
        }
        return word;
    }

    Result<std::uint64_t> count_of(const char* kind) { return count_from(next(), kind); }
    Result<std::uint64_t> count_from(std::string_view word, const char* kind) const {
        const auto count = whole_number(word);
        if (!count || *count < 0) return wrong(quoted(word) + " is not a number of " + kind);
        return static_cast<std::uint64_t>(*count);
    }

    Result<void> take_point(std::uint64_t have, std::uint64_t wanted) {
        std::array<double, 3> point{};
        for (double& coordinate : point) {
            const std::string_view word = next();
            if (word.empty()) return truncated("vertices", have, wanted);
            const std::optional<double> value = number(word);
            if (!value) return wrong(quoted(word) + " is not a number");
            coordinate = *value;
        }
        words_.skip_line();  // a normal or a colour
        mesh_.add_point(point);
        return {};
    }

    Result<void> take_face(std::uint64_t have, std::uint64_t wanted) {
        const std::string_view word = next();
        if (word.empty()) return truncated("faces", have, wanted);
        const auto count = whole_number(word);
        if (!count || *count < 0) return wrong(quoted(word) + " is not a number of corners");
        corners_.clear();
        for (long long i = 0; i < *count; ++i) {
            const std::string_view corner = next();
            if (corner.empty()) return truncated("faces", have, wanted);
            const auto index = whole_number(corner);
            if (!index || *index < 0) return wrong(quoted(corner) + " is not the number of a vertex");
            corners_.push_back(static_cast<std::uint64_t>(*index));
        }
        words_.skip_line();  // a colour
        if (!mesh_.add_polygon(corners_)) return wrong("the face names a vertex that is not there");
        return {};
    }

    Words words_;
    const std::string& path_;
    IndexedMesh mesh_;
    std::vector<std::uint64_t> corners_;
};

}  // namespace

Result<Mesh> read_off(const InputFile& file) {
    return read_whole<OffReader>(file);
}

}  // namespace psicarve::model
