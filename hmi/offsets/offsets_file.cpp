// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/offsets/offsets_file.hpp"

#include <array>
#include <filesystem>
#include <span>
#include <system_error>

#include "shared/file/atomic_file.hpp"

namespace psicarve::offsets {
namespace {

constexpr std::uint64_t kMostBytes = std::uint64_t{1} << 20U;

}  // namespace

const gcode::KeptOffsets& Offsets::begin_of(std::string_view program, bool is_from_line) const noexcept {
    const bool goes_on = is_from_line && unfinished && !program.empty() && unfinished->program == program;
    return goes_on ? unfinished->began_with : kept;
}

void carry_over(const gcode::KeptOffsets& before, const gcode::KeptOffsets& after, gcode::KeptOffsets& into) {
    for (std::size_t system = 0; system < gcode::kSystemCount; ++system) {
        const gcode::SystemOffset& from = before.systems[system];
        const gcode::SystemOffset& to = after.systems[system];
        for (std::size_t axis = 0; axis < gcode::kLetterCount; ++axis)
            if (from.origin[axis] != to.origin[axis]) into.systems[system].origin[axis] = to.origin[axis];
        if (from.rotation_deg != to.rotation_deg) into.systems[system].rotation_deg = to.rotation_deg;
    }
    for (std::size_t axis = 0; axis < gcode::kLetterCount; ++axis)
        if (before.shift[axis] != after.shift[axis]) into.shift[axis] = after.shift[axis];
    if (before.is_shifted != after.is_shifted) into.is_shifted = after.is_shifted;
    for (std::size_t which = 0; which < after.references.size(); ++which)
        if (before.references[which] != after.references[which])
            into.references[which] = after.references[which];
}

Result<Offsets> read_offsets(const OffsetsPlace& place, const GcodeProfile& letters) {
    std::error_code error;
    if (!place.is_kept() || (!std::filesystem::exists(place.path, error) && !error)) return Offsets{};
    const auto bytes = read_file_start(place.path, kMostBytes);
    if (!bytes) return bytes.error();
    const std::string_view text{reinterpret_cast<const char*>(bytes->data()), bytes->size()};  // NOLINT
    auto read = offsets_from(text, letters);
    if (!read) return bad_input(place.path + ": " + read.error().message);
    return read;
}

Result<void> write_offsets(const OffsetsPlace& place, const Offsets& offsets, const GcodeProfile& letters) {
    const std::string text = text_of(offsets, letters);
    const std::array<std::span<const std::byte>, 1> parts{std::as_bytes(std::span{text})};
    return write_parts_atomically(place.path, parts, FileRights{place.mode, std::nullopt});
}

std::string path_beside_trace(const std::string& trace_path) {
    return trace_path + ".offsets";
}

}  // namespace psicarve::offsets
