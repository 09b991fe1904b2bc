// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "hmi/phrase/phrase.hpp"
#include "hmi/session/machine_sight.hpp"

namespace psicarve::session {

enum class Severity : std::uint8_t { info, warning, alarm };

/// Where an alarm stands in its core's flight recorder.
struct AlarmPlace {
    std::uint32_t core_pid = 0;
    std::uint64_t tick = 0;
};

struct Message {
    std::chrono::system_clock::time_point time;  ///< the epoch of what is from before: not known
    Severity severity = Severity::info;
    Phrase what;
    Phrase remedy;
    std::string axes{};  ///< that it is of: "R2", "R1 R2"; else empty
    /// From before somebody watched, and so no news: nobody is called to it.
    bool is_from_before = false;
    bool is_standing = false;  ///< an alarm that was latched when it was told
    bool is_command = false;   ///< what was asked for here, or was refused
    // Of an alarm:
    Phrase cause{};               ///< more of what was, and why
    std::vector<Phrase> steps{};  ///< all that is to be done, `remedy` first
    std::optional<AlarmPlace> place{};
};

/// What became of the machine between two looks at it, in the order of telling. Of a core that is heard for
/// the first time also the alarms that it still knows; none is told twice.
std::vector<Message> changes_between(const MachineSight& before, const MachineSight& after);

/// The last messages, oldest first.
class MessageLog {
public:
    static constexpr std::size_t kMost = 2000;

    void add(Message message);
    void add(Severity severity, Phrase what, Phrase remedy = {});
    /// Of what was asked for here.
    void add_command(Severity severity, Phrase what);
    const std::deque<Message>& messages() const noexcept { return messages_; }
    /// Grows with every message: whether a view is up to date.
    std::uint64_t count() const noexcept { return count_; }

private:
    std::deque<Message> messages_;
    std::uint64_t count_ = 0;
};

}  // namespace psicarve::session
