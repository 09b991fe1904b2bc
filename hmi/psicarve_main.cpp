// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstdio>
#include <exception>

#include "hmi/cli/program.hpp"
#include "shared/base/printable.hpp"
#include "shared/computer/standard_descriptors.hpp"

int main(int argc, char** argv) {
    psicarve::keep_standard_descriptors_taken();
    psicarve::close_writing_ends_of_standard_input();
    try {
        return psicarve::cli::run(argc, argv);
    } catch (const std::exception& error) {
        // Only unforeseeable failures get here: above all, a lack of memory.
        std::fprintf(stderr, "psicarve: %s\n", psicarve::printable(error.what()).c_str());
        return 3;
    }
}
