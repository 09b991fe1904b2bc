// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace psicarve::model {

/// Names the kind of a file by its first bytes, when programs save that kind and it is not read here, and
/// says what to do: "a GIF picture, which is not read; save it as PNG". Empty for other files.
std::string_view foreign_kind(std::string_view head) noexcept;
/// The same; for other files, the kinds that can be read.
std::string why_not_read(std::string_view head);

}  // namespace psicarve::model
