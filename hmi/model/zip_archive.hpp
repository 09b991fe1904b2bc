// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "shared/result.hpp"

struct zip;

namespace psicarve::model {

/// The parts of a zip archive that is in memory. Messages begin with the name of the file it came from.
class ZipArchive {
public:
    /// `bytes` outlive the archive.
    static Result<ZipArchive> open(std::span<const char> bytes, const std::string& file);

    /// Whether there is a part of this name; case does not count, nor does a leading '/'.
    bool has(const std::string& part) const;

    /// Unpacks a part piece by piece: its size, as the archive announces it, is never allocated.
    Result<void> read(const std::string& part,
                      const std::function<Result<void>(std::string_view piece)>& take) const;

    const std::string& file() const noexcept { return file_; }

private:
    struct Closer {
        void operator()(struct zip* archive) const noexcept;
    };
    ZipArchive(struct zip* archive, std::string file) : archive_(archive), file_(std::move(file)) {}

    std::unique_ptr<struct zip, Closer> archive_;
    std::string file_;
};

}  // namespace psicarve::model
