// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "shared/base/result.hpp"

struct zip;

namespace psicarve::model {

/// How many bytes an archive may unpack to in total. A few kilobytes can unpack to terabytes: beyond
/// `free_bytes` the limit is `most_ratio` times the archive's size, which models stay far below.
struct UnpackLimits {
    std::uint64_t most_bytes = std::uint64_t{4} << 30U;
    std::uint64_t free_bytes = std::uint64_t{64} << 20U;
    std::uint64_t most_ratio = 200;
};

/// The parts of a zip archive that is in memory. Messages begin with the name of the file it came from.
class ZipArchive {
public:
    /// `bytes` outlive the archive.
    static Result<ZipArchive> open(std::span<const char> bytes, const std::string& file,
                                   const UnpackLimits& limits = {});

    /// Whether there is a part of this name; case does not count, nor does a leading '/'.
    bool has(const std::string& part) const;

    /// Unpacks a part piece by piece: never allocates the size that the archive announces.
    Result<void> read(const std::string& part,
                      const std::function<Result<void>(std::string_view piece)>& take);

    const std::string& file() const noexcept { return file_; }

private:
    struct Closer {
        void operator()(struct zip* archive) const noexcept;
    };
    ZipArchive(struct zip* archive, std::string file, std::uint64_t most_unpacked_bytes)
        : archive_(archive), file_(std::move(file)), unpackable_bytes_(most_unpacked_bytes) {}

    std::optional<Error> refusal_of(std::uint64_t index, const std::string& part) const;

    std::unique_ptr<struct zip, Closer> archive_;
    std::string file_;
    std::uint64_t unpackable_bytes_;  ///< how much may still be unpacked
};

}  // namespace psicarve::model
