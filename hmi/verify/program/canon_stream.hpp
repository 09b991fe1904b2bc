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

namespace psicarve::verify {

/// A program's canonical motion, record by record, in constant memory: it is read by a thread of its own,
/// some records ahead.
class CanonStream {
public:
    /// Opens the program, at its begin.
    using Opener = std::function<Result<gcode::ProgramBytes>()>;

    CanonStream(const Opener& open, const gcode::InterpreterOptions& language);
    ~CanonStream();
    CanonStream(const CanonStream&) = delete;
    CanonStream& operator=(const CanonStream&) = delete;

    /// Nothing: there is none. Waits until it is read.
    std::optional<gcode::CanonRecord> next();
    /// After next() had nothing: why the program could not be read to its end, or what is wrong with it.
    const std::optional<Error>& failure() const noexcept { return failure_; }

private:
    class Sink;
    void read(const Opener& open, const gcode::InterpreterOptions& language);
    bool put(std::vector<gcode::CanonRecord>& records);

    std::mutex mutex_;
    std::condition_variable was_changed_;
    std::vector<gcode::CanonRecord> waiting_;  ///< under the mutex
    bool is_over_ = false;                     ///< under the mutex: nothing more comes
    bool is_given_up_ = false;                 ///< under the mutex: nobody takes any more
    std::optional<Error> failure_;             ///< by the thread, before it is over
    std::vector<gcode::CanonRecord> taken_;
    std::size_t next_ = 0;
    std::thread thread_;
};

}  // namespace psicarve::verify
