// SPDX-License-Identifier: GPL-3.0-or-later
#include "common/dense/blas.hpp"

#include <dlfcn.h>

#include <cstdlib>
#include <memory>

namespace tokay {

namespace {

// A few hundredths of a second on one core.
constexpr double smallWork = 1e9;

template <class Function>
Function* blasFunction(const char* name) {
    return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

void setThreads(int nThreads) {
    static auto* const set = blasFunction<void(int)>("openblas_set_num_threads");
    set(nThreads);
}

// 1 if the library is another one
int nThreads() {
    static auto* const get = blasFunction<int()>("openblas_get_num_threads");
    return get ? get() : 1;
}

} // namespace

std::string blasLibrary() {
    void* symbol = dlsym(RTLD_DEFAULT, "dgemm_");
    Dl_info info;
    if (!symbol || !dladdr(symbol, &info)) {
        return "unknown";
    }
    std::unique_ptr<char, decltype(&std::free)> path(realpath(info.dli_fname, nullptr), &std::free);
    return path ? path.get() : info.dli_fname;
}

bool blasKnowsProcessor() {
    static auto* const kernels = blasFunction<char*()>("openblas_get_corename");
    return !(kernels && std::string(kernels()) == "Prescott" && __builtin_cpu_supports("avx2"));
}

BlasThreads::BlasThreads(double nOperations) {
    if (nOperations < smallWork && nThreads() > 1) {
        before_ = nThreads();
        setThreads(1);
    }
}

BlasThreads::~BlasThreads() {
    if (before_ > 0) {
        setThreads(before_);
    }
}

} // namespace tokay
