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
#include "hmi/session/machine_view.hpp"

namespace psicarve::session {

enum class Severity : std::uint8_t { info, warning, alarm };

/// The place of an alarm in its core's flight recorder.
struct AlarmPlace {
    std::uint32_t core_pid = 0;
    std::uint64_t tick = 0;
};

/// The core whose journal has the message.
struct JournalPlace {
    std::uint64_t run = 0;  ///< counts the cores
    bool is_simulator = false;
};

struct Message {
    std::chrono::system_clock::time_point time;  ///< the epoch for a message from before: not known
    Severity severity = Severity::info;
    Phrase what;
    Phrase remedy;
    std::string axes{};  ///< the axes that it is about: "R2", "R1 R2"; else empty
    /// From before the window watched, and so no news: the bell does not ring.
    bool is_from_before = false;
    bool is_standing = false;  ///< an alarm that was latched when it was reported
    bool is_command = false;   ///< asked for here, or refused
    // For an alarm:
    Phrase cause{};               ///< more about the event and its cause
    std::vector<Phrase> steps{};  ///< all steps to take, `remedy` first
    std::optional<AlarmPlace> place{};
    std::optional<JournalPlace> journal{};  ///< of one that was read there
};

/// The changes of the machine between two looks at it, in the order of telling. For a core that is heard for
/// the first time also the alarms that it still has; none is reported twice.
std::vector<Message> changes_between(const MachineView& before, const MachineView& after);

/// The last messages, oldest first.
class MessageLog {
public:
    static constexpr std::size_t kMost = 2000;

    void add(Message message);
    void add(Severity severity, Phrase what, Phrase remedy = {});
    /// A message about an order given here.
    void add_command(Severity severity, Phrase what);
    const std::deque<Message>& messages() const noexcept { return messages_; }
    /// Grows with every message: shows whether a view is up to date.
    std::uint64_t count() const noexcept { return count_; }

private:
    std::deque<Message> messages_;
    std::uint64_t count_ = 0;
};

}  // namespace psicarve::session
