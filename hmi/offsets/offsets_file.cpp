// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/offsets/offsets_file.hpp"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <span>
#include <system_error>

#include "shared/file/atomic_file.hpp"

namespace psicarve::offsets {
namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 20U;

}  // namespace

Result<Offsets> read_offsets(const OffsetsPlace& place, const GcodeProfile& letters) {
    std::error_code error;
    if (!place.is_kept() || (!std::filesystem::exists(place.path, error) && !error)) return Offsets{};
    if (::access(place.path.c_str(), R_OK) != 0 && errno == EACCES)
        return bad_input(place.path +
                         ": may not be read by this user; let the machine's group read it, or name another "
                         "folder: $PSICARVE_STATE");
    const auto bytes = read_file_start(place.path, kMostBytes);
    if (!bytes) return bytes.error();
    const std::string_view text{reinterpret_cast<const char*>(bytes->data()), bytes->size()};  // NOLINT
    auto read = offsets_from(text, letters);
    if (!read) return bad_input(place.path + ": " + read.error().message);
    return read;
}

Result<void> write_offsets(const OffsetsPlace& place, const Offsets& offsets, const GcodeProfile& letters) {
    const std::string text = text_of(offsets, letters);
    const auto read_back = offsets_from(text, letters);
    if (!read_back) return bad_input(place.path + ": these work offsets cannot be kept");
    const std::array<std::span<const std::byte>, 1> parts{std::as_bytes(std::span{text})};
    return write_parts_atomically(place.path, parts, FileRights{place.mode, std::nullopt});
}

std::string path_beside_trace(const std::string& trace_path) {
    return trace_path + ".offsets";
}

}  // namespace psicarve::offsets
