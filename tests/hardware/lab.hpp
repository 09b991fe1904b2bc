// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/types.h>

#include <chrono>
#include <string>
#include <vector>

#include "tests/fake_port/fake_port_file.hpp"

namespace psicarve::hardware {

/// A PREEMPT_RT guest in QEMU whose parallel port is a fake one of the host's: the guest's kernel drives a
/// real port as far as it can tell, and every access to its registers arrives at the fake port.
class Lab {
public:
    /// Makes kernel and file system ready: `files` stand in the guest's root folder, and beside the project's
    /// own these programs of the host's; `init` is the guest's first. What went wrong, or nothing.
    std::string prepare(const std::string& folder, const std::vector<std::string>& files,
                        const std::string& init = "init.sh", const std::vector<std::string>& programs = {});

    /// Boots it. Guest time is counted instructions, so that a busy host loses no tick of it.
    void boot(const fake_port::FakePortFile& port);
    ~Lab();

    /// Everything on the guest's console until now.
    std::string console() const;
    /// False: the guest ended, or the time was over, without it.
    bool wait_for(const std::string& words, std::chrono::seconds limit);
    bool wait_for_end(std::chrono::seconds limit);

private:
    bool is_over();

    std::string folder_;
    pid_t qemu_ = -1;
};

}  // namespace psicarve::hardware
