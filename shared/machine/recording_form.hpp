// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace psicarve {

/// Value of the command `record`: recording.hpp, which the tick does not include, says how a recording goes.
/// RT: yes.
enum class RecordingForm : std::uint32_t {
    none = 0,    ///< end the recording with this token
    binary = 1,  ///< trace_format.hpp
    vcd = 2,
};
inline constexpr std::uint32_t kRecordingFormCount = 3;

}  // namespace psicarve
