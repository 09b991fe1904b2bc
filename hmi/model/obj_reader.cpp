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

class ObjReader {
public:
    ObjReader(std::string_view text, const std::string& path) : words_(text), path_(path) {}

    Result<Mesh> read() {
        for (; !words_.at_end(); words_.skip_line()) {
            const std::string_view word = words_.next_in_line();
            Result<void> done;
            if (word == "v") done = take_point();
            if (word == "f") done = take_face();
            if (!done) return done.error();
        }
        return mesh_.finish("OBJ");
    }

private:
    Error wrong(const std::string& what) const {
        return bad_input(path_ + ": line " + std::to_string(words_.line()) + ": " + what);
    }

    Result<void> take_point() {
        std::array<double, 3> point{};
        for (double& coordinate : point) {
            const std::string_view word = words_.next_in_line();
            const std::optional<double> value = number(word);
            if (!value) return wrong(quoted(word) + " is not a number: a vertex needs three");
            coordinate = *value;
        }
        mesh_.add_point(point);
        return {};
    }

    /// "f 1/2/3 4//5 -1": points count from 1, or from the latest backwards.
    Result<void> take_face() {
        corners_.clear();
        for (std::string_view word = words_.next_in_line(); !word.empty(); word = words_.next_in_line()) {
            if (word == "\\") {  // the face goes on in the next line
                words_.skip_line();
                continue;
            }
            const auto index = whole_number(word.substr(0, word.find('/')));
            if (!index || *index == 0) return wrong(quoted(word) + " is not the number of a vertex");
            const auto count = static_cast<long long>(mesh_.point_count());
            corners_.push_back(static_cast<std::uint64_t>(*index > 0 ? *index - 1 : count + *index));
        }
        if (corners_.size() < 3) return wrong("a face needs at least three vertices");
        if (!mesh_.add_polygon(corners_)) return wrong("the face names a vertex that is not there");
        return {};
    }

    Words words_;
    const std::string& path_;
    IndexedMesh mesh_;
    std::vector<std::uint64_t> corners_;
};

}  // namespace

Result<Mesh> read_obj(const InputFile& file) {
    return read_whole<ObjReader>(file);
}

}  // namespace psicarve::model
