// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "hmi/model/three_mf_reader.hpp"
#include "tests/fuzz/mesh_fuzz.hpp"
#include "tests/hmi/model/mesh_files.hpp"

namespace {

/// An archive of these parts, divided by bytes 0, with the sums that it should have: else hardly one mutation
/// of the XML gets past these.
std::string archive_of(std::string_view parts) {
    psicarve::mesh_files::Zip zip;
    std::string name = "3D/3dmodel.model";
    for (int index = 1; index <= 4; ++index) {
        const std::size_t end = parts.find('\0');
        zip.add(name, std::string(parts.substr(0, end)));
        if (end == std::string_view::npos) break;
        parts.remove_prefix(end + 1);
        name = "3D/part" + std::to_string(index) + ".model";
    }
    return zip.bytes();
}

}  // namespace

/// A 3MF archive as it is, or the XML of its parts.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    std::string bytes(reinterpret_cast<const char*>(data), size);
    if (!bytes.starts_with("PK")) bytes = archive_of(bytes);
    psicarve::fuzz::require_mesh_or_refusal(
        {reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()}, &psicarve::model::read_3mf);
    return 0;
}
