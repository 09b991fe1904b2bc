// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace psicarve::model {

/// What a file is whose first bytes are these, when it is of a kind that programs save and that is not read
/// here, and what to do: "a GIF picture, which is not read; save it as PNG". Empty for others.
std::string_view foreign_kind(std::string_view head) noexcept;
/// The same; of others what can be read at all.
std::string why_not_read(std::string_view head);

}  // namespace psicarve::model
