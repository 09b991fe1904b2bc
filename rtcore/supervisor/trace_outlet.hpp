// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "rtcore/trace/trace_entry.hpp"
#include "rtcore/trace/trace_writer.hpp"
#include "shared/result.hpp"

namespace psicarve::supervisor {

/// All traces of a run: empties the tick's ring into each. One thread's; may block on a disk or pipe.
class TraceOutlet {
public:
    Result<void> open(const std::vector<std::string>& paths, const trace::TraceStart& start);
    bool is_open() const noexcept { return !writers_.empty(); }

    /// Everything the ring holds now.
    void drain(trace::TraceRing& ring);
    void flush();
    void finish(std::uint64_t end_tick);
    /// Writing failed since the last call: one line for each trace that did, the first time only.
    std::vector<std::string> take_errors();

private:
    struct Named {
        std::string path;
        std::unique_ptr<trace::TraceWriter> writer;
    };
    std::vector<Named> writers_;
};

}  // namespace psicarve::supervisor
