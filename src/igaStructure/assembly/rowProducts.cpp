// SPDX-License-Identifier: GPL-3.0-or-later
#include "igaStructure/assembly/rowProducts.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>

namespace tokay::structure {

namespace {

// Rows of the target in a tile of a product, and the most that a tile is wide.
constexpr int tileHeight = 6;
constexpr int tileWidth = 16;

// Vectors of N doubles at any address.
template <int N>
struct VectorOf;
template <>
struct VectorOf<2> {
    typedef double type __attribute__((vector_size(16), aligned(8), may_alias));
};
template <>
struct VectorOf<4> {
    typedef double type __attribute__((vector_size(32), aligned(8), may_alias));
};
template <>
struct VectorOf<8> {
    typedef double type __attribute__((vector_size(64), aligned(8), may_alias));
};

struct Product {
    const double* left;
    const double* right;
    double* target;
    int leftStride, rightStride, targetStride, nRows;
};

// One tile: nLines lines of the target, nWide vectors wide.
template <int N, int nLines, int nWide>
__attribute__((always_inline)) inline void addTile(const Product& product, int i, int j) {
    using Vector = typename VectorOf<N>::type;
    Vector sums[nLines][nWide] = {};
    for (int row = 0; row < product.nRows; ++row) {
        const double* left = product.left + static_cast<std::ptrdiff_t>(row) * product.leftStride;
        const double* right =
            product.right + static_cast<std::ptrdiff_t>(row) * product.rightStride + j;
        Vector values[nWide];
        for (int w = 0; w < nWide; ++w) {
            values[w] = *reinterpret_cast<const Vector*>(right + N * w);
        }
        for (int line = 0; line < nLines; ++line) {
            for (int w = 0; w < nWide; ++w) {
                sums[line][w] += left[i + line] * values[w];
            }
        }
    }
    for (int line = 0; line < nLines; ++line) {
        double* target =
            product.target + static_cast<std::ptrdiff_t>(i + line) * product.targetStride + j;
        for (int w = 0; w < nWide; ++w) {
            *reinterpret_cast<Vector*>(target + N * w) += sums[line][w];
        }
    }
}

template <int N, int nLines, int nWide>
__attribute__((always_inline)) inline void addTiles(const Product& product, int nFunctions,
                                                    int width) {
    constexpr int step = N * nWide;
    for (int i = 0; i < nFunctions; i += nLines) {
        for (int j = i / step * step; j < width; j += step) {
            addTile<N, nLines, nWide>(product, i, j);
        }
    }
}

struct Combination {
    const double* hessian;
    const double* functions;
    double* target;
    int functionsStride, targetStride, nFunctions, component;
};

template <int N, int nVectors>
__attribute__((always_inline)) inline void combine(const Combination& at) {
    using Vector = typename VectorOf<N>::type;
    constexpr int size = 3 * nVectors;
    for (int c = at.component; c < 3; ++c) {
        for (int k = 0; k < at.nFunctions; k += N) {
            Vector functions[nVectors];
            for (int s = 0; s < nVectors; ++s) {
                functions[s] =
                    *reinterpret_cast<const Vector*>(at.functions + s * at.functionsStride + k);
            }
            for (int r = 0; r < nVectors; ++r) {
                const double* factors = at.hessian + size * c + 3 * r + at.component;
                Vector sum = factors[0] * functions[0];
                for (int s = 1; s < nVectors; ++s) {
                    sum += factors[3 * size * s] * functions[s];
                }
                // What this writes beyond the end, the next component overwrites.
                *reinterpret_cast<Vector*>(at.target + r * at.targetStride + c * at.nFunctions +
                                           k) = sum;
            }
        }
    }
}

using AddTiles = void (*)(const Product&, int, int);
using Combine = void (*)(const Combination&);

void addTilesAnywhere(const Product& product, int nFunctions, int width) {
    addTiles<2, 2, 4>(product, nFunctions, width);
}
void combineTwoAnywhere(const Combination& at) {
    combine<2, 2>(at);
}
void combineThreeAnywhere(const Combination& at) {
    combine<2, 3>(at);
}
void combineFiveAnywhere(const Combination& at) {
    combine<2, 5>(at);
}

#if defined(__x86_64__)
__attribute__((target("avx2,fma"))) void addTilesAvx2(const Product& product, int nFunctions,
                                                      int width) {
    addTiles<4, 6, 2>(product, nFunctions, width);
}
__attribute__((target("avx2,fma"))) void combineTwoAvx2(const Combination& at) {
    combine<4, 2>(at);
}
__attribute__((target("avx2,fma"))) void combineThreeAvx2(const Combination& at) {
    combine<4, 3>(at);
}
__attribute__((target("avx2,fma"))) void combineFiveAvx2(const Combination& at) {
    combine<4, 5>(at);
}
__attribute__((target("avx512f,avx2,fma"))) void addTilesAvx512(const Product& product,
                                                                int nFunctions, int width) {
    addTiles<8, 6, 2>(product, nFunctions, width);
}
#endif

struct Kernels {
    AddTiles addTiles = addTilesAnywhere;
    Combine combineTwo = combineTwoAnywhere;
    Combine combineThree = combineThreeAnywhere;
    Combine combineFive = combineFiveAnywhere;

    Kernels() {
#if defined(__x86_64__)
        if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) {
            addTiles = __builtin_cpu_supports("avx512f") ? addTilesAvx512 : addTilesAvx2;
            combineTwo = combineTwoAvx2;
            combineThree = combineThreeAvx2;
            combineFive = combineFiveAvx2;
        }
#endif
    }
};

const Kernels& kernels() {
    static const Kernels chosen;
    return chosen;
}

} // namespace

PaddedRows::PaddedRows(int nRows, int nColumns)
    : stride_((nColumns + 2 * tileWidth - 1) / tileWidth * tileWidth),
      values_(static_cast<std::size_t>(nRows + tileHeight) * stride_, 0.0) {}

void PaddedRows::setZero() {
    std::fill(values_.begin(), values_.end(), 0.0);
}

void multiplyHessians(const std::vector<const double*>& hessians, const PaddedRows& functions,
                      int nVectors, int nFunctions, int component, PaddedRows& right) {
    assert(nVectors == 2 || nVectors == 3 || nVectors == 5);
    const Combine combine = nVectors == 2   ? kernels().combineTwo
                            : nVectors == 3 ? kernels().combineThree
                                            : kernels().combineFive;
    for (std::size_t point = 0; point < hessians.size(); ++point) {
        const int row = nVectors * static_cast<int>(point);
        combine({hessians[point], functions.row(row), right.row(row), functions.stride(),
                 right.stride(), nFunctions, component});
    }
}

void addProduct(const PaddedRows& functions, const PaddedRows& right, int nRows, int nFunctions,
                int component, PaddedRows& target) {
    const int offset = component * nFunctions;
    kernels().addTiles({functions.row(0), right.row(0) + offset, target.row(offset) + offset,
                        functions.stride(), right.stride(), target.stride(), nRows},
                       nFunctions, 3 * nFunctions - offset);
}

} // namespace tokay::structure
