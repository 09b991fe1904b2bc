// SPDX-License-Identifier: GPL-3.0-or-later
#include "hmi/machine/pipe_verification.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <utility>

#include "hmi/trace/trace_reader.hpp"

namespace psicarve::machine {
namespace {

/// Reads to the pipe's end, so that a core that still writes is not ended by SIGPIPE.
void drain(int fd) {
    std::array<char, 65536> bytes;
    while (read(fd, bytes.data(), bytes.size()) > 0) {
    }
}

}  // namespace

Result<std::unique_ptr<PipeVerification>> PipeVerification::start(const JobView& job, const Profile& profile,
                                                                  UniqueFd read_end,
                                                                  verify::Verifier::Follower follower,
                                                                  const verify::AskedCarving& asked) {
    auto verifier = verify::Verifier::make_for(job, profile, asked);
    if (!verifier) return verifier.error();
    std::unique_ptr<PipeVerification> made{new PipeVerification{std::move(verifier).value()}};
    if (follower) {
        made->verifier_.set_follower(
            [self = made.get(), told = std::move(follower)](const auto& positions, bool spindle_on) {
                self->progress_.fetch_add(1, std::memory_order_relaxed);
                told(positions, spindle_on);
            });
    }
    made->thread_ =
        std::thread{[self = made.get(), fd = std::move(read_end)]() mutable { self->run(std::move(fd)); }};
    return made;
}

PipeVerification::~PipeVerification() {
    if (thread_.joinable()) thread_.join();
}

void PipeVerification::run(UniqueFd read_end) {
    UniqueFd kept{fcntl(read_end.get(), F_DUPFD_CLOEXEC, 0)};
    auto trace = verify::open_trace_fd(read_end.release(), "the core's trace");
    const auto goes_on = [this] {
        progress_.fetch_add(1, std::memory_order_relaxed);
        return true;
    };
    report_ = trace ? verify::verify_trace(verifier_, **trace, goes_on)
                    : Result<verify::VerifyReport>{trace.error()};
    drain(kept.get());
}

Result<verify::VerifyReport> PipeVerification::finish() {
    if (thread_.joinable()) thread_.join();
    if (!report_) return Error{ErrorCode::timed_out, "the core's trace was not read"};
    return *report_;
}

}  // namespace psicarve::machine
