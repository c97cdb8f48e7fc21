// SPDX-License-Identifier: GPL-3.0-or-later
#include "timing.hpp"

#include <Eigen/Core>
#include <dlfcn.h>

extern "C" void dgemm_(const char*, const char*, const int*, const int*, const int*, const double*,
                       const double*, const int*, const double*, const int*, const double*, double*,
                       const int*);

namespace tokay::benchmarks {

double productRate() {
    const int n = 1000;
    const Eigen::MatrixXd a = Eigen::MatrixXd::Random(n, n);
    Eigen::MatrixXd c = Eigen::MatrixXd::Zero(n, n);
    const double one = 1;
    const Seconds seconds = bestSeconds(5, [&] {
        dgemm_("N", "N", &n, &n, &n, &one, a.data(), &n, a.data(), &n, &one, c.data(), &n);
    });
    return 2.0 * n * n * n / seconds.processor * 1e-9;
}

void setBlasThreads(int nThreads) {
    using Set = void (*)(int);
    if (const auto set = reinterpret_cast<Set>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads"))) {
        set(nThreads);
    }
}

} // namespace tokay::benchmarks
