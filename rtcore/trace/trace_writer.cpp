// SPDX-License-Identifier: GPL-3.0-or-later
#include "rtcore/trace/trace_writer.hpp"

#include <utility>

#include "rtcore/trace/binary_writer.hpp"
#include "rtcore/trace/vcd_writer.hpp"
#include "shared/trace/trace_output.hpp"

namespace psicarve::trace {

Result<std::unique_ptr<TraceWriter>> open_trace(const std::string& path, const TraceStart& start) {
    Result<TraceOutput> out = TraceOutput::open(path);
    if (!out) return out.error();
    std::unique_ptr<TraceWriter> writer;
    if (path.ends_with(".vcd")) {
        writer = std::make_unique<VcdWriter>(std::move(*out), start);
    } else {
        writer = std::make_unique<BinaryWriter>(std::move(*out), start);
    }
    return writer;
}

}  // namespace psicarve::trace
