// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "hmi/gcode/interpreter.hpp"
#include "hmi/gcode/line_source.hpp"
#include "shared/base/result.hpp"
#include "shared/profile/profile.hpp"

namespace psicarve::verify {

/// A program's canonical motion, record by record, in constant memory: it is read by a thread of its own,
/// some records ahead. What the machine could not have run is wrong, as where the program is run.
class CanonStream {
public:
    /// Opens the program, at its begin.
    using Opener = std::function<Result<gcode::ProgramBytes>()>;

    CanonStream(const Opener& open, const gcode::InterpreterOptions& language, const Profile& profile);
    ~CanonStream();
    CanonStream(const CanonStream&) = delete;
    CanonStream& operator=(const CanonStream&) = delete;

    /// Nothing: there is none. Waits until it is read.
    std::optional<gcode::CanonRecord> next();
    /// Why the program could not be read to its end, or what is wrong with it. Before next() has nothing it
    /// may not be known yet.
    std::optional<Error> failure() const;

private:
    class Sink;
    void read(const Opener& open, const gcode::InterpreterOptions& language, const Profile& profile);
    bool put(std::vector<gcode::CanonRecord>& records);

    mutable std::mutex mutex_;
    std::condition_variable was_changed_;
    std::vector<gcode::CanonRecord> waiting_;  ///< under the mutex
    bool is_over_ = false;                     ///< under the mutex: nothing more comes
    bool is_given_up_ = false;                 ///< under the mutex: no more are taken
    std::optional<Error> failure_;             ///< under the mutex, before it is over
    std::vector<gcode::CanonRecord> taken_;
    std::size_t next_ = 0;
    std::thread thread_;
};

}  // namespace psicarve::verify
