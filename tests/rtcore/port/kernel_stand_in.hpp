// SPDX-License-Identifier: GPL-3.0-or-later
// The kernel's part of a port, before the C library's own: every process may access addresses, which nothing
// touches here, and every device answers as a port that the test plays. For one source file of a program.
#pragma once

#include <linux/parport.h>
#include <linux/ppdev.h>
#include <sys/ioctl.h>

#include <cstdarg>

namespace psicarve::port::test {

/// The test's: what the driver answers to everything but the question for the port's modes.
int answer_of_driver(unsigned long request) noexcept;

}  // namespace psicarve::port::test

extern "C" {
int ioperm(unsigned long /*from*/, unsigned long /*count*/, int /*on*/) noexcept {
    return 0;
}
int ioctl(int /*descriptor*/, unsigned long request, ...) noexcept {
    va_list list;
    va_start(list, request);
    void* const argument = va_arg(list, void*);
    va_end(list);
    if (request != PPGETMODES) return psicarve::port::test::answer_of_driver(request);
    *static_cast<unsigned*>(argument) = PARPORT_MODE_PCSPP;
    return 0;
}
}
