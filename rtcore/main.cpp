// SPDX-License-Identifier: GPL-3.0-or-later
#include <variant>

#include "rtcore/options/options.hpp"
#include "rtcore/supervisor/run_core.hpp"
#include "shared/computer/standard_descriptors.hpp"

int main(int argc, char** argv) {
    psicarve::keep_standard_descriptors_taken();
    const auto options = psicarve::supervisor::parse_options(argc, argv);
    if (const int* exit_code = std::get_if<int>(&options)) return *exit_code;
    return psicarve::supervisor::run_core(std::get<psicarve::supervisor::CoreOptions>(options));
}
