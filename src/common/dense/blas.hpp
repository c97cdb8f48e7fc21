// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace tokay {

/// Path of the library that does the dense products: OpenBLAS or a slower one.
std::string blasLibrary();

/// True if OpenBLAS knows this processor, if it is the library: else it takes the
/// kernels of the first ones with 64 bits, which are several times slower.
bool blasKnowsProcessor();

/// Keeps OpenBLAS to one thread while it lives, if the work is small: waking and
/// awaiting others then costs more than it brings, above all on a machine that
/// the fluid keeps busy.
class BlasThreads {
  public:
    /// @param nOperations  floating-point operations of the work
    explicit BlasThreads(double nOperations);
    ~BlasThreads();
    BlasThreads(const BlasThreads&) = delete;
    BlasThreads& operator=(const BlasThreads&) = delete;

  private:
    int before_ = 0; ///< threads to go back to; 0: nothing was changed
};

} // namespace tokay
