// SPDX-License-Identifier: GPL-3.0-or-later
#include "shared/computer/kernel_ports.hpp"

#include <grp.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <string>

#include "shared/computer/raw_access.hpp"

namespace psicarve {
namespace {

class KernelPorts : public testing::Test {
protected:
    KernelPorts() { std::filesystem::remove_all(proc_); }
    ~KernelPorts() override { std::filesystem::remove_all(proc_); }
    void put(const std::string& path, const std::string& text) const {
        std::filesystem::create_directories(std::filesystem::path{proc_ + path}.parent_path());
        std::ofstream{proc_ + path} << text;
    }
    std::string proc_ = testing::TempDir() + "psicarve-proc-" + std::to_string(::getpid());
};

TEST_F(KernelPorts, AreReadAsTheKernelListsThem) {
    EXPECT_TRUE(kernel_ports(proc_).empty());
    put("/sys/dev/parport/default/timeslice", "200\n");
    put("/sys/dev/parport/parport1/base-addr", "632\t0\n");
    put("/sys/dev/parport/parport1/devices/active", "none\n");
    put("/sys/dev/parport/parport0/base-addr", "53248\t53256\n");
    put("/sys/dev/parport/parport0/devices/active", "ppdev0\n");
    const auto ports = kernel_ports(proc_);
    ASSERT_EQ(ports.size(), 2U);
    EXPECT_EQ(ports[0].name, "parport0");
    EXPECT_EQ(ports[0].base, 0xd000);
    EXPECT_EQ(ports[0].extended_base, 0xd008);
    EXPECT_EQ(ports[0].holder, "ppdev0");
    EXPECT_EQ(ports[1].base, 0x278);
    EXPECT_EQ(ports[1].extended_base, 0);
    EXPECT_EQ(ports[1].holder, "");
}

TEST_F(KernelPorts, AFilesGroupIsNamed) {
    put("/file", "");
    const std::string path = proc_ + "/file";
    struct stat facts {};
    ASSERT_EQ(::stat(path.c_str(), &facts), 0);
    EXPECT_EQ(group_of(path), ::getgrgid(facts.st_gid)->gr_name);
    EXPECT_EQ(group_of(proc_ + "/nothing"), "");
}

TEST(RawAccess, IsRefusedWithWhatHelpsAndNothingThatDoesNot) {
    EXPECT_NE(raw_refusal(EPERM, false).remedy.find("CAP_SYS_RAWIO"), std::string::npos);
    const RawRefusal locked_down = raw_refusal(EPERM, true);
    EXPECT_NE(locked_down.reason.find("locked down"), std::string::npos) << locked_down.reason;
    EXPECT_EQ(locked_down.remedy.find("CAP_SYS_RAWIO"), std::string::npos) << "it has it";
    EXPECT_EQ(raw_refusal(ENOSYS, true).reason, "this kernel lets nobody at addresses");
    EXPECT_NE(raw_refusal(EINVAL, true).reason.find("Invalid argument"), std::string::npos);
}

TEST_F(KernelPorts, ThePrinterDriverIsFoundByItsWholeName) {
    put("/modules", "lpfc 1 0 - Live 0x0\nparport 2 3 ppdev,lp,parport_pc, Live 0x0\n");
    EXPECT_FALSE(is_lp_loaded(proc_));
    put("/modules", "ppdev 1 0 - Live 0x0\nlp 20480 0 - Live 0x0\n");
    EXPECT_TRUE(is_lp_loaded(proc_));
}

}  // namespace
}  // namespace psicarve
