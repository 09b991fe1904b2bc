// SPDX-License-Identifier: GPL-3.0-or-later
// usage: fake_port_environment FOLDER PROFILE
// Puts a fake port with the profile's machine into the folder, and prints the environment, a line a variable,
// in which a program finds it at FOLDER/parport0.
#include <unistd.h>

#include <cstdio>
#include <set>
#include <string>

#include "shared/profile/profile.hpp"
#include "tests/fake_port/fake_port_file.hpp"

namespace {

std::set<std::string> variables() {
    std::set<std::string> all;
    for (char** variable = environ; *variable != nullptr; ++variable) all.insert(*variable);
    return all;
}

}  // namespace

int main(int count, char** words) {
    if (count != 3) return 2;
    const auto profile = psicarve::load_profile(words[2]);
    if (!profile) {
        std::fprintf(stderr, "fake_port_environment: %s\n", profile.error().message.c_str());
        return 1;
    }
    const std::set<std::string> before = variables();
    const psicarve::fake_port::FakePortFile port{words[1], *profile};
    const psicarve::fake_port::FakePortFile::Preload preload{port};
    for (const std::string& variable : variables()) {
        if (!before.contains(variable)) std::printf("%s\n", variable.c_str());
    }
    return 0;
}
