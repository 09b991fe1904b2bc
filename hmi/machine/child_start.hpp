// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

#include "shared/base/result.hpp"

namespace psicarve::machine {

/// A program to start. It reads nothing, has a process group of its own (Ctrl-C reaches only this process,
/// which tells the child to end), blocks no signal and handles each by default, whatever this process does
/// with its own.
struct ChildStart {
    std::vector<std::string> arguments;  ///< the first is the program's path
    int output = -1;                     ///< descriptor of its standard output
    std::optional<int> errors = {};      ///< descriptor of its standard error; nothing: ours
    std::vector<int> inherited = {};     ///< descriptors that it has under the same number
    bool has_own_session = false;        ///< no end of our terminal reaches it
};

/// ErrorCode::no_core when the system refuses.
Result<pid_t> start_child(const ChildStart& start);

}  // namespace psicarve::machine
